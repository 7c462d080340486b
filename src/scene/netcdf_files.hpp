// The interface of the reader of scenes to netCDF files. The library that reads them has its place
// on a higher floor, which hands this down (io/netcdf_variable.hpp).
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace photic::scene {

/// The description of a variable, read before its values.
struct NetcdfHeader {
  std::vector<std::string> dimension;                 ///< without that of the characters of texts
  std::vector<std::size_t> length;                    ///< of each dimension
  std::map<std::string, std::string> attribute = {};  ///< those that are texts and matter here
  bool has_numbers = true;
  bool has_flags = false;  ///< has flag_values, flag_masks or flag_meanings

  /// Empty if there is none.
  [[nodiscard]] std::string text(const std::string& name) const;
};

struct NetcdfContents {
  std::map<std::string, std::size_t> dimension;  ///< the length of each
  std::map<std::string, NetcdfHeader> variable;
};

/// A variable of numbers. Missing values are NaN. Texts are attributes, empty if there are none.
struct NetcdfVariable {
  std::vector<std::string> dimension;
  std::vector<std::size_t> length;  ///< of each dimension
  std::string units;
  std::vector<double> value;  ///< the last dimension fastest
  std::string standard_name = {};
  std::string positive = {};  ///< up or down, of depths
};

/// A variable of which many values are the same: flags, names of casts.
struct NetcdfCodes {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::vector<std::string> dimension;
  std::vector<std::size_t> length;
  std::vector<double> number = {};      ///< the different values, ascending, if all are numbers
  std::vector<std::string> text = {};   ///< the different values, ascending, else
  std::vector<std::size_t> value = {};  ///< which of them each is; none where it is missing

  // The meanings of flags (CF-1.10, section 3.5): empty without these attributes.
  std::vector<std::string> flag_values = {};
  std::vector<double> flag_masks = {};
  std::vector<std::string> flag_meanings = {};  ///< one text, or as many as there are meanings

  [[nodiscard]] std::size_t size() const { return number.size() + text.size(); }
  /// One of the different values.
  [[nodiscard]] std::string code(std::size_t i) const;
  /// The same for messages.
  [[nodiscard]] std::string code_text(std::size_t i) const;
};

/// All throw InputError for a file of no use, EnvironmentError for one that cannot be read.
struct NetcdfFiles {
  std::function<NetcdfContents(const std::string& path)> contents;
  std::function<NetcdfVariable(const std::string& path, const std::string& name)> read;
  /// A variable of numbers or of texts.
  std::function<NetcdfCodes(const std::string& path, const std::string& name)> codes;
};

/// The same, each list and variable being read once and kept: environments ask for them again.
[[nodiscard]] NetcdfFiles read_once(const NetcdfFiles& files);

}  // namespace photic::scene
