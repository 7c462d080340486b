#include "optics/atmosphere.hpp"

#include <filesystem>
#include <fstream>

#include "optics/air_molecules.hpp"
#include "unit/optics/air_support.hpp"

namespace photic::optics {
namespace {

const AirProfile& us_standard() { return air_library().atmosphere("us-standard"); }

TEST(Atmosphere, SixAreKnownByName) {
  for (const char* name : {"us-standard", "tropical", "midlatitude-summer", "midlatitude-winter",
                           "subarctic-summer", "subarctic-winter"}) {
    const AirProfile& air = air_library().atmosphere(name);
    EXPECT_EQ(air.z_km.size(), 50U) << name;
    EXPECT_EQ(air.z_km.back(), 120) << name;
    EXPECT_NEAR(air.pressure_hpa.front(), 1013, 6) << name;
    // Air between the poles and the equator weighs the same within 1 %.
    EXPECT_NEAR(column_per_m2(air, air.air_per_m3) / 2.152e29, 1, 0.006) << name;
    expect_contains(air.source, "Anderson et al. 1986, AFGL-TR-86-0110");
  }
  EXPECT_EQ(us_standard().temperature_k.front(), 288.2);
  EXPECT_EQ(air_library().atmosphere("tropical").temperature_k.front(), 299.7);
  expect_contains(
      message<InputError>([] { static_cast<void>(air_library().atmosphere("martian")); }),
      "no atmosphere model \"martian\" (there are: us-standard, tropical,");
}

// The optical depths of Bodhaine et al. 1999 stand on 1013.25 hPa of dry air; the profile has 0.02
// to 0.04 % more. Seen red: with straight lines between levels (0.15 % more).
TEST(Atmosphere, OfTheUsHasTheOpticalDepthsOfBodhaine) {
  const double n = column_per_m2(us_standard(), us_standard().air_per_m3);
  EXPECT_NEAR(n * air_scattering_m2(355) / 0.5937, 1, 5e-4);
  EXPECT_NEAR(n * air_scattering_m2(400) / 0.3602, 1, 5e-4);
  EXPECT_NEAR(n * air_scattering_m2(532) / 0.1112, 1, 5e-4);
  EXPECT_NEAR(n * air_scattering_m2(550) / 0.0971, 1, 5e-4);
}

TEST(AirProfile, HasTheSameAirInMoreLayers) {
  AirProfile fine = with_edges(us_standard(), {3.5, 3, 0.7});
  EXPECT_EQ(std::vector(fine.edges_km.begin(), fine.edges_km.begin() + 7),
            (std::vector{0.0, 0.7, 1.0, 2.0, 3.0, 3.5, 4.0}));
  fine.edges_km = us_standard().edges_km;
  EXPECT_EQ(fine, us_standard());
  EXPECT_THROW(with_edges(us_standard(), {121}), ContractViolation);
}

TEST(AirProfile, IsCutAtAnAltitude) {
  EXPECT_EQ(up_to(us_standard(), 2.5).edges_km, (std::vector{0.0, 1.0, 2.0, 2.5}));
  EXPECT_EQ(up_to(us_standard(), 2.5).z_km, us_standard().z_km);
  EXPECT_EQ(up_to(us_standard(), 120), us_standard());
}

// Expected values: what LOWTRAN 7 prints for its copy of this atmosphere, as lengths at 0 C and one
// atmosphere.
TEST(Atmosphere, OfTheUsHasLowtransColumns) {
  constexpr double loschmidt_per_m3 = 2.686780e25;
  const AirProfile& air = us_standard();
  EXPECT_NEAR(column_per_m2(air, air.air_per_m3) / loschmidt_per_m3, 8.011e3, 1.0);
  EXPECT_NEAR(column_per_m2(air, air.ozone_per_m3) / loschmidt_per_m3, 3.434e-3, 0.01e-3);
}

// Expected values: the humidities that LOWTRAN 7 prints. Seen red: with 14.9595 as 14.9959; with
// the factor 273.15 / T left out.
TEST(Atmosphere, OfTheUsHasLowtransHumidities) {
  const std::vector<double>& rh = us_standard().relative_humidity_percent;
  EXPECT_NEAR(rh[0] / 45.84, 1, 2e-3);
  EXPECT_NEAR(rh[3] / 50.71, 1, 2e-3);
  EXPECT_NEAR(rh[10] / 28.69, 1, 2e-3);
  EXPECT_NEAR(rh[16] / 1.384, 1, 2e-3);
  EXPECT_NEAR(rh[20] / 0.7302, 1, 2e-3);
  EXPECT_EQ(relative_humidity_percent(1e26, 288), 100);
}

// Seen red: with the mean of the ends; with the logarithm's ratio turned.
TEST(MeanBetween, IsThatOfAnExponential) {
  const std::vector<double> z{0, 8, 20}, values{1, std::exp(-1.0), std::exp(-2.5)};
  // e^(-z/8) throughout.
  const auto exact = [](double from, double to) {
    return 8 * (std::exp(-from / 8) - std::exp(-to / 8)) / (to - from);
  };
  EXPECT_NEAR(mean_between(z, values, 0, 8), exact(0, 8), 1e-15);
  EXPECT_NEAR(mean_between(z, values, 0, 20), exact(0, 20), 1e-15);
  EXPECT_NEAR(mean_between(z, values, 3, 11), exact(3, 11), 1e-15);
  EXPECT_NEAR(mean_between(z, values, 19, 19.001), exact(19, 19.001), 1e-12);
}

// Seen red: with an exponential between two altitudes of a straight line.
TEST(MeanBetween, KeepsItsDigitsAndIsStraightTowardsZero) {
  EXPECT_EQ(mean_between({0, 1}, {5, 5}, 0.2, 0.9), 5);
  EXPECT_NEAR(mean_between({0, 1}, {1, 1 + 1e-12}, 0, 1), 1 + 5e-13, 1e-15);
  EXPECT_EQ(mean_between({0, 1, 2}, {0, 3, 0}, 0, 2), 1.5);
  EXPECT_EQ(mean_between({0, 1}, {4, 0}, 0.5, 1), 1);
  EXPECT_EQ(mean_between({0, 1}, {4, 0}, 0.25, 0.5), 2.5);
  EXPECT_TRUE(std::isfinite(mean_between({0, 1}, {1e-300, 1e300}, 0, 1)));
  EXPECT_THROW(mean_between({0, 1}, {1, 1}, 0.5, 1.5), ContractViolation);
}

AirProfile parsed(const std::string& text) {
  return air_profile(DataTable::parse(text, "air.csv"));
}

TEST(AirProfileTable, NeedsAltitudePressureAndTemperature) {
  const AirProfile air = parsed("z_km,p_hpa,t_k\n0,1013.25,288.15\n2,800,275\n");
  EXPECT_EQ(air.source, "air.csv");
  EXPECT_NEAR(air.air_per_m3[0], 2.54692e25, 1e20);  // p / kT
  EXPECT_EQ(air.ozone_per_m3, std::vector<double>(2, 0.0));
  EXPECT_EQ(air.relative_humidity_percent, std::vector<double>(2, 0.0));
  for (const auto& aerosols : air.aerosols_per_km) EXPECT_EQ(aerosols, std::vector<double>(2, 0.0));
}

TEST(AirProfileTable, TakesAllThatAProfileHolds) {
  const AirProfile air = parsed(
      "# a comment\n"
      "upper_atmosphere_per_km,z_km,p_hpa,t_k,air_per_cm3,ozone_per_cm3,relative_humidity_percent,"
      "boundary_layer_per_km,troposphere_per_km,stratosphere_per_km\n"
      "1e-5,0,1000,290,2.5e19,7e11,80,0.1,0.2,0.3\n"
      "2e-5,1,900,285,2.2e19,6e11,70,0.4,0.5,0.6\n");
  EXPECT_EQ(air.air_per_m3, (std::vector{2.5e25, 2.2e25}));
  EXPECT_EQ(air.ozone_per_m3, (std::vector{7e17, 6e17}));
  EXPECT_EQ(air.relative_humidity_percent, (std::vector{80.0, 70.0}));
  EXPECT_EQ(air.aerosols_per_km[boundary_layer], (std::vector{0.1, 0.4}));
  EXPECT_EQ(air.aerosols_per_km[troposphere], (std::vector{0.2, 0.5}));
  EXPECT_EQ(air.aerosols_per_km[stratosphere], (std::vector{0.3, 0.6}));
  EXPECT_EQ(air.aerosols_per_km[upper_atmosphere], (std::vector{1e-5, 2e-5}));
}

struct BadTable {
  std::string text, says;
};

std::string rows(const std::string& rows) { return "z_km,p_hpa,t_k\n" + rows; }

// Gaps, texts and missing columns are what a DataTable finds. Seen red: the others, each with the
// check that finds it taken out.
TEST(AirProfileTable, SaysWhatIsWrongAndWhere) {
  const std::string ozone = "z_km,p_hpa,t_k,ozone_per_cm3\n0,1000,290,7e11\n";
  const std::vector<BadTable> bad{
      {rows("0,1000,290\n1,,280\n"), "air.csv:3:3: \"\" is not a finite number"},
      {rows("0,1000,290\n1,900,nan\n"), "air.csv:3:7: \"nan\" is not a finite number"},
      {rows("0,1000,290\n1,-900,280\n"), "air.csv:3:3: p_hpa -900 is below 1e-12"},
      {rows("0,1000,290\n1,0,280\n"), "air.csv:3:3: p_hpa 0 is below 1e-12"},
      {rows("0,101325,290\n1,900,280\n"), "air.csv:2:3: p_hpa 101325 is above 2000"},
      {rows("0,1000,290\n1,900,0\n"), "air.csv:3:7: t_k 0 is below 50"},
      {rows("2,1000,290\n1,900,280\n"), "air.csv:3:1: z_km 1 is not above the 2 before it"},
      {rows("1,1000,290\n1,900,280\n"), "air.csv:3:1: z_km 1 is not above the 1 before it"},
      {rows("-1,1000,290\n1,900,280\n"), "air.csv:2:1: altitudes begin at the sea level, 0"},
      {rows("0,1000,290\n"), "air.csv:2:1: a profile needs two levels or more"},
      {rows("0,1000,290\n1,900\n"), "air.csv:3:1: 2 fields where 3 columns are named"},
      {"z_km,p_hpa\n0,1000\n1,900\n", "air.csv:1:1: no column \"t_k\""},
      {ozone + "1,900,280,-1\n", "air.csv:3:11: ozone_per_cm3 -1 is below 0"},
      {"z_km,p_hpa,t_k,smoke\n0,1000,290,1\n1,900,280,1\n",
       "air.csv:1:1: unknown column \"smoke\" (there are: z_km, p_hpa, t_k, air_per_cm3,"},
      {"z_km,p_hpa,t_k,t_k\n0,1000,290,1\n1,900,280,1\n",
       "air.csv:1:1: column \"t_k\" appears twice"},
      {"z_km,p_hpa,t_k,relative_humidity_percent\n0,1000,290,101\n1,900,280,1\n",
       "air.csv:2:12: relative_humidity_percent 101 is above 100"},
      {"z_km,p_hpa,t_k,relative_humidity_percent,water_vapour_per_cm3\n0,1000,290,1,1\n",
       "air.csv:1:1: both relative_humidity_percent and water_vapour_per_cm3"},
  };
  for (const BadTable& table : bad)
    expect_contains(message<InputError>([&] { parsed(table.text); }), table.says);
}

// At 2 km there is none, nor at 0 km: half way between 60 and 40 %, and as at 1 km. Seen red: with
// 0 there; with vapour itself on a straight line.
TEST(AirProfileTable, FollowsHumidityWhereItIsMissing) {
  const auto read = [](const std::string& column, const std::vector<std::string>& values) {
    std::string text = "z_km,p_hpa,t_k," + column + "\n";
    const char* levels[] = {"0,1013,288", "1,899,282", "2,795,275", "3,701,269"};
    for (std::size_t i = 0; i < values.size(); ++i) text += levels[i] + ("," + values[i]) + "\n";
    return with_all_humidities(DataTable::parse(text, "air.csv"));
  };
  const auto humidities = [](const DataTable& table) {
    return air_profile(table).relative_humidity_percent;
  };
  for (const char* gap : {"", "NaN", "nan"}) {
    const DataTable table = read("relative_humidity_percent", {gap, "60", gap, "40"});
    EXPECT_EQ(humidities(table), (std::vector{60.0, 60.0, 50.0, 40.0}));
    EXPECT_EQ(table.remarks(), std::vector<std::string>{
                                   "relative_humidity_percent is missing at 2 of 4 levels, the "
                                   "first at 0 km: there it follows from the levels beside it"});
  }
  const DataTable vapour = read("water_vapour_per_cm3", {"2e17", "1e17", "", "4e16"});
  const std::vector<double> of_vapour = humidities(vapour);
  EXPECT_NEAR(of_vapour[2], (of_vapour[1] + of_vapour[3]) / 2, 1e-9);
  EXPECT_EQ(vapour.remarks().size(), 1U);
  EXPECT_EQ(humidities(read("relative_humidity_percent", {"", "70", "", ""})),
            std::vector<double>(4, 70.0));
  const DataTable dry = read("relative_humidity_percent", {"", "", "NaN", ""});
  EXPECT_EQ(humidities(dry), std::vector<double>(4, 0.0));
  EXPECT_EQ(dry.remarks(), std::vector<std::string>{"relative_humidity_percent is missing at all "
                                                    "levels: the air is dry"});
  EXPECT_EQ(read("relative_humidity_percent", {"80", "60", "50", "40"}).remarks().size(), 0U);
  expect_contains(message<InputError>([&] {
                    read("relative_humidity_percent", {"80", "-", "", "40"});
                  }),
                  "air.csv:3:11: \"-\" is not a finite number");
  expect_contains(message<InputError>([&] {
                    humidities(read("relative_humidity_percent", {"80", "-999", "", "40"}));
                  }),
                  "air.csv:3:11: relative_humidity_percent -999 is below 0");
  expect_contains(message<InputError>([&] {
                    air_profile(read("ozone_per_cm3", {"", "0", "0", "0"}));
                  }),
                  "air.csv:2:12: \"\" is not a finite number");
}

TEST(AirTables, ThatAreDamagedAreAFailedEnvironment) {
  namespace fs = std::filesystem;
  const fs::path folder = scratch_folder("photic_damaged_air");
  fs::remove_all(folder);
  fs::copy(data_folder, folder);
  const auto loading = [&] {
    return message<EnvironmentError>([&] { AirLibrary{folder.string()}; });
  };
  std::ofstream(folder / "atmosphere_tropical.csv") << "z_km,p_hpa,t_k\n0,1000,290\n0,900,280\n";
  expect_contains(loading(), "atmosphere_tropical.csv:3:1: z_km 0 is not above the 0 before it");
  fs::remove(folder / "atmosphere_tropical.csv");
  expect_contains(loading(), "atmosphere_tropical.csv: cannot be read");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace photic::optics
