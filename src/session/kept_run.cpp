#include "session/kept_run.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "session/result_file.hpp"

namespace photic::session {
namespace {

Origin origin_of(const Context& context, const ReadyRun& ready, const ResultFile& file) {
  const std::string& scene_file =
      file.scene_file.empty() ? ready.earlier_scene_file : file.scene_file;
  return {context.library, ready.scene, scene_file.empty() ? "" : seen_from(file.path, scene_file)};
}

/// The path of a file that can be written now, not after hours of work.
const std::string& writable(const std::string& path) {
  io::check_writable(path);
  return path;
}

std::chrono::milliseconds in_milliseconds(double seconds) {
  constexpr double longest_s = 1e9;  // a clock in nanoseconds holds no more than ten times this
  const std::chrono::duration<double> time(std::min(seconds, longest_s));
  return std::chrono::ceil<std::chrono::milliseconds>(time);
}

}  // namespace

KeptRun::KeptRun(const Context& context, ReadyRun ready, const ResultFile& file, FrontEnd front_end)
    : front_end_(std::move(front_end)),
      origin_(origin_of(context, ready, file)),
      history_(std::move(ready.history)),
      path_(file.path),
      lets_go_(file.lets_go),
      lock_(std::in_place, writable(path_), front_end_),
      destination_(file.path, origin_, file.force, front_end_),
      checkpoint_(file.path, origin_, history_, front_end_) {
  if (file.checkpoint_s) first_checkpoint_s_ = between_checkpoints_s_ = *file.checkpoint_s;
  report(ready.remark);
  report(checkpoint_.leftover(ready.photons_before));
  run_.emplace(context, std::move(ready.scene), std::move(ready.options));
  keeper_ = std::jthread([this] { keep(); });
}

KeptRun::~KeptRun() {
  run_->stop();  // the keeper waits for its end
}

void KeptRun::end() {
  run_->stop();
  keeper_ = {};  // joined: it waits for the run's end
}

void KeptRun::hold() {
  const std::scoped_lock lock(mutex_);
  is_held_ = true;
}

void KeptRun::let_go() {
  const std::scoped_lock lock(mutex_);
  lock_.reset();
}

bool KeptRun::take_back() {
  const std::scoped_lock lock(mutex_);
  if (lock_) return true;
  try {
    lock_.emplace(path_, front_end_);
  } catch (const UsageError&) {
    return false;
  }
  return true;
}

void KeptRun::report(const std::string& line) const {
  if (!line.empty()) front_end_.report(line);
}

void KeptRun::keep() {
  for (double pause_s = first_checkpoint_s_; !run_->wait_for(in_milliseconds(pause_s));
       pause_s = between_checkpoints_s_)
    if (const auto so_far = run_->so_far(true)) checkpoint_.write(*so_far);
  const std::scoped_lock lock(mutex_);
  if (lets_go_ && !is_held_) lock_.reset();
}

KeptRun::Kept KeptRun::write(const tally::Result& result) {
  keeper_ = {};  // joined: it writes no more
  const bool is_ours = take_back();
  const Place place =
      is_ours ? destination_.place_of(result) : destination_.beside("another run is at work on it");
  session::write(result, place.path,
                 {.history = history_, .scene_file = origin_.scene_file, .keep_as = place.keep_as});
  report(place.remark);
  return {place.path, is_ours ? checkpoint_.finish(result) : ""};
}

void KeptRun::report_leftover() const { report(checkpoint_.leftover(0)); }

}  // namespace photic::session
