// Where a run's result goes, so that nothing is lost that took longer.
#pragma once

#include <optional>
#include <string>

#include "photic/lock.hpp"
#include "photic/occupant.hpp"
#include "tally/result.hpp"

namespace photic::app {

/// A place for a result.
struct Place {
  std::string path;
  std::string keep_as;  ///< where what is there goes; empty: nothing has to be kept
  std::string remark;   ///< a line for the user; may be empty
};

class Destination {
 public:
  /// `force`: whatever is there is replaced. Throws UsageError if it is clear already that what is
  /// there should not be.
  Destination(std::string path, const Origin& origin, bool force);

  /// Where this result goes, as things are now that it is known.
  Place place_of(const tally::Result& result);

 private:
  [[nodiscard]] Place beside(const std::string& why);
  void expect_room(const Occupant& occupant) const;

  std::string path_, previous_;
  const Origin& origin_;
  bool force_;
  std::optional<Lock> lock_;  ///< of a place beside
};

/// "my.nc" -> "my.previous.nc", beside what a link leads to.
std::string previous_name(const std::string& file);

/// One line that tells where what a file held before has gone.
std::string kept_line(const std::string& file);

/// "my.nc" -> "my-2.nc", or the next number that is free.
std::string free_name(const std::string& file);

}  // namespace photic::app
