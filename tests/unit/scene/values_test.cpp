// One value that is not what it must be: the texts of all diagnostics, with line and column.
#include <gtest/gtest.h>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

const std::vector<Case>& values_cases() {
  static const std::vector<Case> all{
      {"NumberAsText",
       {{3, 3, R"(wavelength_nm = "532")"}},
       {R"(scene.toml:3:17: 'wavelength_nm' must be a finite number, greater than 0, not text "532")"}},
      {"NumberAsBoolean",
       {{3, 3, "wavelength_nm = true"}},
       {"scene.toml:3:17: 'wavelength_nm' must be a finite number, greater than 0, not true"}},
      {"NumberAsArray",
       {{3, 3, "wavelength_nm = [532]"}},
       {"scene.toml:3:17: 'wavelength_nm' must be a finite number, greater than 0, not [532]"}},
      {"NumberAsTable",
       {{3, 3, "wavelength_nm = { nm = 532 }"}},
       {"scene.toml:3:17: 'wavelength_nm' must be a finite number, greater than 0, not a table"}},
      {"NumberAsDate",
       {{3, 3, "wavelength_nm = 2024-01-01"}},
       {"scene.toml:3:17: 'wavelength_nm' must be a finite number, greater than 0, not a date"}},
      {"NotANumber",
       {{3, 3, "wavelength_nm = nan"}},
       {"scene.toml:3:17: 'wavelength_nm' must be a finite number, greater than 0, not nan"}},
      {"Infinite",
       {{12, 12, "diameter_m = inf"}},
       {"scene.toml:12:14: 'diameter_m' must be a finite number, greater than 0, not inf"}},
      {"WavelengthInMicrometres",
       {{3, 3, "wavelength_nm = 0.532"}},
       {"scene.toml:3:17: 'wavelength_nm' must be at least 100 nm, not 0.532 (did you mean 532? "
        "0.532 would be in um)"}},
      {"WavelengthInMetres",
       {{3, 3, "wavelength_nm = 5.32e-7"}},
       {"scene.toml:3:17: 'wavelength_nm' must be at least 100 nm, not 5.32e-07 (did you mean 532? "
        "5.32e-07 would be in m)"}},
      {"WavelengthInNoUnit",
       {{3, 3, "wavelength_nm = 0.01"}},
       {"scene.toml:3:17: 'wavelength_nm' must be at least 100 nm, not 0.01"}},
      {"CentreInMicrometres",
       {{17, 17, "centre_nm = 0.65\nfwhm_nm = 3"}},
       {"scene.toml:17:13: 'centre_nm' must be at least 100 nm, not 0.65 (did you mean 650? 0.65 "
        "would be in um)"}},
      {"TemperatureInKelvin",
       {{19, 19, "[sea]\ntemperature_c = 288.15"}},
       {"scene.toml:20:17: 'temperature_c' must be a finite number, at least -2 and at most 45, "
        "not "
        "288.15 (did you mean 15? 288.15 would be in K)"}},
      {"TargetInPerCent",
       {{30, 30, "target_relative_error = 2"}},
       {"scene.toml:30:25: 'target_relative_error' must be a finite number, greater than 0 and "
        "less than 1, not 2 (did you mean 0.02? 2 would be per cent)"}},
      {"NegativeLength",
       {{12, 12, "diameter_m = -0.4"}},
       {"scene.toml:12:14: 'diameter_m' must be a finite number, greater than 0, not -0.4"}},
      {"ZeroLength",
       {{6, 6, "diameter_m = 0"}},
       {"scene.toml:6:14: 'diameter_m' must be a finite number, greater than 0, not 0"}},
      {"NegativeObstruction",
       {{13, 13, R"(focal_length_m = 2
obstruction_diameter_m = -0.1)"}},
       {"scene.toml:14:26: 'obstruction_diameter_m' must be a finite number, at least 0, not "
        "-0.1"}},
      {"NotFiniteShift",
       {{13, 13, R"(focal_length_m = 2
detector_shift_m = -inf)"}},
       {"scene.toml:14:20: 'detector_shift_m' must be a finite number, not -inf"}},
      {"NotFiniteFocus",
       {{13, 13, R"(focal_length_m = 2
focus_m = inf)"}},
       {"scene.toml:14:11: 'focus_m' must be a finite number, greater than 0, not inf"}},
      {"DivergenceTooWide",
       {{7, 7, "half_divergence_mrad = 1570.8"}},
       {"scene.toml:7:24: 'half_divergence_mrad' must be a finite number, at least 0 and less than "
        "1570.7963267948965, not 1570.8"}},
      {"FieldOfViewOutOfRange",
       {{14, 14, "half_field_of_view_mrad = 0"}},
       {"scene.toml:14:27: 'half_field_of_view_mrad' must be a finite number, greater than 0 and "
        "less than 1570.7963267948965, not 0"}},
      {"VectorTooShort",
       {{4, 4, "position_m = [0, 12]"}},
       {"scene.toml:4:14: 'position_m' must be three finite numbers [x, y, z], not [0, 12]"}},
      {"VectorTooLong",
       {{5, 5, "direction = [0, 0, 0, 0, -1]"}},
       {"scene.toml:5:13: 'direction' must be three finite numbers [x, y, z] that are not all 0, "
        "not an array of 5"}},
      {"VectorOfText",
       {{5, 5, R"(direction = "down")"}},
       {R"(scene.toml:5:13: 'direction' must be three finite numbers [x, y, z] that are not all 0, not text "down")"}},
      {"VectorWithNan",
       {{5, 5, "direction = [0, nan, -1]"}},
       {"scene.toml:5:13: 'direction' must be three finite numbers [x, y, z] that are not all 0, "
        "not [0, nan, -1]"}},
      {"ZeroDirection",
       {{5, 5, "direction = [0, 0, 0.0]"}},
       {"scene.toml:5:13: 'direction' must be three finite numbers [x, y, z] that are not all 0, "
        "not [0, 0, 0]"}},
      {"DirectionTooShortToNormalise",
       {{5, 5, "direction = [0, 0, -1e-200]"}},
       {"scene.toml:5:13: 'direction' must be three finite numbers [x, y, z] that are not all 0, "
        "not [0, 0, -1e-200]"}},
      {"CountNotWhole",
       {{30, 30, "photons = 1.5"}},
       {"scene.toml:30:11: 'photons' must be a whole number, at least 1 and below 2^63, not 1.5"}},
      {"CountZero",
       {{30, 30, "photons = 0"}},
       {"scene.toml:30:11: 'photons' must be a whole number, at least 1 and below 2^63, not 0"}},
      {"CountBeyond63Bits",
       {{30, 30, "photons = 1e19"}},
       {"scene.toml:30:11: 'photons' must be a whole number, at least 1 and below 2^63, not "
        "1e+19"}},
      {"CountExactly63Bits",
       {{30, 30, "photons = 9223372036854775808.0"}},
       {"scene.toml:30:11: 'photons' must be a whole number, at least 1 and below 2^63, not "
        "9.223372036854776e+18"}},
      {"CountAsText",
       {{30, 30, R"(photons = "1e6")"}},
       {R"(scene.toml:30:11: 'photons' must be a whole number, at least 1 and below 2^63, not text "1e6")"}},
      {"NegativeSeed",
       {{30, 30, R"(photons = 1e6
seed = -1)"}},
       {"scene.toml:31:8: 'seed' must be a whole number, at least 0 and below 2^63, not -1"}},
      {"OrdersOutOfRange",
       {{30, 30, R"(photons = 1e6
max_order = 1000001
orders_kept = 1001)"}},
       {"scene.toml:31:13: 'max_order' must be a whole number from 1 to 1000000, not 1000001",
        "scene.toml:32:15: 'orders_kept' must be a whole number from 1 to 1000, not 1001"}},
      {"TargetOutOfRange",
       {{30, 30, "target_relative_error = 1"}},
       {"scene.toml:30:25: 'target_relative_error' must be a finite number, greater than 0 and "
        "less than 1, not 1 (did you mean 0.01? 1 would be per cent)"}},
      {"TimeOutOfRange",
       {{30, 30, "max_time_s = 0"}},
       {"scene.toml:30:14: 'max_time_s' must be a finite number, greater than 0, not 0"}},
      {"ExpertKnobsOutOfRange",
       {{30, 30, R"(photons = 1e6
directed_fraction = 1
conversion_probability = 0
meetings = 1e9)"}},
       {"scene.toml:31:21: 'directed_fraction' must be a finite number, at least 0 and less than "
        "1, not 1",
        "scene.toml:32:26: 'conversion_probability' must be a finite number, greater than 0 and "
        "less than 1, not 0",
        "scene.toml:33:12: 'meetings' must be a finite number, greater than 0 and at most 100000, "
        "not 1000000000"}},
      {"TextAsNumber",
       {{16, 16, "name = 5"}},
       {"scene.toml:16:8: 'name' must be one line of text, not 5 (put it in quotes)"}},
      {"TextEmpty", {{16, 16, R"(name = "")"}}, {"scene.toml:16:8: 'name' must not be empty"}},
      {"TextWithLineBreak",
       {{16, 16, R"(name = "a\nb")"}},
       {R"(scene.toml:16:8: 'name' must be one line of text, not text "a\u000Ab")"}},
      {"LongTextIsCut",
       {{17, 17, R"(process = "éééééééééééééééééééééééééééééééééééééééééééééééééééééééééééé")"}},
       {R"(scene.toml:17:11: 'process' must be "elastic", "raman", "chlorophyll", "cdom" or "oil", not text "éééééééééééééééééééééééééééééééééééééééé…" (choose from: elastic, raman, chlorophyll, cdom, oil))"}},
      {"ChoiceMistyped",
       {{17, 17, R"(process = "ramen")"}},
       {R"(scene.toml:17:11: 'process' must be "elastic", "raman", "chlorophyll", "cdom" or "oil", not text "ramen" (did you mean 'raman'?))"}},
      {"ChoiceUnknown",
       {{17, 17, R"(process = "everything")"}},
       {R"(scene.toml:17:11: 'process' must be "elastic", "raman", "chlorophyll", "cdom" or "oil", not text "everything" (choose from: elastic, raman, chlorophyll, cdom, oil))"}},
      {"ChoiceAsNumber",
       {{17, 17, "process = 1"}},
       {R"(scene.toml:17:11: 'process' must be "elastic", "raman", "chlorophyll", "cdom" or "oil", not 1)"}},
      {"OpticsChoices",
       {{18, 18, R"([optics]
set = "old"
water_absorption = "smith-bakker"
water_depolarisation = 1.1)"}},
       {R"(scene.toml:19:7: 'set' must be "modern" or "paper", not text "old" (choose from: modern, paper))",
        R"(scene.toml:20:20: 'water_absorption' must be "mason-ioccg", "ioccg", "pope-fry" or "smith-baker", not text "smith-bakker" (did you mean 'smith-baker'?))",
        "scene.toml:21:24: 'water_depolarisation' must be a finite number, at least 0 and at most "
        "1, not 1.1"}},
      {"SeaOutOfRange",
       {{19, 19, R"([sea]
salinity_psu = 46
temperature_c = -3
refractive_index = 0.9
group_index = 2.1)"}},
       {"scene.toml:20:16: 'salinity_psu' must be a finite number, at least 0 and at most 45, not "
        "46",
        "scene.toml:21:17: 'temperature_c' must be a finite number, at least -2 and at most 45, "
        "not -3",
        "scene.toml:22:20: 'refractive_index' must be a finite number, at least 1 and at most 2, "
        "not 0.9",
        "scene.toml:23:15: 'group_index' must be a finite number, at least 1 and at most 2, not "
        "2.1"}},
      {"LayerOutOfRange",
       {{22, 22, R"(chlorophyll_mg_m3 = -1
chlorophyll_yield = 2
cdom_a440_per_m = -1
cdom_slope_per_nm = -1)"}},
       {"scene.toml:22:21: 'chlorophyll_mg_m3' must be a finite number, at least 0, not -1",
        "scene.toml:23:21: 'chlorophyll_yield' must be a finite number, at least 0 and at most 1, "
        "not 2",
        "scene.toml:24:19: 'cdom_a440_per_m' must be a finite number, at least 0, not -1",
        "scene.toml:25:21: 'cdom_slope_per_nm' must be a finite number, at least 0, not -1"}},
      {"FilterOutOfRange",
       {{17, 17, R"(centre_nm = 0
fwhm_nm = -3)"}},
       {"scene.toml:17:13: 'centre_nm' must be a finite number, greater than 0, not 0",
        "scene.toml:18:11: 'fwhm_nm' must be a finite number, greater than 0, not -3"}},
      {"HenyeyGreensteinOutOfRange",
       {{25, 25, R"(phase_function = { model = "henyey-greenstein", g = 1 })"}},
       {"scene.toml:25:53: 'g' must be a finite number, at least -0.4 and less than 1, not 1"}},
      {"HenyeyGreensteinTooFarBack",
       {{25, 25, R"(phase_function = { model = "henyey-greenstein", g = -0.41 })"}},
       {"scene.toml:25:53: 'g' must be a finite number, at least -0.4 and less than 1, not -0.41"}},
      {"FournierForandOutOfRange",
       {{25, 25,
         R"(phase_function = { model = "fournier-forand", refractive_index = 1, slope = 5 })"}},
       {"scene.toml:25:66: 'refractive_index' must be a finite number, at least 1.005 and at most "
        "1.35, not 1",
        "scene.toml:25:77: 'slope' must be a finite number, greater than 3 and less than 5, not "
        "5"}},
      {"MieOutOfRange",
       {{25, 25,
         R"(phase_function = { model = "mie", relative_index = 0.4, max_radius_um = 21 })"}},
       {"scene.toml:25:52: 'relative_index' must be a finite number, at least 0.5 and at most 3, "
        "not 0.4",
        "scene.toml:25:73: 'max_radius_um' must be a finite number, at least 0.001 and at most 20, "
        "not 21"}},
      {"RayleighOutOfRange",
       {{25, 25, R"(phase_function = { model = "rayleigh", depolarisation = 1.01 })"}},
       {"scene.toml:25:57: 'depolarisation' must be a finite number, at least 0 and at most 1, not "
        "1.01"}},
      {"IopOutOfRange",
       {{24, 24,
         "iop = [{ wavelength_nm = 0, a_per_m = -1, b_per_m = nan, a_phytoplankton_per_m = -1 }]"}},
       {"scene.toml:24:26: 'wavelength_nm' must be a finite number, greater than 0, not 0",
        "scene.toml:24:39: 'a_per_m' must be a finite number, at least 0, not -1",
        "scene.toml:24:53: 'b_per_m' must be a finite number, at least 0, not nan",
        "scene.toml:24:82: 'a_phytoplankton_per_m' must be a finite number, at least 0, not -1"}},
      {"FileMissing",
       {{25, 25, R"(phase_function = { model = "table", file = "no_such.csv" })"}},
       {"scene.toml:25:44: 'file' names a file that cannot be read: /no_such.csv (a relative path "
        "starts at the scene file)"}},
      {"FileIsAFolder",
       {{25, 25, R"(phase_function = { model = "table", file = "." })"}},
       {"scene.toml:25:44: 'file' names no regular file: / (folders, pipes and devices are "
        "not read)"}},
  };
  return all;
}

// Seen red: infinities let through; a field of view of 0 allowed.
TEST(Values, EveryTextWithLineAndColumn) {
  for (const Case& c : values_cases()) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(diagnostics_of(edited(c.edits)), c.expected);
  }
}

}  // namespace
}  // namespace photic::scene
