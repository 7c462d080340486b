#include "optics/modtran.hpp"

#include <algorithm>

#include "unit/optics/air_support.hpp"

namespace photic::optics {
namespace {

// Made by hand in the layout of the two programs, with numbers of their own.
const std::string lowtran_head =
    "1                    ***** LOWTRAN 7 *****\n"
    "0 CARD 1  *****    6    2    0    0    0    0    0    0    0    0    0    0    0    .000    "
    ".00\n"
    "1\n";
const std::string lowtran_molecules =
    "  ATMOSPHERIC PROFILES\n"
    "\n"
    "   I     Z       P       T        N2       CNTMSLF MOL SCAT     N-1     O3 (UV)  O2 (UV)\n"
    "        (KM)    (MB)    (K)            (MOL/CM2 KM)   (-)       (-)  (ATM CM/KM) (ATM CM/KM)\n"
    "\n"
    "   1      .00 1010.000  290.0  7.100E-01 1.500E+20 9.400E-01 2.800E-04 2.500E-03 3.500E+04\n"
    "   2     1.50  850.000  280.0  5.100E-01 6.000E+19 8.200E-01 2.400E-04 2.600E-03 2.900E+04\n"
    "   3    90.00     .000  187.0  1.000E-11 1.000E+01 2.600E-06 8.000E-10 1.800E-07 1.000E-02\n";
const std::string lowtran_aerosols =
    "1\n"
    "  ATMOSPHERIC PROFILES\n"
    "\n"
    "   I     Z       P       T      CNTMFRN     HNO3    AEROSOL 1 AEROSOL 2 AEROSOL 3 AEROSOL 4 "
    "AER1*RH   CIRRUS         RH\n"
    "        (KM)    (MB)    (K)   MOL/CM2 KM ATM CM/KM   (-)       (-)       (-)       (-)       "
    "(-)       (-)      (PERCNT)\n"
    "\n"
    "   1      .00 1010.000  290.0  2.000E+22 4.700E-06 1.200E-01 0.000E+00 0.000E+00 0.000E+00 "
    "3.000E+00 0.000E+00 7.550E+01\n"
    "   2     1.50  850.000  280.0  1.000E+22 5.200E-06 0.000E+00 2.100E-02 3.000E-05 0.000E+00 "
    "3.000E+00 0.000E+00 4.400E+01\n"
    "   3    90.00     .000  187.0  1.000E+02 1.000E-09 0.000E+00 0.000E+00 0.000E+00 5.000E-09 "
    "0.000E+00 0.000E+00 1.000E-01\n";
// What follows is no profile.
const std::string lowtran_tail =
    "\n\n   J     Z       N2 CONT    MOL SCAT       AER 1       AER 2\n        (KM)\n\n"
    "  1    1.500   6.512E-01   9.031E-01   7.700E-01   0.000E+00\n";
const std::string lowtran = lowtran_head + lowtran_molecules + lowtran_aerosols + lowtran_tail;

const std::string modtran =
    "1    ***** MODTRAN4 VERSION 3 REVISION 1 *****\n"
    "\n"
    "1 ATMOSPHERIC PROFILES\n"
    "\n"
    "   I     Z       P       T        N2       CNTMSLF   CNTMFRN MOL SCAT     N-1      O3 (UV)   "
    "O2 (UV)   WAT DROP  ICE PART  RAIN RATE\n"
    "        (KM)    (MB)    (K)               (  MOL/CM2 KM  )      (-)       (-)     (  ATM "
    "CM/KM "
    " )       (GM/M3)   (GM/M3)   (MM/HR)\n"
    "\n"
    "   1   0.0000 1013.000  299.7  7.100E-01 1.500E+20 1.500E+20 9.100E-01 2.800E-04 2.500E-03 "
    "3.500E+04     0.000     0.000     0.000\n"
    "   2   2.0000  805.000  287.7  5.100E-01 6.000E+19 6.000E+19 7.500E-01 2.400E-04 2.600E-03 "
    "2.900E+04     0.000     0.000     0.000\n"
    "\n\n"
    "1 ATMOSPHERIC PROFILES\n"
    "\n"
    "   I     Z       P       T     AEROSOL 1 AEROSOL 2 AEROSOL 3 AEROSOL 4  AER1*RH     RH (%)    "
    "RH (%)   CIRRUS   WAT DROP  ICE PART\n"
    "        (KM)    (MB)    (K)    (      550nm EXTINCTION [KM-1]      )  (BEFORE H2O SCALING)   "
    "(AFTER)    (-)     (550nm VIS [KM-1])\n"
    "\n"
    "   1   0.0000 1013.000  299.7  1.600E-01 0.000E+00 0.000E+00 0.000E+00 1.000E+00 7.600E+01 "
    "8.000E+01   0.00000   0.00000   0.00000\n"
    "   2   2.0000  805.000  287.7  6.200E-02 0.000E+00 0.000E+00 0.000E+00 1.000E+00 7.000E+01 "
    "8.000E+01   0.00000   0.00000   0.00000\n"
    "\n\n"
    "1 ATMOSPHERIC PROFILES (AFTER COLUMN SCALING)\n"
    "\n"
    "   I      Z       P       H2O      O3       CO2\n"
    "         (KM)    (MB)  (         ATM CM / KM         )\n"
    "   1   0.0000 1013.000  1.00E+03 2.52E-03 3.00E+01\n"
    "   2   2.0000  805.000  4.00E+02 2.52E-03 2.00E+01\n";

AirProfile tape6(const std::string& text) { return modtran_profile(text, "tape6"); }

/// A text with a part of it replaced, which must be there.
std::string with(std::string text, const std::string& part, const std::string& other) {
  const auto at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), other);
}

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

struct BadFile {
  std::string text, says;
};

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

const std::string tape7_head =
    "T F 1    2    0    0    1    1    1    1    1    1    1    0    0   0.000   0.00\n"
    "   18000.0   20000.0    1000.0    1000.0NW\n";
const std::string tape7_names =
    "    FREQ COMBIN    H2O     O3 MOLEC AER+CLD AER+CLD    -LOG\n"
    "    CM-1  TRANS  TRANS  TRANS  SCAT   TRANS  abTRNS  COMBIN\n";
const std::string tape7_rows =
    "18000.00 0.5000 1.0000 0.9900 0.9050 0.5580  0.9500   0.693\n"
    "19000.00 0.0400 1.0000 0.9910 0.8800 0.0460  0.9400   3.219\n"
    "20000.00 0.0000 1.0000 0.9920 0.8500 0.0000  0.9300  11.513\n";
const std::string tape7 = tape7_head + tape7_names + tape7_rows + " -9999.\n";

ModtranTransmittances transmittances(const std::string& text) { return {text, "tape7"}; }

// Seen red: with 1e-4 cm in a nm; without the interpolation.
TEST(Tape7, IsReadByTheNamesOfItsColumns) {
  const ModtranTransmittances air = transmittances(tape7);
  EXPECT_EQ(air.columns(),
            (std::vector<std::string>{"-LOG COMBIN", "AER+CLD TRANS", "AER+CLD abTRNS",
                                      "COMBIN TRANS", "H2O TRANS", "MOLEC SCAT", "O3 TRANS"}));
  EXPECT_NEAR(air.optical_depth("MOLEC SCAT", 1e7 / 18000).value, -std::log(0.905), 1e-12);
  EXPECT_NEAR(air.optical_depth("MOLEC SCAT", 1e7 / 18500).value,
              -(std::log(0.905) + std::log(0.88)) / 2, 1e-12);
  EXPECT_NEAR(air.optical_depth("AER+CLD abTRNS", 1e7 / 20000).value, -std::log(0.93), 1e-12);
}

// Four decimals: half of the last one over the transmittance. Seen red: with the rounding of a
// whole digit.
TEST(Tape7, SaysHowFarOffItsDigitsAre) {
  const ModtranTransmittances air = transmittances(tape7);
  const RoundedDepth clear = air.optical_depth("H2O TRANS", 1e7 / 18000);
  EXPECT_EQ(clear.value, 0);
  EXPECT_NEAR(clear.rounding, 5e-5, 1e-12);
  EXPECT_NEAR(air.optical_depth("MOLEC SCAT", 1e7 / 18500).rounding,
              5e-5 * (1 / 0.905 + 1 / 0.88) / 2, 1e-12);
}

// At 0.5 the transmittance has more digits than its logarithm, at 0.04 less. Seen red: with either
// taken always.
TEST(Tape7, TakesTheLogarithmWhereItRoundsLess) {
  const ModtranTransmittances air = transmittances(tape7);
  EXPECT_NEAR(air.optical_depth("COMBIN TRANS", 1e7 / 18000).value, -std::log(0.5), 1e-12);
  EXPECT_NEAR(air.optical_depth("COMBIN TRANS", 1e7 / 18000).rounding, 1e-4, 1e-12);
  EXPECT_NEAR(air.optical_depth("COMBIN TRANS", 1e7 / 19000).value, 3.219, 1e-12);
  EXPECT_NEAR(air.optical_depth("COMBIN TRANS", 1e7 / 20000).value, 11.513, 1e-12);
  EXPECT_NEAR(air.optical_depth("COMBIN TRANS", 1e7 / 20000).rounding, 5e-4, 1e-12);
}

// In depth between rows; exactly what is printed at them, 0 too. Seen red: with transmittances
// interpolated themselves.
TEST(Tape7, HasTransmittancesAtItsWavelengthsAndBetween) {
  const ModtranTransmittances air = transmittances(tape7);
  const std::vector<double> nm = air.wavelengths_nm();
  ASSERT_TRUE(std::ranges::is_sorted(nm));
  const std::vector<double> ozone{0.992, 0.991, 0.99}, aerosols{0, 0.046, 0.558};
  for (std::size_t i = 0; i < nm.size(); ++i) {
    EXPECT_NEAR(air.transmittance("O3 TRANS", nm[i]), ozone.at(i), 1e-9);
    EXPECT_NEAR(air.transmittance("AER+CLD TRANS", nm[i]), aerosols.at(i), 1e-9);
  }
  EXPECT_EQ(air.transmittance("AER+CLD TRANS", (nm[0] + nm[1]) / 2), 0);
  const double middle = 2 / (1 / nm[1] + 1 / nm[2]);
  EXPECT_NEAR(
      air.transmittance("O3 TRANS", middle),
      std::sqrt(air.transmittance("O3 TRANS", nm[1]) * air.transmittance("O3 TRANS", nm[2])),
      1e-12);
  EXPECT_THROW(static_cast<void>(air.transmittance("CO2 TRANS", nm[0])), InputError);
  EXPECT_TRUE(is_tape7(tape7) && is_tape7(tape7_names));
  EXPECT_FALSE(is_tape7(lowtran) || is_tape7(""));
}

// Gases of a user's have names of up to seven letters, as wide as their columns; some stand one
// letter left of their numbers. Seen red: by blanks alone.
TEST(Tape7, NamesThatTouchAreThoseOfTheirColumns) {
  const ModtranTransmittances air = transmittances(
      "    FREQ COMBIN    H2OACETONEETHANOL MOLEC AER+CLD    -LOGTOLUENE\n"
      "    CM-1  TRANS  TRANS  TRANS  TRANS   SCAT  TRANS  COMBIN  TRANS\n"
      "18000.00 0.5000 1.0000 0.9900 0.9800 0.9050 0.5580   0.693 0.9700\n"
      "19000.00 0.0400 1.0000 0.9910 0.9810 0.8800 0.0460   3.219 0.9710\n -9999.\n");
  EXPECT_EQ(air.columns(), (std::vector<std::string>{
                               "-LOG COMBIN", "ACETONE TRANS", "AER+CLD TRANS", "COMBIN TRANS",
                               "ETHANOL TRANS", "H2O TRANS", "MOLEC SCAT", "TOLUENE TRANS"}));
  EXPECT_NEAR(air.transmittance("ACETONE TRANS", 1e7 / 18000), 0.99, 1e-12);
  EXPECT_NEAR(air.transmittance("ETHANOL TRANS", 1e7 / 19000), 0.981, 1e-12);
  EXPECT_NEAR(air.transmittance("AER+CLD TRANS", 1e7 / 18000), 0.558, 1e-12);
  EXPECT_NEAR(air.transmittance("TOLUENE TRANS", 1e7 / 19000), 0.971, 1e-12);
}

// Where the numbers of another row do not. Seen red: by blanks alone; without the look at points.
TEST(Tape7, NumbersThatTouchAreThoseOfTheirColumns) {
  const std::string head =
      "    FREQ COMBIN    -LOG MOLEC\n"
      "    CM-1  TRANS  COMBIN  SCAT\n";
  const std::string rows =
      " 9000.00 0.0400   3.219 0.9050\n"
      "10000.00 0.00001234.500 0.8800\n -9999.\n";
  const ModtranTransmittances air = transmittances(head + rows);
  EXPECT_NEAR(air.optical_depth("COMBIN TRANS", 1000).value, 1234.5, 1e-9);
  EXPECT_NEAR(air.transmittance("MOLEC SCAT", 1000), 0.88, 1e-12);
  const std::string seven = "7:4:1: 3 numbers where 4 columns are named at line 1";
  for (const char* other : {"10000.00 0.000001234.50 0.8800", "10000.00  0.0000         0.8800",
                            "10000.00 0.00001234.500 0.88001"})
    expect_contains(message<InputError>([&] {
                      transmittances(head + with(rows, "10000.00 0.00001234.500 0.8800", other));
                    }),
                    seven);
}

TEST(Tape7, SaysWhatItDoesNotHold) {
  const ModtranTransmittances air = transmittances(tape7);
  const auto asking = [&](const std::string& column, double nm) {
    return message<InputError>([&] { static_cast<void>(air.optical_depth(column, nm)); });
  };
  expect_contains(asking("CO2 TRANS", 540),
                  "tape7:3:1: no column \"CO2 TRANS\" (there are: -LOG COMBIN, AER+CLD TRANS,");
  expect_contains(asking("-LOG COMBIN", 540), "no column \"-LOG COMBIN\"");
  expect_contains(asking("O3 TRANS", 600),
                  "tape7: no transmittances at 600 nm: the file covers 500-555.556 nm");
  expect_contains(asking("AER+CLD TRANS", 500.1),
                  "tape7:7:1: AER+CLD TRANS is printed as 0: its optical depth is above 9.9 (take "
                  "a shorter path)");
}

// Seen red: each, with the check that finds it taken out.
TEST(Tape7, SaysWhatIsWrongAndWhatWasExpected) {
  const std::vector<BadFile> bad{
      {"", "tape7:1:1: no line of names that begins with FREQ"},
      {tape7_head,
       "tape7:1:1: no line of names that begins with FREQ: is the file truncated? "
       "(expected: a tape7 of transmittances (IEMSCT = 0) of MODTRAN)"},
      {tape7_head + "    FREQ TOT TRANS PTH THRML THRML SCT\n" + tape7_rows,
       "tape7:3:1: no second line of names below, from CM-1 on"},
      {with(tape7, "COMBIN    H2O", "COMBIN       "),
       "tape7:3:1: 7 names where the line below has 8"},
      {with(tape7, "CM-1", "  NM"), "tape7:3:1: no second line of names below, from CM-1"},
      {tape7_head + tape7_names, "tape7:4:1: the file ends without -9999: is it truncated?"},
      {tape7_head + tape7_names + tape7_rows, "tape7:7:1: the file ends without -9999"},
      {tape7_head + tape7_names + " -9999.\n", "tape7:3:1: there are no two rows of numbers below"},
      {tape7 + tape7, "tape7:9:1: something follows the -9999 that ends a run"},
      {with(tape7, " 0.8800", ""), "tape7:6:1: 7 numbers where 8 columns are named at line 3"},
      {with(tape7, "0.8800", "0,8800"), "tape7:6:31: \"0,8800\" where MOLEC SCAT is expected"},
      {with(tape7, "0.8800", "1.8800"), "tape7:6:31: MOLEC SCAT 1.8800 where 0 to 1 is expected"},
      {with(tape7, "0.8800", "-.8800"), "tape7:6:31: MOLEC SCAT -.8800 where 0 to 1 is expected"},
      {with(tape7, "19000.00", "17000.00"),
       "tape7:6:1: wavenumber 17000 is not above the 18000 before it"},
      {with(with(tape7, "H2O", " O3"), "  SCAT", " TRANS"),
       "tape7:3:28: column \"O3 TRANS\" appears twice"},
  };
  for (const BadFile& file : bad)
    expect_contains(message<InputError>([&] { transmittances(file.text); }), file.says);
}

TEST(Tape7, MayEndAnywhere) {
  for (std::size_t n = 0; n + 4 < tape7.size(); ++n)
    EXPECT_THROW(transmittances(tape7.substr(0, n)), InputError) << n;
}

}  // namespace
}  // namespace photic::optics
