// One thread at a time in netCDF and HDF5: netCDF-C 4.9 is not safe for threads, in whatever files
// they are. Two threads that read results at once found good ones to be none.
#pragma once

#include <mutex>

namespace photic::io {

/// Held while a file is open or made; a thread may hold several. HDF5 prints nothing in threads
/// that have held one: it would report all that netCDF looks for in vain in good files.
class NetcdfLock {
 public:
  NetcdfLock();

  /// Makes it free in a process that was forked, in which no thread holds it. Returns whether it
  /// was free before; if not, another thread may have left netCDF amid its work.
  static bool renew();

 private:
  static std::recursive_mutex& mutex();

  std::scoped_lock<std::recursive_mutex> lock_;
};

}  // namespace photic::io
