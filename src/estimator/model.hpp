// A scene made ready to run: the medium, the gates and the shape of the tallies.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/twin_table.hpp"
#include "estimator/apparent.hpp"
#include "estimator/averaged_phases.hpp"
#include "estimator/tallies/levels.hpp"
#include "geometry/free_paths.hpp"
#include "geometry/region.hpp"
#include "medium/air.hpp"
#include "medium/medium.hpp"
#include "medium/other_airs.hpp"
#include "medium/outside_column.hpp"
#include "scene/read.hpp"
#include "scene/scene.hpp"
#include "tally/gates.hpp"
#include "tally/result.hpp"
#include "tally/shape.hpp"

namespace photic::estimator {

/// The photons of a batch, as the simulation asks for, or else so many that a run has batches
/// enough to know its errors, and that to begin, end and merge one costs little of the time that it
/// takes: fewer of the bidirectional estimator, of which each takes tens of times as long.
std::uint64_t batch_photons(const scene::Simulation& simulation);

/// A medium::OutsideColumn as lanes read it.
struct ColumnTables {
  TwinTable optical_depth, delay;  ///< [line]
  double per_metre = 0;

  /// `excess`: of OutsideColumn.
  [[nodiscard]] geometry::OutsideColumn view(std::int32_t excess) const {
    return {optical_depth.view(), delay.view(), excess, per_metre};
  }
};
/// From the surface of a medium outwards, to distances; none to those below 0, which are inside.
template <class Outside>
std::vector<ColumnTables> columns_to(const Outside& outside,
                                     const std::vector<double>& distance_m) {
  std::vector<ColumnTables> out;
  for (const double distance : distance_m) {
    if (distance < 0) {
      out.emplace_back();
      continue;
    }
    const auto column = medium::column_to(outside, distance);
    out.push_back({TwinTable(column.optical_depth), TwinTable(column.delay_m), column.per_metre});
  }
  return out;
}

/// The heights of a scene's laser and telescopes above the surface [m].
inline std::vector<double> heights_of(const scene::Scene& scene) {
  std::vector<double> out{scene.source.position_m.z};
  for (const auto& t : scene.telescope) out.push_back(t.position_m.z);
  return out;
}

struct Model {
  /// The scene as it is simulated: with a walk_attenuation by the water, if it names none, and with
  /// instruments where they seem to stand if the air bends light.
  scene::Scene scene;
  medium::Medium medium;
  geometry::FreePaths paths;
  tally::Gates gates;
  tally::Shape shape;
  AveragedPhaseTables averaged;  ///< of scenes with free walks
  std::optional<medium::Air> air;
  /// Between the surface and the laser, and each telescope, where these stand outside the medium;
  /// none where that is clear.
  std::vector<ColumnTables> columns;
  std::vector<medium::OtherAir> other_airs;  ///< of scenes with air and environments
  geometry::ApparentPath apparent_path;
  GivenInstruments as_given;  ///< as in the scene file
  /// Of the level of a radiance, optical, from the surface, [level].
  std::vector<double> level_depth;

  /// Returns whether there is no sea: the medium is the air, from its top down.
  [[nodiscard]] bool is_air_alone() const { return scene.is_of_air_alone(); }
  /// The distance of a level from the surface of the medium that it is in [m].
  [[nodiscard]] double from_surface(const TallyLevel& level) const {
    return is_air_alone() ? medium.top.back() - level.distance : level.distance;
  }
};

/// The check of a scene's optics, for scene::read_scene: whatever make_model would refuse. Several
/// threads may ask it.
scene::Check optics_check(std::shared_ptr<const optics::Library> library);

/// Throws InputError for what optics_check finds, EnvironmentError for missing data files.
Model make_model(const scene::Scene& scene, const optics::Library& library,
                 const std::stop_token& stop = {});

/// As make_model makes it of the scene with another simulation, to the last bit, for a small part
/// of the time.
Model with_simulation(Model model, const scene::Simulation& simulation,
                      const std::stop_token& stop = {});

/// The same scene, simulated otherwise: by part of a simulation, such as a pilot, which scores into
/// tallies of the model's shape.
Model simulated_by(const Model& model, const scene::Simulation& simulation,
                   const std::stop_token& stop = {});
/// The air of a model above the sea, upside down (medium/upside_down.hpp): what follows light in
/// the water follows it there.
Model model_of_air(const Model& model, const std::stop_token& stop = {});

/// The simulated scene, with the instruments as given.
scene::Scene reported_scene(const Model& model);

/// A result's axes, and what it says of the scene; the tallies are still to be filled in.
tally::Result describe(const Model& model);

}  // namespace photic::estimator
