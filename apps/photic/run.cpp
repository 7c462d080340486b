#include "engine/run.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/csv.hpp"
#include "io/json.hpp"
#include "io/netcdf.hpp"
#include "io/table.hpp"
#include "photic/checkpoint.hpp"
#include "photic/commands.hpp"
#include "photic/continuation.hpp"
#include "photic/destination.hpp"
#include "photic/interrupt.hpp"
#include "photic/lock.hpp"
#include "photic/output.hpp"
#include "photic/progress.hpp"

namespace photic::app {
namespace {

tally::Result simulate(const scene::Scene& scene, engine::RunOptions options,
                       Checkpoint& checkpoint) {
  ProgressBar bar;
  if (has_terminal())
    options.progress = [&bar](const engine::Progress& progress) { bar.draw(progress); };
  options.checkpoints.write = [&](const tally::Result& so_far) { checkpoint.write(so_far, bar); };
  return engine::run(scene, options);
}

std::string where_it_is(const tally::Result& result, const std::string& path,
                        const std::string& checkpoint) {
  std::string out = fmt::format("\nResult{}: {}\n",
                                result.partial ? " (partial: the run was interrupted)" : "", path);
  const std::filesystem::path file(path);
  const bool netcdf = file.extension() == ".nc";
  if (result.partial && (netcdf || !checkpoint.empty()))
    out += fmt::format("Go on:    {}\n", go_on_command(netcdf ? path : checkpoint, path));
  if (netcdf) {
    out += fmt::format("Plot it:  python3 -m photic plot {} -o {}\n", path,
                       std::filesystem::path(file).replace_extension(".png").string());
  }
  return out;
}

/// A run as it is before it begins.
struct Plan {
  Origin origin;
  std::string path;  ///< of the result, if nothing is there that took longer
  std::string history;
  std::optional<Isa> lanes;  ///< none: the scalar engine
  std::optional<engine::Start> start;
  std::uint64_t photons = 0;  ///< there already
};

/// Returns where the result is.
std::string write(const tally::Result& result, Destination& destination, const Plan& plan) {
  const Place place = destination.place_of(result);
  if (std::filesystem::path(place.path).extension() == ".csv") {
    io::write_csv(result, place.path, place.keep_as);
  } else {
    io::write_netcdf(
        result, place.path,
        {.history = plan.history, .scene_file = plan.origin.scene_file, .keep_as = place.keep_as});
  }
  print_error(place.remark);
  return place.path;
}

/// What the command says of the run besides its scene.
engine::RunOptions options_of(const RunCommand& command, std::optional<Isa> lanes,
                              std::optional<engine::Start> start) {
  engine::RunOptions options;
  options.threads = command.threads;
  options.lanes = lanes;
  options.interrupt = &interrupted();
  options.start = std::move(start);
  if (command.checkpoint_s)
    options.checkpoints.first_s = options.checkpoints.every_s = *command.checkpoint_s;
  return options;
}

std::optional<Isa> lanes_asked(const RunCommand& command) {
  if (command.engine != "scalar") return isa_of(command.isa).value_or(isas_here().back());
  if (command.isa.empty()) return std::nullopt;
  throw InputError({{.file = "--isa " + command.isa,
                     .reason = "only lanes are made of instructions to choose",
                     .suggestion = "--engine lanes, or leave it out"}});
}

/// The engine of a run that goes on from one that ran in `before`: bits depend on it.
std::optional<Isa> lanes_going_on(const RunCommand& command, const std::optional<Isa>& before) {
  if (before && !runs_here(*before)) {
    throw InputError({{.file = command.earlier,
                       .reason = fmt::format("ran in the engine {}, which does not run here",
                                             engine::engine_name(before)),
                       .suggestion = "go on where the processor has it, or run anew"}});
  }
  if (command.engine.empty() && command.isa.empty()) return before;
  const auto now = lanes_asked(command);
  if (now == before) return now;
  throw InputError({{.file = command.earlier,
                     .reason = fmt::format("ran in the engine {}, and is to go on in {}",
                                           engine::engine_name(before), engine::engine_name(now)),
                     .suggestion = "leave out --engine and --isa"}});
}

Plan plan(const RunCommand& command) {
  scene::Reading reading = read_scene_of(command);
  for (const std::string& remark : reading.remarks) print_error(remark + '\n');
  Plan plan;
  plan.path = result_path(command);
  plan.origin = {std::move(reading.scene),
                 command.scene.empty() ? "" : seen_from(plan.path, command.scene)};
  spare(reading.files, plan.path);
  plan.history = io::history_line(command.command_line);
  io::check_writable(plan.path);  // now, not after hours of work
  plan.lanes = lanes_asked(command);
  if (command.earlier.empty()) return plan;
  Earlier earlier = take_up(command.earlier, plan.origin.scene);
  if (command.scene.empty() && !earlier.scene_file.empty())
    plan.origin.scene_file = seen_from(
        plan.path,
        (std::filesystem::path(command.earlier).parent_path() / earlier.scene_file).string());
  plan.history = earlier.history + '\n' + plan.history;
  plan.lanes = lanes_going_on(command, earlier.lanes);
  plan.start = std::move(earlier.start);
  plan.photons = earlier.photons;
  if (plan.photons == plan.origin.scene.simulation.photons)
    print_error(fmt::format("{}: holds all {} photons asked for already (--photons is the total)\n",
                            command.earlier, plan.photons));
  return plan;
}

}  // namespace

int run(const RunCommand& command) {
  Plan plan = app::plan(command);
  const Lock lock(plan.path);
  Destination destination(plan.path, plan.origin, command.force);
  Checkpoint checkpoint(plan.path, plan.origin, plan.history);
  print_error(checkpoint.leftover(plan.photons));

  listen_for_interrupts();
  tally::Result result;
  try {
    result = simulate(plan.origin.scene, options_of(command, plan.lanes, std::move(plan.start)),
                      checkpoint);
  } catch (const engine::InterruptedPilots&) {
    print_error("interrupted while estimators were compared: there is no result yet\n");
    return interrupt_exit_code();
  }

  const std::string table = command.json ? io::echo_json(result) : io::echo_table(result);
  std::string path;
  try {
    path = write(result, destination, plan);
  } catch (const std::exception&) {
    print_out(table);  // all that is left of the run, but for its checkpoint
    print_error(checkpoint.leftover(0));
    throw;
  }
  const std::string place = where_it_is(result, path, checkpoint.finish(result));
  print_out(table);
  command.json ? print_error(place) : print_out(place);
  return result.partial ? interrupt_exit_code() : done;
}

}  // namespace photic::app
