// Inherent optical properties at depths and wavelengths, as a file holds them.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "optics/data_table.hpp"
#include "scene/netcdf_files.hpp"
#include "scene/node.hpp"

namespace photic::scene {

struct IopGrid {
  std::vector<double> depth_m;        ///< ascending, from 0
  std::vector<double> wavelength_nm;  ///< ascending
  /// By name: a_per_m, one of b_per_m and c_per_m, and those optional ones that the file has; the
  /// wavelength fastest.
  std::map<std::string, std::vector<double>> value;
  /// The place of a value, or of its depth or wavelength: the file, and line and column or the
  /// variable's index.
  std::function<Place(const std::string& name, std::size_t i)> place;

  [[nodiscard]] bool has(const std::string& name) const { return value.contains(name); }
};

/// The names of columns or variables in a file, by those used here; empty: the same.
using IopNames = std::vector<std::pair<std::string, optics::ColumnInFile>>;

/// Reads a file of text with a row for each pair of depth and wavelength, or a netCDF file (.nc)
/// with variables of the dimensions (depth, wavelength). Throws InputError if it is no such grid.
IopGrid read_iop_grid(const std::string& path, const IopNames& names, const NetcdfFiles& netcdf);

}  // namespace photic::scene
