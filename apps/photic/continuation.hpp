// photic run --continue: results that a run can go on from.
#pragma once

#include <cstdint>
#include <string>

#include "io/netcdf.hpp"
#include "photic/commands.hpp"
#include "run/run.hpp"

namespace photic::app {

/// The scene a run is asked for; where none is given, that of the result it goes on from. Throws as
/// scene::read_scene and io::read_run do.
scene::Reading read_scene_of(const RunCommand& command);

/// A result taken up by a run of the same scene.
struct Earlier {
  run::Start start;
  std::optional<Isa> lanes;  ///< the run's instruction set; none: the scalar engine
  std::uint64_t photons = 0;
  std::string history;
  std::string scene_file;  ///< seen from the result's folder; empty: not known
};

/// Throws InputError with all that keeps a run of this scene from going on from the result: another
/// version of Photic, every key of the scene but those that only say when to stop, photons asked
/// for that are fewer than those there.
Earlier take_up(const std::string& file, const scene::Scene& scene);

/// Returns whether a result of this program is of this scene, but for when its run was to stop.
bool is_same_scene(const io::RunSoFar& run, const std::string& file, const scene::Scene& scene);

}  // namespace photic::app
