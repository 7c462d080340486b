#include "engine/run.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/error.hpp"
#include "engine/problem.hpp"
#include "io/atomic_file.hpp"
#include "io/csv.hpp"
#include "io/json.hpp"
#include "io/netcdf.hpp"
#include "io/table.hpp"
#include "photic/commands.hpp"
#include "photic/interrupt.hpp"
#include "photic/output.hpp"
#include "photic/progress.hpp"

namespace photic::app {
namespace {

tally::Result simulate(const scene::Scene& scene, int threads) {
  ProgressBar bar;
  engine::RunOptions options;
  options.threads = threads;
  options.interrupt = &interrupted();
  if (has_terminal())
    options.progress = [&bar](const engine::Progress& progress) { bar.draw(progress); };
  return engine::run(scene, options);
}

void write(const tally::Result& result, const std::string& path, const std::string& command_line) {
  if (std::filesystem::path(path).extension() == ".csv") {
    io::write_csv(result, path);
  } else {
    io::write_netcdf(result, path, io::WriteInfo{.history = io::history_line(command_line)});
  }
}

std::string where_it_is(const tally::Result& result, const std::string& path) {
  std::string out = fmt::format("\nResult{}: {}\n",
                                result.partial ? " (partial: the run was interrupted)" : "", path);
  const std::filesystem::path file(path);
  if (file.extension() == ".nc") {
    out += fmt::format("Plot it:  python3 -m photic plot {} -o {}\n", path,
                       std::filesystem::path(file).replace_extension(".png").string());
  }
  return out;
}

}  // namespace

int run(const RunCommand& command) {
  const scene::Reading reading =
      scene::read_scene(command.scene, command.overrides, engine::check_optics);
  for (const std::string& remark : reading.remarks) print_error(remark + '\n');
  const std::string path = result_path(command.output, command.scene);
  io::check_writable(path);  // now, not after hours of work

  listen_for_interrupts();
  const tally::Result result = simulate(reading.scene, command.threads);

  const std::string table = command.json ? io::echo_json(result) : io::echo_table(result);
  try {
    write(result, path, command.command_line);
  } catch (const EnvironmentError&) {
    print_out(table);  // all that is left of the run
    throw;
  }
  print_out(table);
  const std::string place = where_it_is(result, path);
  command.json ? print_error(place) : print_out(place);
  return result.partial ? interrupt_exit_code() : done;
}

}  // namespace photic::app
