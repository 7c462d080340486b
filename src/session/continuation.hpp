// Results that a run can go on from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/isa.hpp"
#include "io/netcdf.hpp"
#include "run/run.hpp"
#include "scene/read.hpp"
#include "session/context.hpp"
#include "session/front_end.hpp"

namespace photic::session {

/// The scene of a result, or of a checkpoint. Throws as read() and io::read_run() do.
scene::Reading read_earlier(const Context& context, const std::string& file,
                            const std::vector<scene::Override>& overrides = {});

/// The scene with what the run that made a result chose, where it leaves the choice open.
scene::Scene as_chosen_in(const std::string& file, scene::Scene scene);

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
Earlier take_up(const std::string& file, const scene::Scene& scene, const optics::Library& library,
                const Words& words = {});

/// Returns whether a result of this program is of this scene, but for when its run was to stop.
bool is_same_scene(const io::RunSoFar& run, const std::string& file, const scene::Scene& scene,
                   const optics::Library& library);

}  // namespace photic::session
