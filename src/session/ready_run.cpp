#include "session/ready_run.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/isa.hpp"
#include "io/netcdf.hpp"
#include "schedule/engines.hpp"
#include "session/continuation.hpp"

namespace photic::session {
namespace {

/// None: the scalar engine, which alone follows light in spherical air.
std::optional<Isa> lanes_asked(const RunRequest& request, const scene::Scene& scene) {
  if (request.engine.empty() && request.isa.empty() && scene.is_of_spherical_air())
    return std::nullopt;
  if (request.engine != "scalar") return isa_of(request.isa).value_or(isas_here().back());
  if (request.isa.empty()) return std::nullopt;
  const Words& words = request.words;
  throw InputError({{.file = words.set(words.isa, request.isa),
                     .reason = "only lanes are made of instructions to choose",
                     .suggestion = words.set(words.engine, "lanes") + ", or leave it out"}});
}

/// The engine of a run that goes on from one that ran in `before`: bits depend on it.
std::optional<Isa> lanes_going_on(const RunRequest& request, const scene::Scene& scene,
                                  const std::optional<Isa>& before) {
  if (before && !runs_here(*before)) {
    throw InputError({{.file = request.earlier,
                       .reason = fmt::format("ran in the engine {}, which does not run here",
                                             schedule::engine_name(before)),
                       .suggestion = is_of_processor(*before)
                                         ? "build it: cmake -DPHOTIC_ISAS=all"
                                         : "continue where the processor has it, or run anew"}});
  }
  if (request.engine.empty() && request.isa.empty()) return before;
  const auto now = lanes_asked(request, scene);
  if (now == before) return now;
  throw InputError(
      {{.file = request.earlier,
        .reason = fmt::format("ran in the engine {}, and is to continue in {}",
                              schedule::engine_name(before), schedule::engine_name(now)),
        .suggestion =
            fmt::format("leave out {} and {}", request.words.engine, request.words.isa)}});
}

void go_on_from(Earlier earlier, const RunRequest& request, ReadyRun& run) {
  if (!earlier.scene_file.empty())
    run.earlier_scene_file =
        (std::filesystem::path(request.earlier).parent_path() / earlier.scene_file).string();
  run.history = earlier.history + '\n' + run.history;
  run.options.lanes = lanes_going_on(request, run.scene, earlier.lanes);
  run.options.start = std::move(earlier.start);
  run.photons_before = earlier.photons;
  if (earlier.photons == run.scene.simulation.photons)
    run.remark = fmt::format("{}: already holds all {} photons requested ({} is the total)",
                             request.earlier, earlier.photons, request.words.photons);
}

}  // namespace

ReadyRun make_ready(const Context& context, scene::Scene scene, const RunRequest& request) {
  ReadyRun run{.scene = std::move(scene), .history = io::history_line(request.command)};
  run.options.threads = request.threads;
  run.options.lanes = lanes_asked(request, run.scene);
  if (request.earlier.empty()) return run;
  run.scene = as_chosen_in(request.earlier, std::move(run.scene));
  go_on_from(take_up(request.earlier, run.scene, *context.library, request.words), request, run);
  return run;
}

}  // namespace photic::session
