// The settings of the bidirectional estimator's walks, made of a model.
#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "estimator/instruments.hpp"
#include "estimator/make_instruments.hpp"
#include "estimator/model.hpp"
#include "estimator/reach.hpp"
#include "estimator/strategies.hpp"
#include "estimator/walk_attenuation.hpp"
#include "estimator/walk_cones.hpp"
#include "estimator/walk_settings.hpp"
#include "scene/walk_settings.hpp"

namespace photic::estimator {

/// Shares of the directions that walks from telescopes draw about the laser's beam: after a
/// conversion, and where they scatter the laser's light in scenes with conversions.
inline constexpr double directed_inverse_conversion = 0.6;
inline constexpr double directed_scattering = 0.1;

/// The probability at a vertex of a telescope's walk in emitted light: where that is hardly
/// scattered, as many conversions are inverted as if its free paths were drawn like those of the
/// laser's light.
inline double inverse_conversion_probability(double conversion_probability) {
  return 1 - std::pow(1 - conversion_probability, 1 / emitted_walk_share);
}

/// The lines of a medium that begin receivers: its own, if a channel counts it, and the first of
/// each band that walks convert.
struct ReceivedLine {
  std::size_t line;
  std::int32_t band;  ///< -1: the laser's own line
};
inline std::vector<ReceivedLine> received_lines(const medium::Medium& medium) {
  std::vector<ReceivedLine> out;
  std::int32_t band = -1;
  for (std::size_t l = 0; l < medium.line.size(); ++l) {
    const auto& line = medium.line[l];
    if (l > 0 && line.process == medium.line[l - 1].process) continue;
    if (l > 0) ++band;
    if (line.process == medium::Process::oil) continue;  // walks leave a film's light out
    if (l > 0 || std::ranges::any_of(line.counted_by, [](double share) { return share > 0; }))
      out.push_back({l, band});
  }
  return out;
}

/// The number of receivers of a model: one for each group of telescopes and line.
inline std::size_t count_receivers(const Model& model) {
  return nested_views(model.scene).size() * received_lines(model.medium).size();
}

/// The longest way [m] that free walks of a cone may lose: it counts as more time for those that
/// are not free yet.
inline double max_lost(const EntryCone<double>& cone, const tally::Gates& gates) {
  return std::min(cone.spot.max_shorter, gates.last_path());
}

/// One receiver for each group of telescopes and received line, and the time of its walks.
template <class T>
std::vector<Receiver<T>> make_receivers(const Model& model, const Instruments<T>& instruments,
                                        const WalkCones& cones) {
  const auto& [scene, medium] = std::tie(model.scene, model.medium);
  const auto lines = received_lines(medium);
  const double greatest = group_indices(medium).greatest;
  std::vector<Receiver<T>> out;
  for (std::size_t g = 0; g < instruments.groups.size(); ++g) {
    const ViewGroup<T>& group = instruments.groups[g];
    const auto& telescope = scene.telescope[group.number];
    const double both = model.gates.last_path() - group.path_to_origin;
    const double longest =
        both + max_lost(cones.telescope[group.number], model.gates) +
        max_lost(cones.laser, model.gates) +
        instrument::max_longer(telescope) * (telescope.position_m.z < 0 ? greatest : 1.0);
    for (const auto& [line, band] : lines)
      out.push_back({out.size(), g, group.number, group.region,
                     Index<T>(static_cast<std::int32_t>(line)), band, T(both), T(longest),
                     deadline_at_laser<T>(scene, longest, ahead_in(medium, scene.source))});
  }
  return out;
}

template <class T>
InverseConversion<T> make_inverse_conversion(const scene::Scene& scene,
                                             const medium::Medium& medium) {
  return {T(inverse_conversion_probability(scene.simulation.conversion_probability.value_or(
              scene::usual_conversion_probability))),
          T(directed_inverse_conversion), vec3_cast<T>(beam_in_water(scene, medium)),
          Index<T>(medium.beam_lobe), T(medium.line.size() > 1 ? directed_scattering : 0.0)};
}

template <class T>
WalkSettings<T> make_walk_settings(const Model& model, const Instruments<T>& instruments,
                                   const Reach& reach, const WalkCones& cones) {
  const auto& [scene, medium] = std::tie(model.scene, model.medium);
  const scene::Simulation& asked = scene.simulation;
  WalkSettings<T> out;
  out.receivers = make_receivers(model, instruments, cones);
  out.laser_cone = cone_cast<T>(cones.laser);
  for (const auto& cone : cones.telescope) out.telescope_cones.push_back(cone_cast<T>(cone));
  out.averaged = model.averaged.view();
  out.free_telescope = {T(cones.free_telescope)};
  out.free_laser = {T(cones.free_laser)};
  out.deepest = T(reach.deepest);
  out.meeting_grid = {T(asked.meetings.value_or(scene::usual_meetings) / reach.range)};
  out.inverse_conversion = make_inverse_conversion<T>(scene, medium);
  const Strategies used = make_strategies(scene, medium);
  out.uses = {used.to_laser.used, used.between.used, used.translated.used, used.rotated.used,
              used.rotated_scattered.used};
  out.connected = T(asked.connected_fraction.value_or(scene::usual_connected_fraction));
  if (asked.estimator == scene::Estimator::bidirectional)
    out.laser_walks = static_cast<std::size_t>(asked.walks.value_or(scene::usual_walks));
  return out;
}

}  // namespace photic::estimator
