#include "run/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "io/json.hpp"
#include "io/table.hpp"
#include "photic/commands.hpp"
#include "photic/context.hpp"
#include "photic/interrupt.hpp"
#include "photic/output.hpp"
#include "photic/progress.hpp"
#include "photic/tables.hpp"
#include "photic/terminal.hpp"
#include "session/continuation.hpp"
#include "session/kept_run.hpp"
#include "session/read.hpp"
#include "session/result_file.hpp"

namespace photic::app {
namespace {

/// The run's words on the terminal, above its progress bar.
session::FrontEnd front_end(const Call& call, ProgressBar& bar) {
  return {
      .report = [&bar](const std::string& line) { bar.print_above(line); },
      .go_on = [&call](const std::string& earlier,
                       const std::string& output) { return go_on_command(call, earlier, output); }};
}

/// Waits for the end of a run, which an interrupt brings about.
tally::Result result_of(session::Run& run, bool draws, ProgressBar& bar) {
  constexpr std::chrono::milliseconds between_looks{100};
  while (!run.wait_for(between_looks)) {
    if (interrupted()) run.stop();
    if (draws) bar.draw(run.progress());
  }
  bar.wipe();
  return run.result();
}

std::string where_it_is(const tally::Result& result, const Call& call,
                        const session::KeptRun::Kept& places) {
  const auto& [path, checkpoint] = places;
  std::string out = fmt::format("\nResult{}: {}\n",
                                result.partial ? " (partial: the run was interrupted)" : "", path);
  const bool netcdf = session::format_of(path) == session::Format::netcdf;
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

/// The scene that the run is asked for; where none is given, that of the result it goes on from.
scene::Reading read_scene_of(const session::Context& context, const RunCommand& command) {
  return command.scene.empty() ? session::read_earlier(context, command.earlier, command.overrides)
                               : session::read_file(context, command.scene, command.overrides);
}

session::ResultFile result_file(const RunCommand& command) {
  return {.path = session::result_path(command.output, command.scene, command.earlier),
          .scene_file = command.scene,
          .force = command.force,
          .checkpoint_s = command.checkpoint_s};
}

}  // namespace

int run(const RunCommand& command) {
  const session::Context& context = app::context();
  scene::Reading reading = read_scene_of(context, command);
  for (const std::string& remark : reading.remarks) print_warning(remark + '\n');
  const session::ResultFile file = result_file(command);
  session::spare(reading.files, file.path);
  ProgressBar bar;
  listen_for_interrupts();
  session::KeptRun kept(context,
                        session::make_ready(context, std::move(reading.scene),
                                            {.threads = command.threads,
                                             .engine = command.engine,
                                             .isa = command.isa,
                                             .earlier = command.earlier,
                                             .command = command.call.line}),
                        file, front_end(command.call, bar));
  tally::Result result;
  try {
    result = result_of(kept.run(), is_terminal(Stream::error) && !command.quiet, bar);
  } catch (const run::StoppedBeforeFirstBatch&) {
    print_error("interrupted before the end of the first batch: there is no result yet\n");
    return interrupt_exit_code();
  }

  session::KeptRun::Kept places;
  try {
    places = kept.write(result);
  } catch (const std::exception&) {
    print_echoes(result, command);  // all that is left of the run, but for its checkpoint
    kept.report_leftover();
    throw;
  }
  report(result, command, where_it_is(result, command.call, places));
  return result.partial ? interrupt_exit_code() : done;
}

}  // namespace photic::app
