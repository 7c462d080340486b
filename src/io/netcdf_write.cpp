#include <filesystem>
#include <vector>

#include "io/atomic_file.hpp"
#include "io/describe.hpp"
#include "io/netcdf_image.hpp"
#include "io/netcdf_state.hpp"

namespace photic::io {
namespace {

std::vector<tally::Grid> grids_of(const tally::Result& result) {
  std::vector<tally::Grid> out;
  for (const auto& grid : result.grids) out.push_back(grid.grid);
  return out;
}

template <class Table>
std::string netcdf_of(const Table& table, const OpticsOrigin& origin) {
  NetcdfImage file;
  describe(table, origin, file);
  return file.finish();
}

}  // namespace

void write_netcdf(const tally::Result& result, const std::string& path, const WriteInfo& info) {
  NetcdfImage file;
  describe(result, info, file);
  if (result.state) add_state(file, *result.state, grids_of(result));
  write_atomically(path, file.finish(), info.keep_as);
}

void write_optics_netcdf(const medium::OpticalTable& table, const OpticsOrigin& origin,
                         const std::string& path) {
  write_atomically(path, netcdf_of(table, origin));
}

void write_spectral(const SpectralTable& table, const OpticsOrigin& origin,
                    const std::string& path) {
  const bool netcdf = std::filesystem::path(path).extension() == ".nc";
  write_atomically(path, netcdf ? netcdf_of(table, origin) : spectral_csv(table, origin));
}

}  // namespace photic::io
