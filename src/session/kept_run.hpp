// A run that keeps its result in a file: nothing is lost that took longer, and little if it does
// not live to its end.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "io/netcdf.hpp"
#include "session/checkpoint.hpp"
#include "session/destination.hpp"
#include "session/front_end.hpp"
#include "session/lock.hpp"
#include "session/occupant.hpp"
#include "session/ready_run.hpp"
#include "session/run.hpp"

namespace photic::session {

/// The file of a result, and what may be there.
struct ResultFile {
  std::string path;
  std::string scene_file;              ///< empty: not known
  bool force = false;                  ///< whatever is there is replaced
  std::optional<double> checkpoint_s;  ///< time between checkpoints; none: the usual
  bool lets_go = false;                ///< its name is free once the run has ended: see hold()
};

class KeptRun {
 public:
  /// Locks the file's name and begins. Throws UsageError where what is there should stay, or
  /// another run is at work on it, EnvironmentError where it cannot be written.
  KeptRun(const Context& context, ReadyRun ready, const ResultFile& file, FrontEnd front_end);
  KeptRun(const KeptRun&) = delete;
  KeptRun& operator=(const KeptRun&) = delete;
  /// Stops, and waits.
  ~KeptRun();

  [[nodiscard]] Run& run() { return *run_; }

  /// Stops, and waits for the end; nothing is written after it but by write().
  void end();

  /// Keeps the file's name locked from now until the result is written, if it still is.
  void hold();
  /// Makes the file's name free for other runs until write(). Of a run that has ended.
  void let_go();

  /// The places of a result that was written.
  struct Kept {
    std::string path;
    std::string checkpoint;  ///< to go on from, where the result is partial and no netCDF; or empty
  };
  /// Writes the result of the run; beside the file if another run is at work on that by now. Throws
  /// EnvironmentError; then the last checkpoint stays.
  Kept write(const tally::Result& result);
  /// The lines of a result about its origin.
  [[nodiscard]] io::WriteInfo origin() const {
    return {.history = history_, .scene_file = origin_.scene_file};
  }
  /// Reports a checkpoint that holds photons of this scene.
  void report_leftover() const;

 private:
  void report(const std::string& line) const;
  /// Writes checkpoints until the run has ended.
  void keep();
  /// Locks the file's name again; false if another run has it.
  bool take_back();

  FrontEnd front_end_;
  Origin origin_;
  std::string history_;
  std::string path_;
  bool lets_go_;
  std::mutex mutex_;  ///< of the two below
  bool is_held_ = false;
  std::optional<Lock> lock_;
  Destination destination_;
  Checkpoint checkpoint_;
  double first_checkpoint_s_ = 60;     ///< after the start
  double between_checkpoints_s_ = 30;  ///< after the end of the last one
  std::optional<Run> run_;             ///< always there once this is made
  std::jthread keeper_;                ///< the last member: it ends before what it uses
};

}  // namespace photic::session
