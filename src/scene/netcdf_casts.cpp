#include "scene/netcdf_casts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "scene/suggest.hpp"

namespace photic::scene {
namespace {

/// The depths of some values.
struct DepthRange {
  double least = std::numeric_limits<double>::infinity(), most = -least;

  void take(double depth) {
    if (!std::isfinite(depth)) return;
    least = std::min(least, depth);
    most = std::max(most, depth);
  }
  [[nodiscard]] double length() const { return std::max(most - least, 0.0); }
};

}  // namespace

Casts::Casts(const NetcdfColumns& file, const ProfileVariable& value, const ProfileVariable& depth)
    : file_(file),
      name_(value.name()),
      depth_(depth.variable()),
      layout_(layout_of(file, value.name(), depth.name())),
      ids_(cast_ids(file, layout_)) {
  drop_constant_ids();
  groups_ = grouped(ids_, layout_.shape.size());
  if (ids_.empty() || !ids_.front().casts) use_times_and_places();
  number_casts();
}

/// Drops ids that are the same everywhere, or missing everywhere: they divide nothing.
void Casts::drop_constant_ids() {
  std::erase_if(ids_, [](const CastId& id) {
    return !id.casts && std::adjacent_find(id.value.begin(), id.value.end(),
                                           std::not_equal_to<>()) == id.value.end();
  });
}

Casts::Grouping Casts::grouped(const std::vector<CastId>& ids, std::size_t values) {
  Grouping out;
  for (std::size_t i = 0; i < values; ++i)
    if (std::ranges::none_of(ids,
                             [&](const CastId& id) { return id.value[i] == NetcdfCodes::none; }))
      out.order.push_back(i);
  const auto compare = [&](std::size_t a, std::size_t b) {
    for (const CastId& id : ids)
      if (id.value[a] != id.value[b]) return id.value[a] < id.value[b] ? -1 : 1;
    return 0;
  };
  std::ranges::stable_sort(out.order,
                           [&](std::size_t a, std::size_t b) { return compare(a, b) < 0; });
  for (std::size_t i = 0; i < out.order.size(); ++i)
    if (i == 0 || compare(out.order[i - 1], out.order[i]) != 0)
      out.run.push_back({i, i + 1});
    else
      out.run.back().end = i + 1;
  return out;
}

/// Returns whether a group has parts that cover the same depths. The samples of one cast do not do
/// so, of which each has its own time.
bool Casts::overlap_in_depth(const Grouping& parts, std::size_t first, std::size_t end) const {
  std::vector<DepthRange> spans(end - first);
  DepthRange all;
  for (std::size_t k = first; k < end; ++k)
    for (std::size_t i = parts.run[k].begin; i < parts.run[k].end; ++i) {
      const double depth = depth_.value[layout_.depth(parts.order[i])];
      spans[k - first].take(depth);
      all.take(depth);
    }
  const auto longest = std::ranges::max_element(
      spans, [](const DepthRange& a, const DepthRange& b) { return a.length() < b.length(); });
  if (!(longest->length() >= all.length() / 2)) return false;
  return std::any_of(spans.begin(), spans.end(), [&](const DepthRange& other) {
    const double shared =
        std::min(longest->most, other.most) - std::max(longest->least, other.least);
    return &other != &*longest && other.length() > 0 && shared > other.length() / 2;
  });
}

/// Divides what the ids leave together, if any of it are several casts.
void Casts::use_times_and_places() {
  const std::size_t values = layout_.shape.size();
  for (const auto& more : times_and_places(file_, layout_)) {
    // A cast has two values at least.
    const auto of_samples = [&](const CastId& id) { return id.codes.size() > values / 2; };
    if (more.empty() || std::ranges::any_of(more, of_samples)) continue;
    std::vector<CastId> ids = ids_;
    ids.insert(ids.end(), more.begin(), more.end());
    Grouping parts = grouped(ids, values);
    const auto is_other = [&](std::size_t a, std::size_t b) {
      return std::ranges::any_of(ids_, [&](const CastId& id) {
        return id.value[parts.order[parts.run[a].begin]] !=
               id.value[parts.order[parts.run[b].begin]];
      });
    };
    bool are_casts = false;
    for (std::size_t first = 0, k = 1; k <= parts.run.size(); ++k) {
      if (k < parts.run.size() && !is_other(first, k)) continue;
      are_casts = are_casts || overlap_in_depth(parts, first, k);
      first = k;
    }
    if (!are_casts) continue;
    ids_ = std::move(ids);
    drop_constant_ids();
    groups_ = std::move(parts);
    return;
  }
}

std::size_t Casts::first_id(const Run& run) const {
  return ids_.front().value[groups_.order[run.begin]];
}

void Casts::number_casts() {
  const auto& runs = groups_.run;
  const auto same = [&](const Run& a, const Run& b) { return first_id(a) == first_id(b); };
  is_numbered_ = !ids_.empty() && ids_.front().casts &&
                 std::adjacent_find(runs.begin(), runs.end(), same) == runs.end();
  const std::size_t values = layout_.shape.size(), outside = values - groups_.order.size();
  if (outside > 0)
    remarks_.push_back(
        fmt::format("{} of {} values of {} belong to no cast by {}, and are left out", outside,
                    values, name_, ids_text()));
}

std::size_t Casts::count() const { return is_numbered_ ? *ids_.front().casts : groups_.run.size(); }

std::vector<std::size_t> Casts::numbers() const {
  std::vector<std::size_t> out(groups_.run.size());
  if (is_numbered_)
    std::ranges::transform(groups_.run, out.begin(), [&](const Run& run) { return first_id(run); });
  else
    std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

Cast Casts::cast(std::size_t number) const {
  Cast out{number};
  const auto run = is_numbered_
                       ? std::ranges::lower_bound(groups_.run, number, {},
                                                  [&](const Run& r) { return first_id(r); })
                       : groups_.run.begin() + static_cast<std::ptrdiff_t>(number);
  if (run == groups_.run.end() || (is_numbered_ && first_id(*run) != number)) return out;
  for (std::size_t i = run->begin; i < run->end; ++i) {
    out.value.push_back(groups_.order[i]);
    out.depth.push_back(layout_.depth(groups_.order[i]));
  }
  if (!is_numbered_) out.label = label(*run);
  return out;
}

std::string Casts::label(const Run& run) const {
  std::vector<std::string> parts;
  for (const CastId& id : ids_)
    parts.push_back(fmt::format("{} {}", id.name, id.label(id.value[groups_.order[run.begin]])));
  return joined(parts, "and");
}

Cast Casts::chosen(std::optional<std::int64_t> profile) const {
  const std::string shape = shape_text(name_, layout_.shape);
  const bool may_be_first = is_numbered_ && layout_.profile_axis;
  const std::string choice = may_be_first || count() < 2
                                 ? ""
                                 : fmt::format("choose one of them: profile = 0 {} {}",
                                               count() == 2 ? "or" : "to", count() - 1);
  if (!profile && !choice.empty())
    file_.fail(shape, fmt::format("holds {} casts, divided by {}", count(), ids_text()), choice);
  const auto number = static_cast<std::size_t>(profile.value_or(0));
  if (number >= count())
    file_.fail(shape,
               fmt::format("there is no profile {}: it has {}, counted from 0", number, count()),
               choice);
  Cast out = cast(number);
  if (out.value.size() > max_levels)
    file_.fail(shape, fmt::format("profile {} has {} levels; at most {} are read", number,
                                  out.value.size(), max_levels));
  return out;
}

/// "cycle_number (57, 58)".
std::string Casts::ids_text() const {
  std::vector<std::string> names;
  for (const CastId& id : ids_) names.push_back(id.name);
  std::string text = joined(names, "and");
  if (ids_.size() != 1 || ids_.front().casts) return text;
  std::vector<std::string> labels;
  for (std::size_t k = 0; k < std::min<std::size_t>(groups_.run.size(), 10); ++k)
    labels.push_back(ids_.front().label(first_id(groups_.run[k])));
  return fmt::format("{} ({})", text, first_of(labels));
}

}  // namespace photic::scene
