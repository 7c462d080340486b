// The place of a run's result, so that nothing is lost that took longer.
#pragma once

#include <optional>
#include <string>

#include "session/lock.hpp"
#include "session/occupant.hpp"
#include "tally/result.hpp"

namespace photic::session {

/// A place for a result.
struct Place {
  std::string path;
  std::string keep_as;  ///< the new place of what is there; empty: nothing has to be kept
  std::string remark;   ///< for the user; may be empty
};

class Destination {
 public:
  /// `force`: whatever is there is replaced. Throws UsageError if it is clear already that what is
  /// there should not be.
  Destination(std::string path, const Origin& origin, bool force, const FrontEnd& front_end);

  /// Returns the place of this result, as things are now that it is known.
  Place place_of(const tally::Result& result);
  /// A place beside, with a remark that has the reason.
  [[nodiscard]] Place beside(const std::string& why);

 private:
  void expect_room(const Occupant& occupant) const;

  std::string path_, previous_;
  const Origin& origin_;
  bool force_;
  const FrontEnd& front_end_;
  std::optional<Lock> lock_;  ///< of a place beside
};

/// "my.nc" -> "my.previous.nc", beside what a link leads to.
std::string previous_name(const std::string& file);

/// A file in whose place a result of an edited scene goes: what is there is kept under its previous
/// name, unless more photons have that already.
Place kept_before(const std::string& file, const Occupant& there, const Origin& origin);

/// "my.nc" -> "my-2.nc", or the next number from `first` on that is free.
std::string free_name(const std::string& file, int first = 2);

}  // namespace photic::session
