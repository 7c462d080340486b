#include "io/netcdf_lock.hpp"

#include <hdf5.h>

namespace photic::io {

NetcdfLock::NetcdfLock() : lock_(mutex()) { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

std::recursive_mutex& NetcdfLock::mutex() {
  static std::recursive_mutex of_process;
  return of_process;
}

}  // namespace photic::io
