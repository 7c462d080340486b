#include "session/run.hpp"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "core/error.hpp"

namespace photic::session {

struct Run::Work {
  Work(const Context& of, scene::Scene what, run::RunOptions how)
      : context(of), scene(std::move(what)), options(std::move(how)) {
    options.monitor = &monitor;
    options.permits = context.permits;
  }

  void simulate() {
    try {
      result = run::run(scene, *context.library, options);
    } catch (...) {
      failure = std::current_exception();
    }
    const std::scoped_lock lock(mutex);
    has_ended = true;
    end.notify_all();
  }

  Context context;
  scene::Scene scene;
  run::RunOptions options;
  run::Monitor monitor;
  std::optional<tally::Result> result;
  std::exception_ptr failure;
  mutable std::mutex mutex;
  std::condition_variable end;
  bool has_ended = false;
  std::jthread thread;  // the last member: it ends before what it uses
};

Run::Run(const Context& context, scene::Scene scene, run::RunOptions options)
    : work_(std::make_unique<Work>(context, std::move(scene), std::move(options))) {
  work_->thread = std::jthread([work = work_.get()] { work->simulate(); });
}

Run::~Run() { stop(); }

void Run::stop() noexcept { work_->monitor.stop(); }

run::Progress Run::progress() const { return work_->monitor.progress(); }

std::optional<tally::Result> Run::so_far(bool with_state) {
  return work_->monitor.so_far(with_state);
}

bool Run::wait_for(std::chrono::milliseconds time) const {
  std::unique_lock lock(work_->mutex);
  return work_->end.wait_for(lock, time, [this] { return work_->has_ended; });
}

tally::Result Run::result() {
  std::unique_lock lock(work_->mutex);
  work_->end.wait(lock, [this] { return work_->has_ended; });
  if (work_->failure) std::rethrow_exception(work_->failure);
  expect(work_->result.has_value(), "the result of a run is asked for once");
  tally::Result result = std::move(*work_->result);
  work_->result.reset();
  return result;
}

}  // namespace photic::session
