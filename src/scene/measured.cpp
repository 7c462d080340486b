#include "scene/measured.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace photic::scene {
namespace {

/// The likely meaning of a value that is refused.
std::string remedy(const Number& rule, double value) {
  return rule.low == 0 && value < 0 ? "negative = \"zero\" counts values below 0 as 0" : "";
}

std::vector<std::size_t> order_of(const std::vector<double>& depth) {
  std::vector<std::size_t> order(depth.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return depth[a] < depth[b]; });
  return order;
}

/// Returns whether depths that go one way leap back by more than half of all of them, and then go
/// the same way again: two casts do so, the way down and up does not.
bool starts_over(const std::vector<double>& depth, double sign) {
  const auto [least, most] = std::ranges::minmax(depth);
  bool goes = false, leapt = false;
  for (std::size_t k = 1; k < depth.size(); ++k) {
    const double step = sign * (depth[k] - depth[k - 1]);
    if (step > 0 && leapt) return true;
    goes = goes || step > 0;
    leapt = leapt || (goes && -step > (most - least) / 2);
  }
  return false;
}

}  // namespace

void zero_negatives(Measured& measured, std::vector<std::string>& remarks) {
  double least = 0;
  std::size_t count = 0;
  for (double& x : measured.value) {
    if (!(x < 0)) continue;
    least = std::min(least, x);
    x = 0;
    ++count;
  }
  if (count > 0)
    remarks.push_back(fmt::format(
        "{} of {} values of {} are below 0, the smallest of them {:.4g}, and count as 0", count,
        measured.value.size(), measured.name, least));
}

void check_values(const Measured& measured, const Number& rule, const RefuseLevel& refuse) {
  for (std::size_t k = 0; k < measured.value.size(); ++k) {
    double checked = 0;
    const double value = measured.value[k];
    if (auto refusal = check(rule, to_node(value), checked)) {
      if (refusal->suggestion.empty()) refusal->suggestion = remedy(rule, value);
      refuse(measured.level[k], *refusal);
    }
  }
}

void put_in_order(Measured& measured, std::vector<std::string>& remarks) {
  const auto& depth = measured.depth_m;
  if (!std::is_sorted(depth.begin(), depth.end()))
    remarks.push_back(fmt::format(
        "{} do not ascend in {}, and have been sorted{}", measured.levels, measured.depth_name,
        starts_over(depth, 1) || starts_over(depth, -1)
            ? ", as if all were of one cast, although they start over like those of several"
            : ""));
  Measured ordered{measured.levels, measured.depth_name, measured.name, {}, {}, {}};
  std::optional<double> first_shared;
  double alike = 0;  // levels of the last depth
  for (const std::size_t k : order_of(depth)) {
    if (ordered.depth_m.empty() || depth[k] > ordered.depth_m.back()) {
      ordered.depth_m.push_back(depth[k]);
      ordered.value.push_back(measured.value[k]);
      alike = 1;
    } else {
      alike += 1;
      ordered.value.back() += (measured.value[k] - ordered.value.back()) / alike;
      if (!first_shared) first_shared = depth[k];
    }
  }
  if (first_shared)
    remarks.push_back(
        fmt::format("{} of {} {} are at the depth of another one, the first at {:.4g} m: they are "
                    "merged into one, with the mean of {}",
                    depth.size() - ordered.depth_m.size(), depth.size(), measured.levels,
                    *first_shared, measured.name));
  measured = std::move(ordered);
}

}  // namespace photic::scene
