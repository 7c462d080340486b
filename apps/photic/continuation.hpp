// photic run --continue: results that a run can go on from.
#pragma once

#include <cstdint>
#include <string>

#include "engine/run.hpp"
#include "photic/commands.hpp"

namespace photic::app {

/// The scene a run is asked for; where none is given, that of the result it goes on from. Throws as
/// scene::read_scene and io::read_run do.
scene::Reading read_scene_of(const RunCommand& command);

/// A result taken up by a run of the same scene.
struct Earlier {
  engine::Start start;
  std::optional<Isa> lanes;  ///< that it ran in; none: the scalar engine
  std::uint64_t photons = 0;
  std::string history;
};

/// Throws InputError with all that keeps a run of this scene from going on from the result: another
/// version of Photic, every key of the scene but those that only say when to stop, photons asked
/// for that are fewer than those there.
Earlier take_up(const std::string& file, const scene::Scene& scene);

/// How many photons a run of this scene can take up from a file; 0 if none, for whatever reason.
std::uint64_t photons_to_take_up(const std::string& file, const scene::Scene& scene);

}  // namespace photic::app
