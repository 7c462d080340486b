// The conversion of numbers in a file's units to those that a key of a scene means.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "optics/data_table.hpp"
#include "scene/unit_text.hpp"

namespace photic::scene {

/// To a number in other units.
struct Conversion {
  int decade = 0;  ///< apart from the factor, so that 1 mg/m3 stays 1
  double factor = 1, offset = 0;

  [[nodiscard]] double operator()(double x) const;
};

/// None if they are not of one kind.
[[nodiscard]] std::optional<Conversion> conversion(const Unit& from, const Unit& to);

/// The conversion to the unit that the name of a key ends in (chlorophyll_mg_m3, a_per_m), from the
/// units of a file and, where salinities are absolute, its standard name (CF). None if that is not
/// understood.
[[nodiscard]] std::optional<Conversion> conversion_to(const std::string& key,
                                                      const std::string& units,
                                                      const std::string& standard_name);

/// The unit that the name of a key ends in, as people write it; "1" if it ends in none.
[[nodiscard]] std::string unit_of(const std::string& key);

/// The name of a key without its unit: "wavelength" of "wavelength_nm".
[[nodiscard]] std::string without_its_unit(const std::string& key);

/// A unit that people may give a key in that is in another.
struct OtherUnit {
  const char* name;  ///< "in um"
  double factor = 1, offset = 0;
  double most = std::numeric_limits<double>::infinity();  ///< that people would mean by it

  [[nodiscard]] double operator()(double x) const { return x * factor + offset; }
};

/// The units worth a guess where a value of the key is refused.
[[nodiscard]] std::vector<OtherUnit> other_units_of(const std::string& key);

/// "… are understood": what a file may call units of this key.
[[nodiscard]] std::string understood_for(const std::string& key);

/// Throws InputError where the header of a table says that a column has units that are understood
/// and are not the key's: it would be misread.
void refuse_other_units(const optics::DataTable& table, const std::string& column,
                        const std::string& key);

/// Returns whether a file's salinities are in grams per kilogram (TEOS-10), which are not practical
/// ones.
[[nodiscard]] bool is_absolute_salinity(const std::string& units, const std::string& standard_name);

}  // namespace photic::scene
