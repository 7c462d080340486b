// One run at a time writes a result: a lock on its name that ends with the process, however that
// ends.
#pragma once

#include <string>

#include "session/front_end.hpp"

namespace photic::session {

/// Held from its making to its end. The name stands for the result, its checkpoint, and a CSV of
/// the same name.
class Lock {
 public:
  /// Throws UsageError, which names the process, if a run has it already. Where files cannot be
  /// locked, one line reports that, and there is no lock.
  Lock(const std::string& result, const FrontEnd& front_end);
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  ~Lock();

 private:
  std::string path_;
  int file_ = -1;
};

}  // namespace photic::session
