#include "tally/decay.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace photic::tally {
namespace {

/// A share of a score below the resolution of a double.
constexpr double nothing = 1e-17;

}  // namespace

Decay::Decay(double lifetime_ns, const Gates& gates)
    : first_path_(gates.edge_path(0)), last_path_(gates.last_path()) {
  per_metre_ = 1 / (lifetime_ns * metre_per_nanosecond);
  if (!std::isfinite(per_metre_)) return;
  for (std::int32_t gate = 0; gate < gates.count(); ++gate) {
    const double lifetimes = (gates.edge_path(gate + 1) - gates.edge_path(gate)) * per_metre_;
    stays_.push_back(std::exp(-lifetimes));
    leaves_.push_back(-std::expm1(-lifetimes));
  }
}

void Decay::spread(double path, const Gates& gates, std::vector<GateShare>& out) const {
  out.clear();
  double stays = 0;
  std::int32_t gate = gates.find(path);
  // In no gate, but for rounding before the first one or after the last.
  if (gate < 0 && !(path - first_path_ < last_path_ - path)) return;
  if (gate >= 0) {
    const double to_end = std::max(0.0, gates.edge_path(gate + 1) - path) * per_metre_;
    out.push_back({gate, -std::expm1(-to_end)});
    stays = std::exp(-to_end);
    ++gate;
  } else {
    stays = std::exp(-std::max(0.0, first_path_ - path) * per_metre_);
    gate = 0;
  }
  for (; gate < gates.count() && stays > nothing; ++gate) {
    const auto i = static_cast<std::size_t>(gate);
    out.push_back({gate, stays * leaves_[i]});
    stays *= stays_[i];
  }
}

}  // namespace photic::tally
