// Echoes and tallies as text: comma-separated values for spreadsheets, the printed table for
// people. All other results of a run are in the netCDF file (io/netcdf.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tally/result.hpp"

namespace photic::io {

/// One row for each telescope, channel and gate, after a head of lines that start with '#'. Fields
/// are quoted as in RFC 4180 (also those holding '#'); numbers read back to the same value; what is
/// not a number is "nan". The rows of environments follow those of the scene; three more columns
/// then name them and hold their differences. The rows of parameters come last: the scene's, with
/// the derivatives in five columns of their own and the convergence of these. The cells of tallies
/// beside echoes follow in the same way, with columns of their own (io/tally_csv.hpp); without
/// echoes these are all there is.
std::string echo_csv(const tally::Result& result);

/// Writes echo_csv to a file, whole or not at all; `keep_as` as in write_atomically. Throws
/// EnvironmentError.
void write_csv(const tally::Result& result, const std::string& path,
               const std::string& keep_as = "");

/// The same of echo_table with all gates and columns, after the two lines that say which run it is
/// of.
void write_table(const tally::Result& result, const std::string& path,
                 const std::string& keep_as = "");

/// The number of photons according to a file that write_csv or write_table wrote; nothing if it is
/// another file.
std::optional<std::uint64_t> photons_in_text(const std::string& path);

}  // namespace photic::io
