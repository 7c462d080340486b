// Runs histories in batches on threads. A batch is the unit of statistics, of parallelism and of
// reproducibility: batch k holds the k-th lot of photons, whoever computes them, and
// batches are merged in their order; what ends a run is looked at there too.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/stop.hpp"
#include "estimator/model.hpp"
#include "run/run.hpp"
#include "scene/tally_memory.hpp"
#include "schedule/simulator.hpp"
#include "tally/totals.hpp"

namespace photic::run {

/// The end of a run.
struct Ending {
  std::string stopped_by = "photons";  ///< photons | target | time | interrupt
  double wall_time_s = 0;              ///< of this sitting
  double wall_time_before_s = 0;       ///< of earlier ones
  int threads = 0;
  std::optional<tally::TotalsState> whole;  ///< before an incomplete batch, if the run had one
};

/// Decides after each batch whether the run goes on, and reports its progress.
class RunControl {
 public:
  /// `photons_each`: the photons of a batch, if it is to have fewer than begin evenly spread, so
  /// that a short run has batches enough to estimate its errors.
  RunControl(const scene::Simulation& asked, const RunOptions& options,
             std::optional<std::uint64_t> photons_each = {});
  RunControl(const scene::Simulation& asked, RunOptions&& options,
             std::optional<std::uint64_t> photons_each = {}) = delete;  ///< it keeps them

  /// Batches that the photons asked for make; no limit if none were asked for.
  [[nodiscard]] std::uint64_t batches() const { return batches_; }
  [[nodiscard]] std::uint64_t first_photon_of(std::uint64_t batch) const {
    return batch * spread_photons_;
  }
  [[nodiscard]] std::uint64_t photons_of(std::uint64_t batch) const;
  /// Returns whether a batch has as many photons as all but a last one.
  [[nodiscard]] bool is_whole(const tally::BatchTally& batch) const {
    return batch.photons == batch_photons_;
  }

  /// The state that the run goes on from: nothing yet, or where an earlier one stood.
  [[nodiscard]] tally::Totals begin(const tally::Shape& shape) const;
  /// Throws InputError unless an earlier run began with the batch at hand, the first of this one.
  void check_start(const tally::Shape& shape, const tally::BatchTally& first) const;

  /// Batches below this one can begin: which rows rest in them is known.
  [[nodiscard]] std::uint64_t known_until(std::uint64_t merged_batches) const;
  /// The rows that rest in a batch that can begin.
  [[nodiscard]] std::vector<bool> resting(const tally::Totals& totals, std::uint64_t batch,
                                          std::uint64_t merged_batches) const;

  /// Called before an incomplete batch is merged.
  void keep_whole(const tally::Totals& totals) { ending.whole = totals.state(); }
  /// Called after every merge: lets converged rows rest at looks at the target.
  void look(tally::Totals& totals, std::uint64_t merged_batches) const;
  /// Called after that; true ends the run, and Ending says why.
  bool ends(const tally::Totals& totals, std::uint64_t merged_batches);
  /// Called if the run is stopped within a batch.
  void broken_off() { ending.stopped_by = "interrupt"; }

  [[nodiscard]] std::stop_token stop() const { return options_.stop(); }
  [[nodiscard]] Permits* permits() const { return options_.permits.get(); }

  Ending ending;
  Monitor* shown_to = nullptr;  ///< pilots are not shown

 private:
  /// Returns whether rows rest that have met the target: where light that is not asked for is not
  /// walked.
  [[nodiscard]] bool rests() const;
  /// After how many batches the target is looked at next.
  [[nodiscard]] static std::uint64_t look_after(std::uint64_t merged_batches);
  /// Returns whether it is looked at after so many.
  [[nodiscard]] static bool is_look(std::uint64_t merged_batches);
  [[nodiscard]] tally::Totals goes_on_from(const tally::Shape& shape) const;
  void report(const tally::Totals& totals);
  [[nodiscard]] double elapsed_s() const;

  scene::Simulation asked_;
  const RunOptions& options_;
  std::uint64_t spread_photons_, batch_photons_, batches_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::optional<double> counted_s_;  ///< when gates were
};

/// The threads of one run.
class BatchRunner {
 public:
  BatchRunner(const estimator::Model& model, const schedule::Simulator& simulator,
              RunControl& control)
      : shape_(model.shape),
        simulator_(simulator),
        control_(control),
        totals_(control.begin(model.shape)),
        next_batch_(totals_.state().batches),
        merged_(next_batch_) {
    for (int i = 0; i < tallies(model.scene, control.ending.threads); ++i)
      free_.push_back(std::make_unique<tally::BatchTally>(model.shape, model.gates));
  }

  tally::Totals run() {
    const std::stop_callback stopped(control_.stop(), [this] { unwanted_.request_stop(); });
    if (merged_ > 0) take_up();
    std::vector<std::jthread> workers;
    for (int i = 0; i < control_.ending.threads; ++i) workers.emplace_back([this] { work(); });
    workers.clear();
    if (failure_) std::rethrow_exception(failure_);
    return std::move(totals_);
  }

  /// A run on its way.
  struct SoFar {
    tally::Totals totals;
    Ending ending;
  };
  /// A copy for another thread; none before the first batch end, nor at the end of the run.
  std::optional<SoFar> so_far() {
    const std::scoped_lock lock(mutex_);
    if (ended_ || merged_ == 0) return std::nullopt;
    return SoFar{totals_, control_.ending};
  }

 private:
  using Tally = std::unique_ptr<tally::BatchTally>;

  /// Spare tallies let a fast thread run ahead of the one whose batch is due; where there is no
  /// memory for more, threads wait for each other.
  static int tallies(const scene::Scene& scene, int threads) {
    const scene::TallyMemory memory = scene::tally_memory(scene);
    const double room = (scene::max_tally_memory - memory.bytes()) / memory.batch;
    return static_cast<int>(std::clamp(2 + room, 2.0, 2.0 * threads));
  }

  void work() {
    try {
      std::unique_lock lock(mutex_);
      while (true) {
        changed_.wait(lock, [this] { return ended_ || (!free_.empty() && is_known()); });
        if (ended_ || next_batch_ == control_.batches()) return;
        const std::uint64_t batch = next_batch_++;
        Tally tally = std::move(free_.back());
        free_.pop_back();
        tally->rests = control_.resting(totals_, batch, merged_);
        lock.unlock();
        simulate(batch, *tally);
        lock.lock();
        done_.emplace(batch, std::move(tally));
        merge_what_is_due();
        changed_.notify_all();
      }
    } catch (const Stopped&) {
      const std::scoped_lock lock(mutex_);
      break_off();
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      failure_ = std::current_exception();
      end();
    }
  }
  /// Ends the run within a batch, unless it has ended.
  void break_off() {
    if (!ended_) control_.broken_off();
    end();
  }
  /// Batches that are still under way are broken off: nobody wants them.
  void end() {
    ended_ = true;
    unwanted_.request_stop();
    changed_.notify_all();
  }

  /// Goes on from an earlier run, which may have been as long as this one is to be.
  void take_up() {
    try {
      simulate(0, *free_.front());
    } catch (const Stopped&) {
      const std::scoped_lock lock(mutex_);
      return break_off();
    }
    control_.check_start(shape_, *free_.front());
    free_.front()->clear();
    const std::scoped_lock lock(mutex_);
    if (control_.ends(totals_, merged_)) end();
  }

  [[nodiscard]] bool is_known() const { return next_batch_ < control_.known_until(merged_); }

  void simulate(std::uint64_t batch, tally::BatchTally& tally) const {
    const std::stop_token unwanted = unwanted_.get_token();
    const Permit permit(control_.permits(), unwanted);
    tally.photons = control_.photons_of(batch);
    simulator_.simulate(control_.first_photon_of(batch), tally.photons, tally, unwanted);
  }

  void merge_what_is_due() {
    for (auto due = done_.find(merged_); due != done_.end() && !ended_; due = done_.find(merged_)) {
      Tally tally = std::move(due->second);
      done_.erase(due);
      if (!control_.is_whole(*tally)) {
        free_.clear();  // it is the last one: none but this is needed any more
        control_.keep_whole(totals_);
      }
      totals_.merge(*tally);
      tally->clear();
      free_.push_back(std::move(tally));
      ++merged_;
      control_.look(totals_, merged_);
      if (control_.ends(totals_, merged_)) end();
    }
  }

  const tally::Shape& shape_;
  const schedule::Simulator& simulator_;
  RunControl& control_;
  tally::Totals totals_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Tally> free_;
  std::map<std::uint64_t, Tally> done_;
  std::uint64_t next_batch_, merged_;
  bool ended_ = false;
  std::stop_source unwanted_;  ///< asked to stop at the end of the run
  std::exception_ptr failure_;
};

/// Runs a model in lanes, or by the scalar engine. Throws Stopped before the first batch alone.
tally::Totals run_batches(const estimator::Model& model, RunControl& control,
                          const std::optional<Isa>& lanes);

}  // namespace photic::run
