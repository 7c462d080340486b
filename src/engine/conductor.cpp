#include <algorithm>
#include <limits>

#include "engine/batches.hpp"

namespace photic::engine {
namespace {

constexpr std::uint64_t batches_between_targets = 100;  // how often the target is looked at
constexpr double seconds_between_tellings = 0.2;

}  // namespace

Conductor::Conductor(const scene::Simulation& asked, const RunOptions& options)
    : asked_(asked), options_(options) {
  constexpr auto unlimited = std::numeric_limits<std::uint64_t>::max();
  batches_ = asked.photons ? (*asked.photons + batch_photons - 1) / batch_photons : unlimited;
  const auto cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  ending.threads = options.threads > 0 ? options.threads : cores;
}

std::uint64_t Conductor::photons_of(std::uint64_t batch) const {
  return batch + 1 < batches_ ? batch_photons : *asked_.photons - batch * batch_photons;
}

bool Conductor::ends(const tally::Totals& totals, std::uint64_t merged_batches) {
  ending.wall_time_s = elapsed_s();
  tell(totals);
  const auto because = [this](const char* reason) {
    ending.stopped_by = reason;
    return true;
  };
  if (merged_batches == batches_) return because("photons");
  const bool look = merged_batches % batches_between_targets == 0;
  if (look && asked_.target_relative_error && totals.all_converged(*asked_.target_relative_error)) {
    return because("target");
  }
  if (asked_.max_time_s && ending.wall_time_s >= *asked_.max_time_s) return because("time");
  if (options_.interrupt != nullptr && options_.interrupt->load()) return because("interrupt");
  return false;
}

void Conductor::tell(const tally::Totals& totals) {
  const double now = ending.wall_time_s;
  if (!options_.progress || (told_s_ >= 0 && now - told_s_ < seconds_between_tellings)) return;
  told_s_ = now;
  Progress progress;
  progress.photons = totals.photons();
  progress.photons_asked = asked_.photons;
  progress.elapsed_s = now;
  progress.max_time_s = asked_.max_time_s;
  progress.gates_converged = totals.converged_cells();
  progress.gates = totals.scored_cells();
  options_.progress(progress);
}

double Conductor::elapsed_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace photic::engine
