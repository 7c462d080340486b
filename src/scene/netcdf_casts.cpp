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
struct Span {
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
  if (groups_.run.size() == 1 && !layout_.profile_axis) use_times_and_places();
  number_casts();
}

/// Those that are the same everywhere, or missing everywhere, divide nothing.
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

/// Whether values of different times or places are casts, and not the samples of one: then they
/// cover the same depths.
bool Casts::overlap_in_depth(const Grouping& groups) const {
  std::vector<Span> spans(groups.run.size());
  Span all;
  for (std::size_t k = 0; k < spans.size(); ++k)
    for (std::size_t i = groups.run[k].begin; i < groups.run[k].end; ++i) {
      const double depth = depth_.value[layout_.depth(groups.order[i])];
      spans[k].take(depth);
      all.take(depth);
    }
  const auto longest = std::ranges::max_element(
      spans, [](const Span& a, const Span& b) { return a.length() < b.length(); });
  if (longest == spans.end() || !(longest->length() >= all.length() / 2)) return false;
  return std::any_of(spans.begin(), spans.end(), [&](const Span& other) {
    const double shared =
        std::min(longest->most, other.most) - std::max(longest->least, other.least);
    return &other != &*longest && other.length() > 0 && shared > other.length() / 2;
  });
}

void Casts::use_times_and_places() {
  auto ids = times_and_places(file_, layout_);
  if (ids.empty()) return;
  ids.insert(ids.begin(), ids_.begin(), ids_.end());
  Grouping groups = grouped(ids, layout_.shape.size());
  if (!overlap_in_depth(groups)) return;
  ids_ = std::move(ids);
  drop_constant_ids();
  groups_ = std::move(groups);
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
  const auto all = numbers();
  const auto at = std::ranges::lower_bound(all, number);
  Cast out{number};
  if (at == all.end() || *at != number) return out;
  const Run& run = groups_.run[static_cast<std::size_t>(at - all.begin())];
  for (std::size_t i = run.begin; i < run.end; ++i) {
    out.value.push_back(groups_.order[i]);
    out.depth.push_back(layout_.depth(groups_.order[i]));
  }
  if (!is_numbered_) out.label = label(run);
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
  if (out.value.size() > most_levels)
    file_.fail(shape, fmt::format("profile {} has {} levels; at most {} are read", number,
                                  out.value.size(), most_levels));
  return out;
}

/// "cycle_number (57, 58)".
std::string Casts::ids_text() const {
  std::vector<std::string> names;
  for (const CastId& id : ids_) names.push_back(id.name);
  const std::string text = joined(names, "and");
  if (ids_.size() != 1 || ids_.front().casts) return text;
  std::vector<std::string> labels;
  for (const Run& run : groups_.run) labels.push_back(ids_.front().label(first_id(run)));
  return fmt::format("{} ({})", text, first_of(labels));
}

}  // namespace photic::scene
