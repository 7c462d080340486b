// Runs of Python.
#pragma once

#include <pybind11/numpy.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "documents.hpp"
#include "gil.hpp"
#include "io/describe.hpp"
#include "session/kept_run.hpp"
#include "session/ready_run.hpp"
#include "session/result_file.hpp"
#include "session/run.hpp"

namespace photic::python {

/// The lines of a run for its user, from any of its threads, until one of Python's takes them.
class Lines {
 public:
  void add(const std::string& line) {
    const std::scoped_lock lock(mutex_);
    if (!line.empty()) lines_.push_back(line);
  }
  [[nodiscard]] std::vector<std::string> take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(lines_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<std::string> lines_;
};

/// The keywords of a run in messages.
inline session::Words keywords() {
  return {.output = "output=",
          .force = "force=True",
          .earlier = "continue_from=",
          .photons = "photons=",
          .engine = "engine=",
          .isa = "isa=",
          .before_value = ""};
}

/// A place for a result; none: it stays in memory.
struct Output {
  std::string path;
  std::string scene_file;  ///< empty: none
  bool force = false;
  std::optional<double> checkpoint_s;
};

/// A run in memory, or one that keeps its result in a file.
class RunAtWork {
 public:
  RunAtWork(const session::Context& context, const session::Document& document,
            const session::RunRequest& request, const std::optional<Output>& output) {
    const scene::Reading& reading = document.reading();
    session::ReadyRun ready = session::make_ready(context, reading.scene, request);
    if (output)
      start_kept(context, std::move(ready), file_of(reading, *output, request.earlier));
    else
      start_in_memory(context, std::move(ready));
  }

  [[nodiscard]] session::Run& run() { return kept_ ? kept_->run() : *in_memory_; }

  [[nodiscard]] std::unique_ptr<Arrays> arrays_of(const tally::Result& result) const {
    auto arrays = std::make_unique<Arrays>();
    io::describe(result, kept_ ? kept_->origin() : origin_, *arrays);
    return arrays;
  }

  /// The arrays of the result of a run that has ended, its file, and why that could not be written.
  struct End {
    std::unique_ptr<Arrays> arrays;
    std::string path, failure;
  };
  [[nodiscard]] End finish() {
    hold();
    wait_for_end();
    const tally::Result result = run().result();
    End out{arrays_of(result), "", ""};
    if (!kept_) return out;
    try {
      out.path = kept_->write(result).path;
    } catch (const std::exception& failure) {
      out.failure = failure.what();
      kept_->report_leftover();
    }
    return out;
  }

  /// Stops, and waits for the end. Other runs may write to the file then, until finish().
  void end() {
    wait_for_end();
    if (kept_) kept_->let_go();
  }
  /// Keeps other runs from the file, since finish() is about to come.
  void hold() {
    if (kept_) kept_->hold();
  }
  /// True if nothing has to be waited for.
  [[nodiscard]] bool has_ended() const { return has_ended_; }

  Lines lines;

 private:
  void wait_for_end() {
    if (kept_) kept_->end();
    run().stop();
    while (!run().wait_for(std::chrono::hours(1))) continue;
    has_ended_ = true;
  }

  /// Throws UsageError where the result would replace what it is made of.
  static session::ResultFile file_of(const scene::Reading& reading, const Output& output,
                                     const std::string& earlier) {
    session::ResultFile file{
        .path = session::result_path(output.path, output.scene_file, earlier, keywords()),
        .scene_file = output.scene_file,
        .force = output.force,
        .checkpoint_s = output.checkpoint_s,
        .lets_go = true};
    session::spare(reading.files, file.path, keywords());
    return file;
  }

  void start_kept(const session::Context& context, session::ReadyRun ready,
                  const session::ResultFile& file) {
    kept_.emplace(context, std::move(ready), file,
                  session::FrontEnd{.report = [this](const std::string& line) { lines.add(line); },
                                    .go_on = go_on,
                                    .words = keywords()});
  }

  void start_in_memory(const session::Context& context, session::ReadyRun ready) {
    lines.add(ready.remark);
    origin_.history = std::move(ready.history);
    in_memory_.emplace(context, std::move(ready.scene), std::move(ready.options));
  }

  /// The call that goes on from a result.
  static std::string go_on(const std::string& earlier, const std::string& output) {
    return "scene.run(continue_from=" + scene::quoted(earlier) +
           ", output=" + scene::quoted(output) + ")";
  }

  std::atomic<bool> has_ended_ = false;
  io::WriteInfo origin_;
  std::optional<session::Run> in_memory_;
  std::optional<session::KeptRun> kept_;
};

/// The handle that Python holds. The run stops and is waited for when it is gone.
class Run {
 public:
  Run(const session::Context& context, const Document& document, const session::RunRequest& request,
      const std::optional<Output>& output)
      : work_(without_gil([&] {
          return std::make_unique<RunAtWork>(context, document.now(), request, output);
        })) {}
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  ~Run() {
    if (::getpid() != process_)
      static_cast<void>(work_.release());  // a fork has none of its threads
    else if (!work_->has_ended())          // or a daemon thread would unwind in here (without_gil)
      without_gil([this] { work_.reset(); });
  }

  void stop() noexcept { work_->run().stop(); }
  [[nodiscard]] run::Progress progress() const { return work_->run().progress(); }

  /// Returns whether the run has ended within so many milliseconds; raises what a signal raises.
  bool wait(int milliseconds) {
    const bool ended = without_gil([&] {
      work_->hold();
      return work_->run().wait_for(std::chrono::milliseconds(milliseconds));
    });
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return ended;
  }

  void end() {
    without_gil([&] { work_->end(); });
  }

  /// None before the first batch end, and once the run has ended.
  [[nodiscard]] py::object so_far() {
    auto arrays = without_gil([&]() -> std::unique_ptr<Arrays> {
      const auto result = work_->run().so_far();
      return result ? work_->arrays_of(*result) : nullptr;
    });
    return arrays ? py::object(arrays->hand_over()) : py::none();
  }

  /// (arrays, file, why it could not be written), the same at every call; None if the run was
  /// stopped before there was anything.
  [[nodiscard]] py::object finish() {
    if (!end_) end_ = ended();
    if (!*end_) return py::none();
    const RunAtWork::End& end = **end_;
    return py::make_tuple(end.arrays->hand_over(), text_of(end.path), text_of(end.failure));
  }

  /// The lines for the user since the last call.
  [[nodiscard]] py::list lines() {
    py::list out;
    for (const std::string& line : work_->lines.take()) out.append(text_of(line));
    return out;
  }

 private:
  using End = std::optional<RunAtWork::End>;
  /// None if the run was stopped before there was anything.
  [[nodiscard]] End ended() {
    return without_gil([&]() -> End {
      try {
        return work_->finish();
      } catch (const run::StoppedBeforeFirstBatch&) {
        return std::nullopt;
      }
    });
  }

  pid_t process_ = ::getpid();
  std::unique_ptr<RunAtWork> work_;
  std::optional<End> end_;
};

}  // namespace photic::python
