# Third-party libraries, each kept to one folder of src/ (docs/architecture.md).
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(netcdf REQUIRED IMPORTED_TARGET netcdf)
# netCDF-4 files are HDF5 files; the same library that netCDF is linked with.
pkg_check_modules(hdf5 REQUIRED IMPORTED_TARGET hdf5-serial)
find_path(BOOST_INCLUDE boost/math/quadrature/gauss_kronrod.hpp REQUIRED)
find_path(TOMLPLUSPLUS_INCLUDE toml++/toml.h REQUIRED)
find_path(CLI11_INCLUDE CLI/CLI.hpp REQUIRED)
# Our generator is held to its original by one test; nothing else needs it.
if(PHOTIC_TESTS)
  find_path(RANDOM123_INCLUDE Random123/philox.h REQUIRED)
endif()
