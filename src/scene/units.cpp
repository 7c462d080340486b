#include "scene/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "core/error.hpp"
#include "scene/unit_text.hpp"

namespace photic::scene {
namespace {

/// The unit by the end of a key's name, the longer ends first. Files may give those that have a
/// `unit`, a product of others, in other units of the same kind.
struct KeyUnit {
  const char* ending;
  const char* text;
  std::optional<Unit> unit = {};
  const char* understood = "";
};

constexpr const char* masses =
    "units of mass per volume are understood, as \"mg m-3\" and \"ug/l\"";
constexpr const char* lengths = "units of length are understood, as \"m\"";
constexpr std::array key_units{
    KeyUnit{"_m2_per_mg", "m2/mg"},
    KeyUnit{"_m2_per_g", "m2/g"},
    KeyUnit{"_per_nm", "1/nm"},
    KeyUnit{"_per_km", "1/km"},
    KeyUnit{"_per_cm3", "1/cm3"},
    KeyUnit{"_per_sr", "1/sr"},
    KeyUnit{"_per_m", "1/m", Unit{0, 0, -1, 0}, "units of 1/length are understood, as \"m-1\""},
    KeyUnit{"_mg_m3", "mg/m3", Unit{-3, 1, -3, 0}, masses},
    KeyUnit{"_g_m3", "g/m3", Unit{0, 1, -3, 0}, masses},
    KeyUnit{"_mrad", "mrad"},
    KeyUnit{"_deg", "deg"},
    KeyUnit{"_psu", "PSU"},
    KeyUnit{"_nm", "nm", Unit{-9, 0, 1, 0}, "units of length are understood, as \"nm\" and \"um\""},
    KeyUnit{"_um", "um"},
    KeyUnit{"_km", "km"},
    KeyUnit{"_hpa", "hPa"},
    KeyUnit{"_k", "K"},
    KeyUnit{"_percent", "%"},
    KeyUnit{"_ns", "ns"},
    KeyUnit{"_c", "degrees Celsius"},
    KeyUnit{"_m", "m", Unit{0, 0, 1, 0}, lengths},
    KeyUnit{"_m_s", "m/s"},
    KeyUnit{"_s", "s"},
    KeyUnit{"_j", "J"},
    KeyUnit{"_w", "W"},
    KeyUnit{"_w_m2", "W/m2"}};

const KeyUnit* key_unit(const std::string& key) {
  const auto found = std::find_if(key_units.begin(), key_units.end(),
                                  [&](const KeyUnit& k) { return key.ends_with(k.ending); });
  return found == key_units.end() ? nullptr : &*found;
}

bool is_temperature(const std::string& key) { return key.ends_with("_c"); }
bool is_salinity(const std::string& key) { return key.ends_with("_psu"); }

bool is_any(const std::string& text, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* word) { return text == word; });
}

/// In lower case, without what stands between words.
std::string squeezed(const std::string& text) {
  std::string out = lower_case(plain_text(text));
  std::erase_if(out, [](char c) { return c == ' ' || c == '_'; });
  return out;
}

std::optional<Conversion> to_celsius(const std::string& units) {
  std::string word = squeezed(units);
  for (const std::string degree : {"degrees", "degree"})
    if (word.starts_with(degree)) word.replace(0, degree.size(), "deg");
  if (is_any(word, {"degc", "degcelsius", "celsius", "c"})) return Conversion{};
  if (is_any(word, {"k", "kelvin", "kelvins", "degk", "degkelvin"}))
    return Conversion{0, 1, -273.15};
  return std::nullopt;
}

bool is_ratio(const Unit& unit) { return unit.gram == 0 && unit.metre == 0 && unit.pascal == 0; }

/// Practical salinities have no unit (PSS-78: UNESCO 1981), which files write in many ways, after
/// the older salinities in parts per thousand 1e-3 among them (CF's standard name table).
bool is_practical(const std::string& units) {
  return is_any(squeezed(units),
                {"psu", "pss", "pss78", "pss-78", "1", "1e-3", "0.001", "ppt", "permil",
                 "practicalsalinityunit", "practicalsalinityunits", "dimensionless"});
}

/// Absolute salinities: S_A = (35.16504/35) g/kg S_P in water of standard composition (IOC, SCOR &
/// IAPSO 2010, TEOS-10, eq. 2.4.1). Others' departs by less than 0.03 g/kg; from memory.
std::optional<Conversion> to_practical(const std::string& units, const std::string& standard_name) {
  if (!is_absolute_salinity(units, standard_name))
    return is_practical(units) ? std::optional(Conversion{}) : std::nullopt;
  const auto ratio = unit_called(units);
  if (!ratio || !is_ratio(*ratio)) return std::nullopt;
  return Conversion{ratio->decade + 3, 35 / 35.16504, 0};
}

}  // namespace

double Conversion::operator()(double x) const {
  const double scale = std::pow(10.0, std::abs(decade));
  return (decade < 0 ? x / scale : x * scale) * factor + offset;
}

std::optional<Conversion> conversion(const Unit& from, const Unit& to) {
  if (from.gram != to.gram || from.metre != to.metre || from.pascal != to.pascal)
    return std::nullopt;
  return Conversion{from.decade - to.decade};
}

std::optional<Conversion> conversion_to(const std::string& key, const std::string& units,
                                        const std::string& standard_name) {
  if (is_temperature(key)) return to_celsius(units);
  if (is_salinity(key)) return to_practical(units, standard_name);
  const KeyUnit* unit = key_unit(key);
  expect(unit && unit->unit, "keys of files end in their units");
  const auto called = unit_called(units);
  return called ? conversion(*called, *unit->unit) : std::nullopt;
}

std::string unit_of(const std::string& key) {
  const KeyUnit* unit = key_unit(key);
  return unit ? unit->text : "1";
}

std::string without_its_unit(const std::string& key) {
  const KeyUnit* unit = key_unit(key);
  return unit ? key.substr(0, key.size() - std::string(unit->ending).size()) : key;
}

std::vector<OtherUnit> other_units_of(const std::string& key) {
  constexpr double longest_nm = 2e4;
  if (key.ends_with("_nm")) return {{"in um", 1e3, 0, longest_nm}, {"in m", 1e9, 0, longest_nm}};
  if (key.ends_with("_km")) return {{"in m", 1e-3}};
  if (is_temperature(key)) return {{"in K", 1, -273.15}};
  if (key.ends_with("relative_error")) return {{"per cent", 0.01}};
  return {};
}

std::string understood_for(const std::string& key) {
  if (is_temperature(key)) return "\"degree_Celsius\" and \"K\" are understood";
  if (is_salinity(key))
    return "\"psu\", \"1\" and \"1e-3\" are understood for practical salinities, \"g/kg\" for "
           "absolute ones";
  return key_unit(key)->understood;
}

void refuse_other_units(const optics::DataTable& table, const std::string& column,
                        const std::string& key) {
  const std::string units = table.units(column);
  const KeyUnit* unit = key_unit(key);
  const bool has_scale = is_temperature(key) || is_salinity(key);
  if (units.empty() || !unit || !(unit->unit || has_scale)) return;
  const auto convert = conversion_to(key, units, "");
  const bool same = convert && convert->decade == 0 && convert->factor == 1 && convert->offset == 0;
  if (same || (!convert && !unit_called(units))) return;
  const std::string other =
      table.may_be_quoted() ? fmt::format("\"{}\"", optics::shown(units)) : "other units";
  table.fail_columns(
      fmt::format("{} is in {} by the header of the file, not in {}", column, other, unit->text),
      "convert the column, and write its new units there");
}

bool is_absolute_salinity(const std::string& units, const std::string& standard_name) {
  const auto unit = unit_called(units);
  const bool of_masses = unit && is_ratio(*unit) && units.find('g') != std::string::npos;
  return of_masses || standard_name == "sea_water_absolute_salinity";
}

}  // namespace photic::scene
