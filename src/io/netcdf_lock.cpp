#include "io/netcdf_lock.hpp"

#include <hdf5.h>

#include <new>

namespace photic::io {

NetcdfLock::NetcdfLock() : lock_(mutex()) { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

bool NetcdfLock::renew() {
  const bool was_free = mutex().try_lock();
  ::new (&mutex()) std::recursive_mutex;  // the old one's owner is no thread of this process
  return was_free;
}

std::recursive_mutex& NetcdfLock::mutex() {
  static std::recursive_mutex of_process;
  return of_process;
}

}  // namespace photic::io
