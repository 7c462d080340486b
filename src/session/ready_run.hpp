// A scene made ready to run as it is asked for: by which engine, on how many threads, and from
// which earlier result on.
#pragma once

#include <cstdint>
#include <string>

#include "run/run.hpp"
#include "scene/scene.hpp"
#include "session/context.hpp"
#include "session/front_end.hpp"

namespace photic::session {

/// The flags of `photic run` that are about neither the scene nor the result's file.
struct RunRequest {
  int threads = 0;      ///< 0: all cores
  std::string engine;   ///< lanes | scalar; empty: that of the earlier result, or lanes
  std::string isa;      ///< of lanes; empty: the best there is
  std::string earlier;  ///< the result to go on from; empty: none
  std::string command;  ///< for the history of the result
  Words words = {};
};

struct ReadyRun {
  scene::Scene scene = {};
  run::RunOptions options = {};
  std::string history = {};             ///< of the result
  std::string earlier_scene_file = {};  ///< of the earlier result; empty: not known
  std::uint64_t photons_before = 0;
  std::string remark = {};  ///< a line for the user; may be empty
};

/// Throws InputError for an engine that cannot run it, and for what take_up() refuses;
/// EnvironmentError for a file that cannot be read.
ReadyRun make_ready(const Context& context, scene::Scene scene, const RunRequest& request);

}  // namespace photic::session
