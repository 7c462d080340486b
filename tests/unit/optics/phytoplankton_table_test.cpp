#include "optics/phytoplankton_table.hpp"

#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

const std::string three_columns = "wavelength_nm,a_m2_per_mg,b_m2_per_mg\n";
const std::string four_columns = "wavelength_nm,a_m2_per_mg,b_m2_per_mg,a_exciting_m2_per_mg\n";

PhytoplanktonTable algae_of(const std::string& text) {
  return phytoplankton_table(DataTable::parse(text, "algae.csv"));
}

std::string why_not(const std::string& text) {
  return message<InputError>([&] { algae_of(text); });
}

// Seen red: with C^0.62 for b; with all absorption for what excites.
TEST(PhytoplanktonTable, IsInProportionToChlorophyll) {
  const auto table = algae_of(four_columns + "400,0.04,0.3,0.03\n500,0.02,0.25,0.018\n");
  const Phytoplankton p = phytoplankton_of_table(table, 2.5, 450);
  EXPECT_NEAR(p.a_per_m, 2.5 * 0.03, 1e-15);
  EXPECT_NEAR(p.a_exciting_per_m, 2.5 * 0.024, 1e-15);
  EXPECT_NEAR(p.b_per_m, 2.5 * 0.275, 1e-15);
  EXPECT_EQ(p.source, "given in algae.csv");
}

TEST(PhytoplanktonTable, ExcitesByAllAbsorptionIfNothingElseIsSaid) {
  const auto table = algae_of(three_columns + "400,0.04,0.3\n500,0.02,0.25\n");
  EXPECT_EQ(phytoplankton_of_table(table, 1, 400).a_exciting_per_m, 0.04);
}

TEST(PhytoplanktonTable, NamesItsRange) {
  const auto table = algae_of(three_columns + "400,0.04,0.3\n500,0.02,0.25\n");
  EXPECT_EQ(
      message<InputError>([&] { phytoplankton_of_table(table, 1, 399.9); }),
      "no phytoplankton data at 399.9 nm: given in algae.csv cover 400-500 nm (choose another "
      "wavelength, or give the layer's iop at this one)");
  EXPECT_THROW(phytoplankton_of_table(table, 1, 500.1), InputError);
  // Without chlorophyll nothing is asked of it.
  EXPECT_EQ(phytoplankton_of_table(table, 0, 900).a_per_m, 0);
}

// Each with file, line and column. Seen red: with negative numbers let through; with a share above
// the whole let through.
TEST(PhytoplanktonTable, ReportsWhatIsWrongWithAFile) {
  EXPECT_EQ(why_not("wavelength_nm,a_m2_per_mg\n400,1\n500,1\n"),
            "algae.csv:1:1: no column \"b_m2_per_mg\" (there are, between commas: wavelength_nm, "
            "a_m2_per_mg)");
  EXPECT_EQ(why_not(three_columns + "400,0.04,0.3\n500,-0.02,0.25\n600,0.01,0.2\n700,-1,0.2\n"),
            "algae.csv:3:5: a_m2_per_mg -0.02 is negative\n"
            "algae.csv:5:5: a_m2_per_mg -1 is negative");
  EXPECT_EQ(why_not(three_columns + "400,0.04,0.3\n500,0.02,nan\n"),
            "algae.csv:3:10: \"nan\" is not a finite number (fill the gap, or leave the row out)");
  EXPECT_EQ(why_not(three_columns + "500,0.04,0.3\n400,0.02,0.25\n"),
            "algae.csv:3:1: wavelength_nm 400 is not above the 500 before it (this column must "
            "ascend)");
  EXPECT_EQ(why_not(three_columns + "400,0.04,0.3\n400,0.02,0.25\n"),
            "algae.csv:3:1: wavelength_nm 400 is not above the 400 before it (this column must "
            "ascend)");
  EXPECT_EQ(why_not(three_columns + "0,0.04,0.3\n400,0.02,0.25\n"),
            "algae.csv:2:1: a wavelength is above 0");
  EXPECT_EQ(why_not(three_columns + "400,0.04,0.3\n"),
            "algae.csv:2:1: a spectrum needs two rows or more");
  EXPECT_EQ(why_not(four_columns + "400,0.04,0.3,0.03\n500,0.02,0.25,0.021\n"),
            "algae.csv:3:15: a_exciting_m2_per_mg 0.021 is more than the a_m2_per_mg of all "
            "absorption, 0.02 (it is a share of it)");
}

}  // namespace
}  // namespace photic::optics
