// The transmittances of a tape7.
#include <algorithm>
#include <cmath>

#include "unit/optics/modtran_files.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

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

// Seen red, each for itself: without the check of its rows; of whether there are any.
TEST(Tape7, IsNotQuotedWithoutARowOfNumbers) {
  for (const char* text : {"FREQ my secret\nCM-1 is kept\nsecret 0.1 0.2\n0.2 0.3 secret\n",
                           "FREQ secret secret\nCM-1 TRANS TRANS\n-9999.\n",
                           "FREQ secret secret\nCM-1 TRANS TRANS\n1 x 2\n-9999.\n",
                           "FREQ secret\nCM-1 TRANS\n18000 secret\n-9999.\n"})
    expect_no_quotation(message<InputError>([&] { transmittances(text); }));
}

}  // namespace
}  // namespace photic::optics
