#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/error.hpp"
#include "run/batches.hpp"

namespace photic::run {
namespace {

// Batches until the target is first looked at, which doubles until it is so many.
constexpr std::uint64_t first_look = 32, between_looks = 128;
constexpr double seconds_between_counts = 0.2;

[[noreturn]] void refuse(const Start& start, const std::string& reason,
                         const std::string& suggestion) {
  throw InputError({{.file = start.file, .reason = reason, .suggestion = suggestion}});
}

}  // namespace

RunControl::RunControl(const scene::Simulation& asked, const RunOptions& options,
                       std::optional<std::uint64_t> photons_each)
    : asked_(asked),
      options_(options),
      spread_photons_(estimator::batch_photons(asked)),
      batch_photons_(photons_each.value_or(spread_photons_)) {
  constexpr auto unlimited = std::numeric_limits<std::uint64_t>::max();
  batches_ = asked.photons ? (*asked.photons + batch_photons_ - 1) / batch_photons_ : unlimited;
  const auto cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  ending.threads = options.threads > 0 ? options.threads : cores;
  if (options.start) ending.wall_time_before_s = options.start->wall_time_s;
}

std::uint64_t RunControl::photons_of(std::uint64_t batch) const {
  return batch + 1 < batches_ ? batch_photons_ : *asked_.photons - batch * batch_photons_;
}

std::uint64_t RunControl::known_until(std::uint64_t merged_batches) const {
  if (!rests()) return std::numeric_limits<std::uint64_t>::max();
  return look_after(look_after(merged_batches));
}

std::vector<bool> RunControl::resting(const tally::Totals& totals, std::uint64_t batch,
                                      std::uint64_t merged_batches) const {
  return totals.resting(batch >= look_after(merged_batches));
}

std::uint64_t RunControl::look_after(std::uint64_t merged_batches) {
  for (std::uint64_t look = first_look; look < between_looks; look *= 2)
    if (merged_batches < look) return look;
  return (merged_batches / between_looks + 1) * between_looks;
}

bool RunControl::is_look(std::uint64_t merged_batches) {
  return merged_batches > 0 && look_after(merged_batches - 1) == merged_batches;
}

void RunControl::look(tally::Totals& totals, std::uint64_t merged_batches) const {
  if (is_look(merged_batches)) totals.decide_rests();
}

bool RunControl::rests() const {
  return asked_.target_relative_error && asked_.estimator == scene::Estimator::bidirectional;
}

tally::Totals RunControl::begin(const tally::Shape& shape) const {
  tally::Totals totals = goes_on_from(shape);
  totals.let_rest_at(rests() ? *asked_.target_relative_error : 0.0);
  return totals;
}

tally::Totals RunControl::goes_on_from(const tally::Shape& shape) const {
  if (!options_.start) return tally::Totals(shape);
  const tally::TotalsState& state = options_.start->state;
  if (state.photons % batch_photons_ != 0 || state.photons / batch_photons_ != state.batches) {
    refuse(*options_.start,
           fmt::format("a damaged result, or one of another build: {} photons in {} batches",
                       state.photons, state.batches),
           "");
  }
  expect(state.batches <= batches_, "a run that goes on is not shorter than what it goes on from");
  return {shape, state};
}

void RunControl::check_start(const tally::Shape& shape, const tally::BatchTally& first) const {
  tally::Totals totals(shape);
  totals.merge(first);
  // Versions and scenes that read the same may still differ in what lies behind them: the build,
  // the data tables. The echo of the first batch shows it.
  const auto& echo = totals.state().snapshot_echo;
  if (std::equal(echo.begin(), echo.end(), options_.start->state.snapshot_echo.begin())) return;
  refuse(*options_.start,
         "made by another build of Photic, or with other data tables: its first photons scored "
         "differently",
         "continue with those, or start anew");
}

bool RunControl::ends(const tally::Totals& totals, std::uint64_t merged_batches) {
  ending.wall_time_s = elapsed_s();
  report(totals);
  const auto because = [this](const char* reason) {
    ending.stopped_by = reason;
    return true;
  };
  if (merged_batches == batches_) return because("photons");
  if (is_look(merged_batches) && asked_.target_relative_error &&
      totals.all_converged(*asked_.target_relative_error)) {
    return because("target");
  }
  if (asked_.max_time_s && ending.wall_time_s >= *asked_.max_time_s) return because("time");
  return stop().stop_requested() && because("interrupt");
}

void RunControl::report(const tally::Totals& totals) {
  if (shown_to == nullptr) return;
  shown_to->update([&](Progress& progress) {
    progress.photons = totals.photons();
    progress.elapsed_s = ending.wall_time_s;
  });
  if (counted_s_ && ending.wall_time_s - *counted_s_ < seconds_between_counts) return;
  counted_s_ = ending.wall_time_s;
  const std::size_t converged = totals.converged_cells(), gates = totals.scored_cells();
  const double worst = totals.worst_error();
  shown_to->update([&](Progress& progress) {
    progress.gates_converged = converged;
    progress.gates = gates;
    progress.worst_error = worst;
  });
}

double RunControl::elapsed_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace photic::run
