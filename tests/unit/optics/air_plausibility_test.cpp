// What no air does: altitudes and pressures in other units, upside down, or mistyped; and that all
// air passes, as sparse or as noisy as it is known.
#include "optics/air_plausibility.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <random>

#include "unit/optics/air_support.hpp"

namespace photic::optics {
namespace {

constexpr const char* models[] = {"us-standard",        "tropical",         "midlatitude-summer",
                                  "midlatitude-winter", "subarctic-summer", "subarctic-winter"};

struct Level {
  double z_km, p_hpa, t_k;
};

std::vector<Level> levels_of(const AirProfile& air) {
  std::vector<Level> out;
  for (std::size_t i = 0; i < air.z_km.size(); ++i)
    out.push_back({air.z_km[i], air.pressure_hpa[i], air.temperature_k[i]});
  return out;
}

std::vector<Level> us_levels() { return levels_of(air_library().atmosphere("us-standard")); }

/// Numbers with all their digits.
std::string table_of(const std::vector<Level>& levels) {
  std::string text = "z_km,p_hpa,t_k\n";
  for (const Level& at : levels) text += fmt::format("{},{},{}\n", at.z_km, at.p_hpa, at.t_k);
  return text;
}

/// What is said of a table; nothing if it is read.
std::string said_of(const std::string& text) {
  try {
    air_profile(DataTable::parse(text, "air.csv"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string said_of(std::vector<Level> levels, const std::function<void(Level&)>& change) {
  for (Level& at : levels) change(at);
  return said_of(table_of(levels));
}

// Seen red, each for itself: without hydrostatic_fault(); without of_altitudes; without
// fault_at_the_sea().
TEST(AirFault, OfUnitsNamesThem) {
  const std::vector<Level> air = us_levels();
  EXPECT_EQ(said_of("z_km,p_hpa,t_k\n0,1010,290\n9000,310,230\n90000,2e-3,190\n"),
            "air.csv:3:1: the pressure falls from 1010 to 310 hPa between 0 and 9000 km: in "
            "hydrostatic air of 260 K that takes 8.99 km (are the altitudes in m, and not in km?)");
  expect_contains(said_of(air, [](Level& at) { at.z_km *= 1e3; }), "are the altitudes in m, and");
  expect_contains(said_of(air, [](Level& at) { at.z_km *= 3280.84; }),
                  "are the altitudes in feet,");
  expect_contains(said_of(air, [](Level& at) { at.z_km *= 3.28084; }), "altitudes in 1000 feet");
  expect_contains(said_of(air, [](Level& at) { at.z_km /= 1e3; }),
                  "between 0 and 0.001 km: in hydrostatic air of 284.95 K that takes 0.998 km "
                  "(altitudes are in km, pressures in hPa, temperatures in K)");
  expect_contains(said_of(air, [](Level& at) { at.p_hpa *= 1e2; }),
                  "air.csv:2:3: p_hpa 101300 is above 2000 (is it in Pa, and not in hPa?)");
  expect_contains(said_of(air, [](Level& at) { at.p_hpa /= 1e1; }),
                  "air.csv:2:3: air at 0 km has no pressure of 101.3 hPa: at the sea it is some "
                  "1013.25 (are the pressures in kPa, and not in hPa?)");
  expect_contains(said_of(air, [](Level& at) { at.p_hpa /= 1e3; }),
                  "are the pressures in bar, and");
  expect_contains(said_of(air, [](Level& at) { at.t_k -= 273.15; }),
                  "air.csv:2:8: t_k 15.05 is below 50 (is it in degrees Celsius, and not in K?)");
  expect_contains(said_of(air, [](Level& at) { at.t_k = 1.8 * at.t_k - 459.67; }), "air.csv:");
}

// Seen red: without of_pressures; without the question about their order.
TEST(AirFault, OfOneLevelOrOfTheirOrder) {
  const auto one = [](std::size_t level, double factor) {
    std::vector<Level> air = us_levels();
    air[level].p_hpa *= factor;
    return said_of(table_of(air));
  };
  EXPECT_EQ(
      one(30, 100),
      "air.csv:32:6: the pressure does not fall from 35 to 37.5 km: it is 5.746 and 404.116 hPa "
      "(is this pressure in Pa, and not in hPa?)");
  expect_contains(one(30, 0.01), "air.csv:32:1: the pressure falls from 5.746 to 0.0404116 hPa");
  expect_contains(one(12, 10), "from 11 to 12 km: it is 227 and 1940 hPa");
  EXPECT_EQ(said_of("z_km,p_hpa,t_k\n0,265,223\n10,1013,288\n"),
            "air.csv:3:4: the pressure does not fall from 0 to 10 km: it is 265 and 1013 hPa (are "
            "the pressures listed from the top down?)");
  expect_contains(said_of("z_km,p_hpa,t_k\n0,1013,288\n10,1013,288\n"), "it is 1013 and 1013 hPa");
}

// An isothermal air whose pressure falls a little too fast or too slowly. Seen red: with a factor
// of 1.4, and of 1.6.
TEST(AirFault, BeginsAtAFactorOfOneAndAHalf) {
  const auto air = [](double factor) {
    const double z_km = factor * 29.27e-3 * 260 * std::log(1000.0 / 400.0);
    return said_of(fmt::format("z_km,p_hpa,t_k\n0,1000.0,260\n{},400.0,260\n", z_km));
  };
  for (const double factor : {0.68, 1.0, 1.48}) EXPECT_EQ(air(factor), "") << factor;
  for (const double factor : {0.65, 1.53}) EXPECT_NE(air(factor), "") << factor;
}

// Seen red: without fault_of_density(); without the rounding of pressures there.
TEST(AirFault, OfMoleculesThatAreNoIdealGas) {
  const auto air = [](double per_cm3) {
    return said_of(fmt::format(
        "z_km,p_hpa,t_k,air_per_cm3\n0,1013.25,288.15,2.55e19\n1,898.8,281.7,{}\n", per_cm3));
  };
  EXPECT_EQ(air(2.31e19), "");
  expect_contains(air(2.31e13),
                  "air.csv:3:15: 2.31e+13 molecules of air per cm3 do not go with 898.8 hPa and "
                  "281.7 K: an ideal gas has 2.311e+19");
  EXPECT_EQ(said_of("z_km,p_hpa,t_k,air_per_cm3\n0,1013.000,288,2.548e19\n95,0.001,190,2.1e13\n"),
            "");  // 0.00055 hPa, rounded
  expect_contains(air(2.31e25), "air_per_cm3 2.31e+25 is above 1e+20 (is it in 1/m3, and not in");
}

// Seen red: with factors of 1.1 and of 1.4.
TEST(AirFault, IsNoneOfAirAtAFewLevels) {
  for (const char* name : models) {
    const std::vector<Level> air = levels_of(air_library().atmosphere(name));
    for (const double step_km : {5.0, 10.0, 25.0, 50.0, 100.0}) {
      std::vector<Level> few;
      for (const Level& at : air)
        if (std::fmod(at.z_km, step_km) == 0 && at.z_km <= 100) few.push_back(at);
      EXPECT_EQ(said_of(table_of(few)), "") << name << " at each " << step_km << " km";
    }
    EXPECT_EQ(said_of(table_of({air.front(), air.back()})), "") << name;
  }
}

// The US standard atmosphere of 1976 up to 1000 km (its tables, rounded), where molecules are no
// longer mixed and an atom of hydrogen is all there is. Seen red: without min_mixed_hpa.
TEST(AirFault, IsNoneOfTheThermosphere) {
  EXPECT_EQ(said_of("z_km,p_hpa,t_k\n0,1013.25,288.15\n50,0.79779,270.65\n80,0.010524,198.64\n"
                    "100,3.2011e-4,195.08\n150,4.5422e-6,634.39\n200,8.4736e-7,854.56\n"
                    "300,8.7704e-8,976.01\n500,3.0236e-9,999.24\n1000,7.5138e-11,1000\n"),
            "");
}

// A hot and humid day, a cold one, a lake of the Andes.
TEST(AirFault, IsNoneOfUnusualAir) {
  EXPECT_EQ(said_of("z_km,p_hpa,t_k\n0,1006,305\n1.5,850,294\n3.2,700,283\n5.9,500,268\n"), "");
  EXPECT_EQ(said_of("z_km,p_hpa,t_k\n0,1060,220\n1.2,880,235\n5,510,225\n"), "");
  EXPECT_EQ(said_of("z_km,p_hpa,t_k\n0,645,285\n2,505,273\n"), "");
  EXPECT_EQ(said_of("z_km,p_hpa,t_k\n0,1013,288\n0.002,1012.8,288\n"), "");
}

// A balloon's levels each 5 m, with pressures to 0.1 hPa, both with the noise of real soundings.
// Seen red: with neighbours compared, however near; without the rounding of pressures.
TEST(AirFault, IsNoneOfSoundings) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise;
  std::string text = "z_km,p_hpa,t_k\n";
  double last_m = -1;
  for (double z_m = 0; z_m < 34e3; z_m += 5) {
    const double at_m = z_m == 0 ? 0 : std::max(last_m + 0.1, z_m + 2 * noise(random));
    text += fmt::format("{:.4f},{:.1f},{:.1f}\n", at_m / 1e3,
                        1013 * std::exp(-z_m / 7000) + 0.03 * noise(random), 239.0);
    last_m = at_m;
  }
  EXPECT_EQ(said_of(text), "");
}

// One level of many has a pressure of the level 4 km higher. Seen red: without hydrostatic_fault().
TEST(AirFault, IsFoundInASoundingToo) {
  std::string text = "z_km,p_hpa,t_k\n";
  for (int i = 0; i < 100; ++i)
    text += fmt::format("{:.3f},{:.1f},{}\n", 0.01 * i,
                        1013 * std::exp(-(i == 57 ? 457 : i) / 820.0), 280);
  expect_contains(said_of(text), "air.csv:59:1: the pressure falls from");
}

// Seen red: each, without the lines that find it.
TEST(AirDoubts, AreAboutWhatMayBeInAnotherUnit) {
  const auto doubts = [](const std::string& text) {
    return doubts_about(air_profile(DataTable::parse(text, "air.csv")));
  };
  using Texts = std::vector<std::string>;
  const auto with = [&](const std::string& column, const std::string& value) {
    return doubts("z_km,p_hpa,t_k," + column + "\n0,1013,288," + value + "\n9,308,230,0\n");
  };
  for (const char* name : models) EXPECT_EQ(doubts_about(air_library().atmosphere(name)), Texts{});
  EXPECT_EQ(doubts("z_km,p_hpa,t_k\n0,760,288\n9,231,230\n"),
            Texts{"the pressure at the sea is 760 hPa, where 870 to 1085 have been measured: is it "
                  "in mmHg?"});
  EXPECT_EQ(doubts("z_km,p_hpa,t_k\n0,1110,288\n9,331,230\n"),
            Texts{"the pressure at the sea is 1110 hPa, where 870 to 1085 have been measured"});
  EXPECT_EQ(with("relative_humidity_percent", "0.8"),
            Texts{"the relative humidity is 0.8 % at most: is it a fraction?"});
  EXPECT_EQ(with("relative_humidity_percent", "1.5"), Texts{});
  EXPECT_EQ(with("relative_humidity_percent", "0"), Texts{});
  EXPECT_EQ(with("ozone_per_cm3", "0.03"),
            Texts{"there are 0.03 molecules of ozone per cm3 at most, where air has some 5e+12"});
  EXPECT_EQ(with("ozone_per_cm3", "7e17").size(), 1U);
  EXPECT_EQ(with("ozone_per_cm3", "7e11"), Texts{});
  EXPECT_EQ(with("troposphere_per_km", "158"),
            Texts{"aerosols have an extinction of 158 per km, more than fog of 0.2 km visibility: "
                  "is it in 1/Mm?"});
  EXPECT_EQ(with("boundary_layer_per_km", "19.6"), Texts{});
}

}  // namespace
}  // namespace photic::optics
