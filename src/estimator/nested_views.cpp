#include "estimator/nested_views.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace photic::estimator {
namespace {

/// Returns whether telescopes share light at all: the shares of a lens that `overlap` takes differ
/// from view to view, and analog photons fall on each. Where the estimator is left open it is
/// neither.
bool shares_light(const scene::Simulation& simulation) {
  return simulation.estimator != scene::Estimator::analog &&
         simulation.reception == scene::Reception::ray;
}

/// The properties that have to be the same.
scene::Telescope without_view(scene::Telescope telescope) {
  telescope.name.clear();
  telescope.direction = normalised(telescope.direction);
  telescope.detector_diameter_m.reset();
  telescope.half_field_of_view_mrad.reset();
  telescope.detector_shift_m = telescope.effective_detector_shift_m();
  telescope.focus_m.reset();
  return telescope;
}

}  // namespace

std::vector<NestedViews> nested_views(const scene::Scene& scene) {
  const auto& telescopes = scene.telescope;
  const bool shares = shares_light(scene.simulation);
  std::vector<NestedViews> out;
  for (std::size_t t = 0; t < telescopes.size(); ++t) {
    const auto group = std::ranges::find_if(out, [&](const NestedViews& views) {
      return shares && without_view(telescopes[views.front()]) == without_view(telescopes[t]);
    });
    if (group == out.end())
      out.push_back({t});
    else
      group->push_back(t);
  }
  for (NestedViews& views : out) {
    std::ranges::stable_sort(
        views, {}, [&](std::size_t t) { return telescopes[t].effective_detector_diameter_m(); });
  }
  return out;
}

std::vector<std::string> reported_nested_views(const scene::Scene& scene) {
  std::vector<std::string> out;
  for (const NestedViews& views : nested_views(scene)) {
    if (views.size() == 1) continue;
    std::string names = scene.telescope[views.front()].name;
    for (std::size_t i = 1; i < views.size(); ++i)
      names += (i + 1 < views.size() ? ", " : " and ") + scene.telescope[views[i]].name;
    out.push_back(fmt::format(
        "telescopes {} have views inside each other: what is drawn for one serves all", names));
  }
  return out;
}

}  // namespace photic::estimator
