// Speed and efficiency of a scene:
//   build/dev/benchmarks/scene_benchmark SCENE [photons] [threads] [--set-like overrides…]
// Prints photons/s, collisions/s, peak memory, and per gate the figure of merit 1 / (relative
// variance x CPU seconds), from the scatter of independent repeats. Gates that any repeat flags
// have none: a variance that has not converged makes every estimator look good.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "run/run.hpp"
#include "scene/read.hpp"
#include "support/tables.hpp"

namespace {

constexpr std::uint64_t repeats = 10;

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

int benchmark(int argc, char** argv) {
  const double photons = argc > 2 ? std::strtod(argv[2], nullptr) : 1e6;
  const int threads = argc > 3 ? std::atoi(argv[3]) : 1;
  auto scene = photic::scene::read_scene(
                   argv[1], std::vector<std::string>(argv + std::min(argc, 4), argv + argc))
                   .scene;
  scene.simulation.photons = static_cast<std::uint64_t>(photons);
  photic::run::RunOptions options;
  options.threads = threads;

  std::vector<photic::tally::Result> results;
  double wall = 0;
  const double cpu_before = cpu_seconds();
  for (std::uint64_t i = 0; i < repeats; ++i) {
    scene.simulation.seed = 100 + i;
    results.push_back(photic::run::run(scene, *photic::test::tables(), options));
    wall += results.back().wall_time_s;
  }
  const double cpu = cpu_seconds() - cpu_before;
  double collisions = 0;
  for (const auto& r : results) collisions += static_cast<double>(r.collisions);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print(
      "{} x {:.3g} photons on {} threads: {:.3g} photons/s, {:.3g} collisions/s, {:.2f} CPU s, "
      "{:.0f} MB\n",
      repeats, photons, threads, static_cast<double>(repeats) * photons / wall, collisions / wall,
      cpu, static_cast<double>(usage.ru_maxrss) / 1024);

  const auto& first = results.front();
  const std::size_t gates = first.gates();
  for (std::size_t cell = 0; cell < first.echo.mean.size();
       cell += std::max<std::size_t>(1, gates / 20)) {
    double mean = 0;
    double variance = 0;
    bool flagged = false;
    for (const auto& r : results) {
      mean += r.echo.mean[cell] / static_cast<double>(repeats);
      flagged = flagged || r.convergence_flags[cell] != 0;
    }
    for (const auto& r : results)
      variance += std::pow(r.echo.mean[cell] - mean, 2) / static_cast<double>(repeats - 1);
    const std::size_t channel = cell / gates % first.channels();
    const double depth = first.gate_depth_m(cell / gates / first.channels(), channel, cell % gates);
    const double merit = mean * mean / (variance * cpu / static_cast<double>(repeats));
    fmt::print("{:12} {:7.2f} m  echo {:10.4e}  {}\n", first.channel_name[channel], depth, mean,
               flagged ? "not converged" : fmt::format("figure of merit {:.3g}", merit));
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: scene_benchmark SCENE [photons] [threads] [path=value …]\n");
    return 2;
  }
  try {
    return benchmark(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
