// The result file: netCDF-4 after CF-1.10
// (https://cfconventions.org/Data/cf-conventions/cf-conventions-1.10/), self-describing, opens in
// xarray. Its layout is documented for users in docs/.
#pragma once

#include <cstdint>
#include <string>

#include "tally/result.hpp"
#include "tally/shape.hpp"

namespace photic::io {

/// The layout's number, in the file as `photic_format`: raised when a program that knows the old
/// layout would misread the new one.
inline constexpr std::int32_t photic_format = 3;

struct WriteInfo {
  std::string history = {};     ///< the origin of the file; see history_line
  std::string scene_file = {};  ///< seen from the folder of the result; empty: not known
  std::string keep_as = {};     ///< see write_atomically
};

/// "2026-01-31T12:00:00Z: photic run ship.toml": the time now (UTC) and the command.
std::string history_line(const std::string& command_line);

/// Writes the result file, whole or not at all. Throws EnvironmentError.
void write_netcdf(const tally::Result& result, const std::string& path, const WriteInfo& info);

/// The effective scene a result file was computed from, as TOML. Throws EnvironmentError if the
/// file cannot be read and InputError if it is not a result of Photic.
std::string read_scene_attribute(const std::string& path);

/// The run of a result file, for one that goes on from it.
struct RunSoFar {
  std::string scene_toml, version, engine, history;
  std::string scene_file;  ///< as in WriteInfo
  std::uint64_t photons = 0;
  double wall_time_s = 0;
};

/// Throws as read_scene_attribute does.
RunSoFar read_run(const std::string& path);

/// The state (tally::Result::state) in a result file of a scene of this shape. Throws as
/// read_scene_attribute does, and InputError for a file without a state or with one of another
/// shape.
tally::TotalsState read_state(const std::string& path, const tally::Shape& shape);

}  // namespace photic::io
