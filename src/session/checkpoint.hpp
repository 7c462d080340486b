// The checkpoint of a run: its result so far, in out.checkpoint.nc beside the result that
// is to be.
#pragma once

#include <cstdint>
#include <string>

#include "session/front_end.hpp"
#include "session/occupant.hpp"
#include "tally/result.hpp"

namespace photic::session {

/// The result that a checkpoint is beside: "out.checkpoint.nc" -> "out.nc"; other names as they
/// are.
std::string without_checkpoint(const std::string& file);

class Checkpoint {
 public:
  /// The checkpoint of a run that will write `result`. `history` is that of the result.
  Checkpoint(const std::string& result, const Origin& origin, std::string history,
             const FrontEnd& front_end);

  /// Returns one line on how to go on from the file, if a run of this scene left more than
  /// `photons` there; else empty.
  [[nodiscard]] std::string leftover(std::uint64_t photons) const;

  /// Writes the result so far, but never over more photons of the same scene, nor over a result of
  /// another scene file: then it is written beside that, with a warning. A failure is reported
  /// once, and leaves the last good checkpoint.
  void write(const tally::Result& so_far);

  /// Removes what the result, now written, holds as well. A partial result that no run can go on
  /// from leaves the checkpoint; then its path is returned.
  std::string finish(const tally::Result& result);

 private:
  std::string take_place();

  std::string result_, path_, history_;
  const Origin& origin_;
  const FrontEnd& front_end_;
  std::uint64_t photons_ = 0;  ///< of this scene that the file holds
  bool ours_ = false;          ///< true if this run has written the file
  bool warned_ = false;
};

}  // namespace photic::session
