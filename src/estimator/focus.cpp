#include "estimator/focus.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

#include "instrument/telescope.hpp"

namespace photic::estimator {
namespace {

/// Below it the surface counts as out of focus.
constexpr double min_share = 0.9;

/// The share of the open lens whose rays from a point on the axis reach the detector
/// (docs/theory.md, eq. 32 with q = 0). `distance`: the point's apparent distance from the lens
/// [m].
double share_of_lens(const scene::Telescope& telescope, double distance) {
  return instrument::make_telescope<double>(telescope).overlap(1 / distance, 0.0);
}

/// Along the axis of a telescope in the air [m]; none where that does not lead to the sea.
std::optional<double> distance_to_sea(const scene::Telescope& telescope) {
  const double down = -normalised(telescope.direction).z;
  if (!(telescope.position_m.z > 0 && down > 0)) return std::nullopt;
  return telescope.position_m.z / down;
}

/// The apparent distance of a point on the axis of a telescope at the depth, or the range,
/// of a gate [m]: what lies in the water is seen through the surface as if at 1 / n of its length.
double apparent_distance(const Model& model, std::size_t t, double place) {
  const scene::Telescope& lens = model.scene.telescope[t];
  const auto to_sea = distance_to_sea(lens);
  const auto axis = geometry::axis_in_water(lens.position_m, normalised(lens.direction),
                                            model.medium.line.front().refractive_index);
  const bool is_range = model.gates.depth_is_range();
  const double beyond = is_range ? place - (axis.in_air - model.apparent_path.range(t))
                                 : (place + axis.entry.z) / -axis.direction.z;
  if (!to_sea) return beyond;
  if (beyond > 0) return *to_sea + beyond / axis.index;
  return *to_sea + (is_range ? beyond : place * *to_sea / lens.position_m.z);
}

double middle_of_gate(const Model& model, std::size_t t, std::int32_t gate) {
  const medium::Line& laser = model.medium.line.front();
  return (model.gates.edge_depth(gate, t, laser) + model.gates.edge_depth(gate + 1, t, laser)) / 2;
}

std::string focused_at(const scene::Telescope& telescope) {
  const double per_metre = instrument::per_sharp_range(telescope);
  if (per_metre < 0) return "focused nowhere, with its detector before the focal plane";
  return per_metre > 0 ? fmt::format("focused at {:.6g} m", 1 / per_metre) : "focused at infinity";
}

std::string report_of(const Model& model, std::size_t t) {
  const scene::Telescope& lens = model.scene.telescope[t];
  const char* place = model.gates.depth_is_range() ? "range" : "depth";
  std::vector<std::string> shares;
  const auto add = [&](double distance, const std::string& from) {
    shares.push_back(fmt::format("{:.2g} from {}", share_of_lens(lens, distance), from));
  };
  const auto add_gate = [&](const char* which, std::int32_t gate) {
    const double middle = middle_of_gate(model, t, gate);
    const double distance = apparent_distance(model, t, middle);
    if (!(distance > 0)) return false;
    add(distance, fmt::format("the {} ({} {:.6g} m)", which, place, middle));
    return true;
  };
  const std::int32_t last = model.gates.count() - 1;
  if (const auto to_sea = distance_to_sea(lens))
    add(*to_sea, "the sea's surface");
  else
    for (std::int32_t gate = 0; gate < last && !add_gate("first gate ahead", gate);) ++gate;
  add_gate("last gate", last);
  return fmt::format(
      "{}, {}: {}", lens.name, focused_at(lens),
      shares.empty() ? "no gate lies on its axis" : fmt::format("{}", fmt::join(shares, ", ")));
}

}  // namespace

void check_focus(const scene::Scene& scene, scene::Findings& findings) {
  for (std::size_t t = 0; t < scene.telescope.size(); ++t) {
    const std::string path = scene::below("telescope", t);
    const bool is_meant = findings.given(scene::below(path, "detector_shift_m"));
    if (is_meant || !findings.good({path})) continue;
    const scene::Telescope& lens = scene.telescope[t];
    const auto distance = distance_to_sea(lens);
    if (!distance) continue;
    const double share = share_of_lens(lens, *distance);
    if (share >= min_share) continue;
    const std::string advice = *distance > lens.focal_length_m
                                   ? fmt::format("focus_m = {:.6g} puts it in focus, ", *distance)
                                   : "";
    findings.remark(scene::below(path, "focus_m"),
                    fmt::format("the sea's surface, {:.6g} m away, is out of focus: its light "
                                "reaches the detector through {:.2g} of the open lens; "
                                "{}detector_shift_m = {:.6g} leaves it so",
                                *distance, share, advice, lens.effective_detector_shift_m()));
  }
}

std::vector<std::string> reported_focus(const Model& model) {
  std::vector<std::string> out;
  for (std::size_t t = 0; t < model.scene.telescope.size(); ++t) out.push_back(report_of(model, t));
  return out;
}

}  // namespace photic::estimator
