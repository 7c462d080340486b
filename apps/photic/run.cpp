#include "run/run.hpp"

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
#include "photic/terminal.hpp"

namespace photic::app {
namespace {

tally::Result simulate(const scene::Scene& scene, run::RunOptions options, bool quiet,
                       Checkpoint& checkpoint) {
  ProgressBar bar;
  if (is_terminal(Stream::error) && !quiet)
    options.progress = [&bar](const run::Progress& progress) { bar.draw(progress); };
  options.checkpoints.write = [&](const tally::Result& so_far) { checkpoint.write(so_far, bar); };
  return run::run(scene, options);
}

std::string where_it_is(const tally::Result& result, const Call& call, const std::string& path,
                        const std::string& checkpoint) {
  std::string out = fmt::format("\nResult{}: {}\n",
                                result.partial ? " (partial: the run was interrupted)" : "", path);
  const bool netcdf = format_of(path) == Format::netcdf;
  if (result.partial && (netcdf || !checkpoint.empty()))
    out += fmt::format("Continue: {}\n", go_on_command(call, netcdf ? path : checkpoint, path));
  return out + plot_hint(call, path);
}

/// The echoes as the terminal shows them.
std::string table(const tally::Result& result, const RunCommand& command) {
  constexpr int no_terminal = 100;
  const auto width = static_cast<std::size_t>(columns(Stream::out, no_terminal));
  if (command.table == "none") return io::run_summary(result, width);
  io::TableLayout layout{.width = width};
  if (command.table == "full") layout = {io::all_rows, width, true};
  return io::echo_table(result, layout);
}

void print_echoes(const tally::Result& result, const RunCommand& command) {
  command.json ? print_out(io::echo_json(result)) : print_table(table(result, command));
}

/// Prints a run's result; its place goes to standard error if the rest is for a program.
void report(const tally::Result& result, const RunCommand& command, const std::string& place) {
  if (command.quiet) {
    for (const std::string& warning : result.warnings) print_warning(warning + '\n');
    if (command.json) print_echoes(result, command);
    return;
  }
  print_echoes(result, command);
  command.json ? print_error(place) : print_out(place);
}

/// A run as it is before it begins.
struct Plan {
  Origin origin;
  std::string path;  ///< of the result, if nothing is there that took longer
  std::string history;
  std::optional<Isa> lanes;  ///< none: the scalar engine
  std::optional<run::Start> start;
  std::uint64_t photons = 0;  ///< there already
};

/// Returns where the result is.
std::string write(const tally::Result& result, Destination& destination, const Plan& plan) {
  const Place place = destination.place_of(result);
  switch (format_of(place.path).value_or(Format::netcdf)) {
    case Format::csv:
      io::write_csv(result, place.path, place.keep_as);
      break;
    case Format::text:
      io::write_table(result, place.path, place.keep_as);
      break;
    case Format::netcdf:
      io::write_netcdf(result, place.path,
                       {.history = plan.history,
                        .scene_file = plan.origin.scene_file,
                        .keep_as = place.keep_as});
  }
  print_warning(place.remark);
  return place.path;
}

/// The options that the command gives for the run besides its scene.
run::RunOptions options_of(const RunCommand& command, std::optional<Isa> lanes,
                           std::optional<run::Start> start) {
  run::RunOptions options;
  options.threads = command.threads;
  options.lanes = lanes;
  options.interrupt = &interrupted();
  options.start = std::move(start);
  if (command.checkpoint_s)
    options.checkpoints.first_s = options.checkpoints.every_s = *command.checkpoint_s;
  return options;
}

/// None: the scalar engine, which alone follows light in spherical air.
std::optional<Isa> lanes_asked(const RunCommand& command, const scene::Scene& scene) {
  if (command.engine.empty() && command.isa.empty() && scene.is_of_spherical_air())
    return std::nullopt;
  if (command.engine != "scalar") return isa_of(command.isa).value_or(isas_here().back());
  if (command.isa.empty()) return std::nullopt;
  throw InputError({{.file = "--isa " + command.isa,
                     .reason = "only lanes are made of instructions to choose",
                     .suggestion = "--engine lanes, or leave it out"}});
}

/// The engine of a run that goes on from one that ran in `before`: bits depend on it.
std::optional<Isa> lanes_going_on(const RunCommand& command, const scene::Scene& scene,
                                  const std::optional<Isa>& before) {
  if (before && !runs_here(*before)) {
    throw InputError({{.file = command.earlier,
                       .reason = fmt::format("ran in the engine {}, which does not run here",
                                             schedule::engine_name(before)),
                       .suggestion = is_of_processor(*before)
                                         ? "build it: cmake -DPHOTIC_ISAS=all"
                                         : "continue where the processor has it, or run anew"}});
  }
  if (command.engine.empty() && command.isa.empty()) return before;
  const auto now = lanes_asked(command, scene);
  if (now == before) return now;
  throw InputError(
      {{.file = command.earlier,
        .reason = fmt::format("ran in the engine {}, and is to continue in {}",
                              schedule::engine_name(before), schedule::engine_name(now)),
        .suggestion = "leave out --engine and --isa"}});
}

Plan plan(const RunCommand& command) {
  scene::Reading reading = read_scene_of(command);
  for (const std::string& remark : reading.remarks) print_warning(remark + '\n');
  Plan plan;
  plan.path = result_path(command);
  plan.origin = {std::move(reading.scene),
                 command.scene.empty() ? "" : seen_from(plan.path, command.scene)};
  spare(reading.files, plan.path);
  plan.history = io::history_line(command.call.line);
  io::check_writable(plan.path);  // now, not after hours of work
  plan.lanes = lanes_asked(command, plan.origin.scene);
  if (command.earlier.empty()) return plan;
  Earlier earlier = take_up(command.earlier, plan.origin.scene);
  if (command.scene.empty() && !earlier.scene_file.empty())
    plan.origin.scene_file = seen_from(
        plan.path,
        (std::filesystem::path(command.earlier).parent_path() / earlier.scene_file).string());
  plan.history = earlier.history + '\n' + plan.history;
  plan.lanes = lanes_going_on(command, plan.origin.scene, earlier.lanes);
  plan.start = std::move(earlier.start);
  plan.photons = earlier.photons;
  if (plan.photons == plan.origin.scene.simulation.photons)
    print_warning(
        fmt::format("{}: already holds all {} photons requested (--photons is the total)\n",
                    command.earlier, plan.photons));
  return plan;
}

}  // namespace

int run(const RunCommand& command) {
  Plan plan = app::plan(command);
  const Lock lock(plan.path);
  Destination destination(plan.path, plan.origin, command.force);
  Checkpoint checkpoint(plan.path, plan.origin, plan.history, command.call);
  print_warning(checkpoint.leftover(plan.photons));

  listen_for_interrupts();
  tally::Result result;
  try {
    result = simulate(plan.origin.scene, options_of(command, plan.lanes, std::move(plan.start)),
                      command.quiet, checkpoint);
  } catch (const run::InterruptedPilots&) {
    print_error("interrupted while estimators were compared: there is no result yet\n");
    return interrupt_exit_code();
  }

  std::string path;
  try {
    path = write(result, destination, plan);
  } catch (const std::exception&) {
    print_echoes(result, command);  // all that is left of the run, but for its checkpoint
    print_error(checkpoint.leftover(0));
    throw;
  }
  report(result, command, where_it_is(result, command.call, path, checkpoint.finish(result)));
  return result.partial ? interrupt_exit_code() : done;
}

}  // namespace photic::app
