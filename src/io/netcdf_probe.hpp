// Damaged files on which HDF5 crashes, found out where a crash takes nothing with it.
#pragma once

#include <string>

namespace photic::io {

/// Opens and reads a netCDF file in a process that is forked for it: HDF5 1.10 writes beyond its
/// memory in some damaged files, even where it reports an error. Throws as NetcdfReader does, and
/// InputError for a file that ends that process. Where no process can be forked, it finds nothing.
/// `groups`: those within the file's first one are read, too, as by a run that goes on.
void expect_netcdf(const std::string& path, bool groups);

}  // namespace photic::io
