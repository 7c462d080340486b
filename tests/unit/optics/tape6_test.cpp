// The profiles of a tape6.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "unit/optics/air_support.hpp"
#include "unit/optics/modtran_files.hpp"

namespace photic::optics {
namespace {

AirProfile tape6(const std::string& text) { return modtran_profile(text, "tape6"); }

// Seen red: with ozone in molecules per cm3; with the regions in the other order; with MOL and SCAT
// as two names.
TEST(Tape6, OfLowtranIsAProfile) {
  const AirProfile air = tape6(lowtran);
  EXPECT_EQ(air.source, "tape6");
  EXPECT_EQ(air.z_km, (std::vector{0.0, 1.5, 90.0}));
  EXPECT_EQ(air.pressure_hpa, (std::vector{1010.0, 850.0, 0.0}));
  EXPECT_EQ(air.temperature_k, (std::vector{290.0, 280.0, 187.0}));
  EXPECT_NEAR(air.air_per_m3[1], 0.82 * 2.6867801e25, 1e19);
  EXPECT_NEAR(air.ozone_per_m3[1], 2.6e-8 * 2.6867801e25, 1e12);  // 2.6e-3 cm per km
  EXPECT_EQ(air.relative_humidity_percent, (std::vector{75.5, 44.0, 0.1}));
  EXPECT_EQ(air.aerosols_per_km[boundary_layer], (std::vector{0.12, 0.0, 0.0}));
  EXPECT_EQ(air.aerosols_per_km[troposphere], (std::vector{0.0, 0.021, 0.0}));
  EXPECT_EQ(air.aerosols_per_km[stratosphere], (std::vector{0.0, 3e-5, 0.0}));
  EXPECT_EQ(air.aerosols_per_km[upper_atmosphere], (std::vector{0.0, 0.0, 5e-9}));
}

// The columns stand elsewhere, and of two humidities the first counts. Seen red: with the second.
TEST(Tape6, OfModtranIsReadByTheNamesOfItsColumns) {
  const AirProfile air = tape6(modtran);
  EXPECT_EQ(air.z_km, (std::vector{0.0, 2.0}));
  EXPECT_NEAR(air.air_per_m3[0], 0.91 * 2.6867801e25, 1e19);
  EXPECT_NEAR(air.ozone_per_m3[1], 2.6e-8 * 2.6867801e25, 1e12);
  EXPECT_EQ(air.aerosols_per_km[boundary_layer], (std::vector{0.16, 0.062}));
  EXPECT_EQ(air.relative_humidity_percent, (std::vector{76.0, 70.0}));
}

/// The rows of all profiles in the other order.
std::string from_the_top(const std::string& text) {
  std::vector<std::string> lines, rows;
  std::istringstream stream(text);
  const auto put_rows = [&] {
    lines.insert(lines.end(), rows.rbegin(), rows.rend()), rows.clear();
  };
  for (std::string line; std::getline(stream, line);) {
    const bool is_row =
        line.starts_with("   1 ") || line.starts_with("   2 ") || line.starts_with("   3 ");
    if (!is_row) put_rows();
    (is_row ? rows : lines).push_back(line);
  }
  put_rows();
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}

// Seen red: with levels as they stand (Z 1.5 is not above the 90 before it); with one block turned
// alone.
TEST(Tape6, FromTheTopDownIsTheSame) {
  EXPECT_NE(from_the_top(lowtran), lowtran);
  EXPECT_EQ(tape6(from_the_top(lowtran)), tape6(lowtran));
  EXPECT_EQ(tape6(lowtran_head + from_the_top(lowtran_molecules) + lowtran_aerosols),
            tape6(lowtran));
  EXPECT_EQ(tape6(from_the_top(modtran)), tape6(modtran));
  expect_contains(message<InputError>(
                      [] { tape6(with(from_the_top(lowtran), "   2     1.50", "   2    95.00")); }),
                  "tape6:10:9: Z 95 is not below the 90 before it (expected: descending "
                  "altitudes)");
}

// Blank, or what Fortran prints for what does not fit; in the last column or inside. Seen red: with
// 0 for it; without the widths of other rows.
TEST(Tape6, FollowsHumidityWhereItIsMissing) {
  const std::vector<std::string> missing{"         ", "*********", "      NaN"};
  for (const std::string& gap : missing) {
    const AirProfile air = tape6(with(lowtran, "4.400E+01", gap));
    EXPECT_NEAR(air.relative_humidity_percent[1], 75.5 - 1.5 / 90 * 75.4, 1e-9);
    EXPECT_EQ(air.relative_humidity_percent[0], 75.5);
    EXPECT_EQ(air.aerosols_per_km[stratosphere][1], 3e-5);
    EXPECT_EQ(air.remarks, std::vector<std::string>{
                               "RH is missing at 1 of 3 levels, the first at 1.5 km: there it "
                               "follows from the levels beside it"});
    EXPECT_EQ(tape6(with(modtran, "7.600E+01", gap)).relative_humidity_percent,
              (std::vector{70.0, 70.0}));
  }
  EXPECT_EQ(tape6(lowtran).remarks.size(), 0U);
  expect_contains(message<InputError>([] { tape6(with(lowtran, "2.100E-02", "         ")); }),
                  "tape6:19:62: \"\" where AEROSOL 2 is expected (a number)");
}

// The thin air that three decimals leave: printed as .052 and .000. Seen red: with exact pressures.
TEST(Tape6, OfAnyAirIsRead) {
  for (const char* name : {"us-standard", "tropical", "subarctic-winter"}) {
    const AirProfile& air = air_library().atmosphere(name);
    std::string first = lowtran_molecules.substr(0, lowtran_molecules.find("   1  "));
    std::string second = lowtran_aerosols.substr(0, lowtran_aerosols.find("   1  "));
    for (std::size_t i = 0; i < air.z_km.size(); ++i) {
      const std::string level = fmt::format("{:4} {:8.2f} {:8.3f} {:6.1f} ", i + 1, air.z_km[i],
                                            air.pressure_hpa[i], air.temperature_k[i]);
      first += level + fmt::format("1E-01 1E+10 {:.3E} 1E-04 1E-03 1E+04\n",
                                   air.air_per_m3[i] / 2.6867801e25);
      second += level + "1E+10 1E-06 0E+00 0E+00 0E+00 0E+00 0E+00 0E+00 5E+01\n";
    }
    EXPECT_EQ(tape6(lowtran_head + first + second).z_km, air.z_km) << name;
  }
}

// Seen red: without fault_of() there.
TEST(Tape6, ThatNoAirHasIsRefused) {
  std::string metres = lowtran;
  for (const auto& [km, m] : {std::pair{"    1.50 ", " 1500.00 "}, {"   90.00 ", "90000.00 "}})
    for (int block = 0; block < 2; ++block) metres = with(metres, km, m);
  expect_contains(message<InputError>([&] { tape6(metres); }),
                  "tape6:10:7: the pressure falls from 1010 to 850 hPa between 0 and 1500 km: in "
                  "hydrostatic air of 285 K that takes 1.44 km (are the altitudes in m, and not in "
                  "km?)");
  std::string rising = with(lowtran, "1010.000", " 850.000");
  rising = with(rising, "   2     1.50  850.000", "   2     1.50 1010.000");
  expect_contains(message<InputError>([&] { tape6(rising); }),
                  "tape6:10:15: the pressure does not fall from 0 to 1.5 km: it is 850 and 1010");
  expect_contains(message<InputError>([] { tape6(with(lowtran, "8.200E-01", "8.200E-03")); }),
                  "tape6:10:52: 2.203e+17 molecules of air per cm3 do not go with 850 hPa and 280 "
                  "K");
}

// Seen red: each, with the check that finds it taken out.
TEST(Tape6, SaysWhatIsWrongAndWhatWasExpected) {
  const std::string second_row = "   2     1.50  850.000  280.0  5.100E-01 6.000E+19 8.200E-01";
  const std::vector<BadFile> bad{
      {"",
       "tape6:1:1: no block \"ATMOSPHERIC PROFILES\" (expected: a tape6 that has one, "
       "as of NOPRNT = 0)"},
      {"1013.25, 288.15\n", "tape6:1:1: no block \"ATMOSPHERIC PROFILES\""},
      {lowtran_molecules + lowtran_aerosols,
       "tape6:1:1: no LOWTRAN 7 or MODTRAN is named above the first profile"},
      {with(lowtran, "LOWTRAN 7", "LOWTRAN 6"),
       "tape6:1:28: another version of LOWTRAN (expected: LOWTRAN 7 or MODTRAN)"},
      {lowtran_head + "  ATMOSPHERIC PROFILES\n", "tape6:4:1: the file ends after this title"},
      {lowtran_head + lowtran_molecules,
       "tape6:11:1: the file ends without a block \"ATMOSPHERIC PROFILES\" with a column AEROSOL "
       "1"},
      {lowtran_head + lowtran_aerosols, "with a column MOL SCAT: is it truncated?"},
      {lowtran.substr(0, lowtran.find("   2     1.50  850.000  280.0  1.000E+22")),
       "tape6:18:1: a profile of one level (expected: two or more)"},
      {lowtran.substr(0, lowtran.find("   3    90.00     .000  187.0  1.000E+02")),
       "tape6:19:1: 2 levels where the block at line 6 has 3: is the file truncated?"},
      {with(lowtran, "187.0  1.000E+02", "187.0  9.9 1.000E+02"),
       "tape6:20:1: 14 numbers where 13 columns are named at line 15"},
      {lowtran.substr(0, lowtran.find(" 1.000E-09 0.000E+00")),
       "tape6:20:1: 5 numbers where 13 columns are named at line 15"},
      {lowtran.substr(0, lowtran.find("   1      .00 1010.000  290.0  7.1")) + lowtran_aerosols,
       "tape6:6:1: there are no levels below: is the file truncated?"},
      {with(lowtran, " RH\n", " XX\n"), "tape6:15:1: no column RH (there are: I, Z, P, T,"},
      {with(lowtran, " O3 (UV) ", " O4 (UV) "), "tape6:6:1: no column O3 (UV)"},
      {with(lowtran, second_row, "   2     1.50  850.000  280.0  5.100E-01 6.000E+19 ********* "),
       "tape6:10:52: \"*********\" where MOL SCAT is expected (a number)"},
      {with(lowtran, second_row, "   2     1.50  850.000  280.0  5.100E-01 6.000E+19       NaN"),
       "tape6:10:58: \"NaN\" where MOL SCAT is expected (a number)"},
      {with(lowtran, second_row, "   2     1.50  850.000  280.0  5.100E-01 6.000E+19 0.000E-01"),
       "tape6:10:52: MOL SCAT 0.000E-01 where 1e-20 to 10 is expected"},
      {with(lowtran, "850.000  280.0  5.", "-850.00  280.0  5."),
       "tape6:10:16: P -850.00 where 0 to 2000 is expected"},
      {with(lowtran, "   2     1.50", "   2    95.00"),
       "tape6:11:9: Z 90 is not above the 95 before it (expected: ascending altitudes)"},
      {with(lowtran, "   2     1.50", "   2      .00"),
       "tape6:10:11: Z 0 is not above the 0 before it"},
      {with(lowtran, "   2     1.50  850.000  280.0  1.0", "   2     1.60  850.000  280.0  1.0"),
       "tape6:19:1: Z 1.6 where the block at line 6 has 1.5 (expected: one run in a file)"},
      {with(lowtran, "7.550E+01", "1.755E+02"), "RH 1.755E+02 where 0 to 100 is expected"},
      {lowtran + lowtran_molecules,
       "these columns are also at line 6 (expected: one run in a file)"},
  };
  for (const BadFile& file : bad)
    expect_contains(message<InputError>([&] { tape6(file.text); }), file.says);
}

// The spectra that follow the profiles have lines of names that begin as a tape7's do, by wave
// number or with a page's 1.
const std::string spectra =
    "\n  FREQ   WAVLEN    PATH_THERMAL    SURFACE_EMISSION  TOTAL\n"
    " (CM-1) (MICRN)   (CM-1)  (MICRN)   (CM-1)  (MICRN)  TRANS\n\n"
    " 18700.   0.535 1.00E-11 1.00E-08 1.00E-13 1.00E-09 0.60000\n"
    "1\n   FREQ WAVELENGTH  TOTAL     H2O     CO2+\n"
    "   1/CM  MICRONS    TRANS    TRANS    TRANS\n\n"
    " 18800.    0.532   0.6000   1.0000   1.0000\n -9999.\n";

// Seen red: with a tape7 known by its line of names alone.
TEST(Tape6, IsNoTape7ForItsSpectra) {
  for (const std::string& profiles : {lowtran, modtran}) {
    EXPECT_TRUE(is_tape6(profiles) && is_tape6(profiles + spectra));
    EXPECT_FALSE(is_tape7(profiles + spectra));
    EXPECT_EQ(tape6(profiles + spectra).z_km, tape6(profiles).z_km);
    EXPECT_EQ(tape6(profiles + spectra).ozone_per_m3, tape6(profiles).ozone_per_m3);
  }
  // Without profiles it is no tape7 either.
  EXPECT_TRUE(is_tape6(lowtran_head + spectra) && !is_tape7(lowtran_head + spectra));
  expect_contains(message<InputError>([] { tape6(lowtran_head + spectra); }),
                  "no block \"ATMOSPHERIC PROFILES\"");
  EXPECT_FALSE(is_tape6(spectra) || is_tape6(""));
  EXPECT_TRUE(is_tape7(spectra));
}

// Nothing but InputError, wherever a file ends before the last number that is needed.
TEST(Tape6, MayEndAnywhere) {
  const std::size_t last =
      (lowtran_head + lowtran_molecules + lowtran_aerosols).rfind(" 1.000E-01");
  for (std::size_t n = 0; n <= last; ++n)
    EXPECT_THROW(tape6(lowtran.substr(0, n)), InputError) << n;
}

// Seen red: without the check of its rows.
TEST(Tape6, IsNotQuotedWithoutARowOfNumbers) {
  const std::string head = "*** MODTRAN\n ATMOSPHERIC PROFILES\n";
  for (const char* rows : {"1 2 3 4 5\n1 secret\n", "1 2 3 4 secret 6 7 8 9\n"}) {
    const std::string text = head + " I Z P T MOL SCAT secret1 secret2\n" + rows;
    expect_no_quotation(message<InputError>([&] { tape6(text); }));
  }
}

}  // namespace
}  // namespace photic::optics
