// The optics of layers, of a scene or of air, as files: netCDF for programs and plots,
// comma-separated values for spreadsheets. Names and units are those of IOP tables, so that what is
// written can be read again.
#pragma once

#include <string>

#include "medium/optical_table.hpp"

namespace photic::io {

/// The origin of a table of optics.
struct OpticsOrigin {
  std::string title;
  std::string scene_toml;  ///< the effective scene; empty: none, for air
  std::string version;     ///< of Photic
  std::string history;     ///< see history_line (io/netcdf.hpp)
};

/// Writes a netCDF-4 file after CF-1.10, whole or not at all. Its layout is documented in
/// docs/guide.md. Throws EnvironmentError.
void write_optics_netcdf(const medium::OpticalTable& table, const OpticsOrigin& origin,
                         const std::string& path);

/// One row for each layer and wavelength after a head of lines that start with '#'; a row holds
/// from its depth down to the next depth, or from its altitude up. Numbers read back to the same
/// value; what is not known is "nan".
std::string optics_csv(const medium::OpticalTable& table, const OpticsOrigin& origin);

/// Writes optics_csv to a file, whole or not at all. Throws EnvironmentError.
void write_optics_csv(const medium::OpticalTable& table, const OpticsOrigin& origin,
                      const std::string& path);

/// The names that files give to edges of layers.
struct EdgeNames {
  std::string axis;     ///< "depth", "altitude"
  std::string first_m;  ///< of the edge that a layer begins with: "depth_m", "altitude_m"
  std::string last_m;   ///< "bottom_depth_m", "top_altitude_m"
  std::string first;    ///< "upper", "lower"
  std::string onwards;  ///< "down", "up"
};
EdgeNames edge_names(const medium::OpticalTable& table);

/// The name of a constituent in files: small letters, digits and underscores. The absorption that
/// comes with phytoplankton is in its absorption, but not in a_phytoplankton_per_m: as in a scene's
/// iop, that is the share which excites fluorescence.
std::string name_in_files(const std::string& constituent);

/// "raman light: source [status]", one for each source.
std::vector<std::string> source_lines(const medium::OpticalTable::Emission& emission);

}  // namespace photic::io
