#include "optics/oil.hpp"

#include <fstream>

#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

const std::vector<std::string> classes{"light-refined", "weakly-absorbing-crude",
                                       "strongly-absorbing-crude"};

/// The integral of an emission spectrum by the midpoint rule.
double photons(const Oil& oil, double from, double to, int steps = 20000) {
  const double step = (to - from) / steps;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += oil.emission_per_nm(from + (i + 0.5) * step) * step;
  return sum;
}

TEST(Oil, HasThreeClasses) { EXPECT_EQ(list_oils(library()), classes); }

// Seen red: with the FWHM for sigma; with the slope's sign turned.
TEST(Oil, OfAClassIsItsTable) {
  const Oil crude = oil(library(), "strongly-absorbing-crude");
  EXPECT_EQ(crude.refractive_index(532), 1.49);
  EXPECT_EQ(crude.absorption_per_m(337), 3e5);
  EXPECT_NEAR(crude.absorption_per_m(437), 3e5 * std::exp(-1), 1e-6);
  EXPECT_NEAR(crude.emission_per_nm(530 + 62.5) / crude.emission_per_nm(530), 0.5, 1e-12);
  EXPECT_NEAR(crude.emission_per_nm(530 - 62.5) / crude.emission_per_nm(530), 0.5, 1e-12);
  EXPECT_EQ(crude.yield, 0.0019);
  EXPECT_EQ(crude.lifetime_ns, 2);
}

// Strongly absorbing crude shines least, and farthest in the red: by which fluorosensors identify
// oils.
TEST(Oil, OfEachClassIsWholeAndInItsRange) {
  double last_yield = 1, last_peak = 0;
  for (const std::string& name : classes) {
    const Oil o = oil(library(), name);
    EXPECT_EQ(o.name, name);
    EXPECT_NEAR(photons(o, 0, 2000), 1, 1e-6) << name;
    EXPECT_LT(o.yield, last_yield);
    last_yield = o.yield;
    ASSERT_EQ(o.properties.size(), 7U);
    EXPECT_GT(o.properties[3].value, last_peak);
    last_peak = o.properties[3].value;
    for (const OilProperty& p : o.properties) {
      EXPECT_LE(p.low, p.value);
      EXPECT_LE(p.value, p.high);
    }
    for (const double nm : {199.0, 1101.0}) {
      expect_contains(message<InputError>([&] { o.absorption_per_m(nm); }),
                      fmt::format("no oil absorption data at {} nm", nm));
      EXPECT_THROW(o.refractive_index(nm), InputError);
    }
  }
}

// Seen red: with the status left out of the source.
TEST(Oil, NamesItsPlaceholders) {
  int placeholders = 0, verified = 0;
  for (const std::string& name : classes) {
    for (const OilProperty& p : oil(library(), name).properties) {
      placeholders += p.source.ends_with("[placeholder]") ? 1 : 0;
      verified += p.source.ends_with("[verified]") ? 1 : 0;
      EXPECT_TRUE(p.source.ends_with("]")) << p.source;
    }
  }
  EXPECT_EQ(placeholders, 7);
  EXPECT_EQ(verified, 1);
}

class OilFile : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Oil read(const std::string& text) {
    std::ofstream(file_) << text;
    return oil(library(), file_);
  }
  /// Without the folder.
  std::string why_not(const std::string& text) {
    return message<InputError>([&] { read(text); }).substr(folder_.string().size() + 1);
  }

  std::filesystem::path folder_ = scratch_folder("photic_oil");
  std::string file_ = folder_ / "diesel.csv";
  const std::string header_ =
      "# yield: 0.04\n# lifetime_ns: 7.5\nwavelength_nm,n,a_per_m,emission_per_nm\n";
};

// Seen red: with the emission not scaled.
TEST_F(OilFile, IsAnOilToo) {
  const Oil o = read(header_ + "300,1.46,5000,0\n400,1.45,1000,10\n500,1.44,0,0\n");
  EXPECT_EQ(o.name, file_);
  EXPECT_NEAR(o.refractive_index(350), 1.455, 1e-12);
  EXPECT_NEAR(o.absorption_per_m(350), 3000, 1e-9);
  EXPECT_NEAR(o.emission_per_nm(400), 0.01, 1e-15);
  EXPECT_NEAR(photons(o, 200, 600), 1, 1e-6);
  EXPECT_EQ(o.emission_per_nm(299), 0);
  EXPECT_EQ(o.yield, 0.04);
  EXPECT_EQ(o.lifetime_ns, 7.5);
  EXPECT_EQ(o.properties[1].source, "given in " + file_);
  EXPECT_EQ(message<InputError>([&] { o.absorption_per_m(501); }),
            "no oil absorption data at 501 nm: given in " + file_ +
                " cover 300-500 nm (choose another wavelength, or a table that reaches it)");
}

TEST_F(OilFile, IsRefusedWithItsPlace) {
  EXPECT_EQ(why_not(header_ + "300,1.46,5000,0\n400,1.45,-1,10\n"),
            "diesel.csv:5:10: a_per_m -1 is negative");
  EXPECT_EQ(why_not(header_ + "300,1.46,5000,0\n400,0.9,1,10\n"),
            "diesel.csv:5:5: a refractive index is 1 or more");
  EXPECT_EQ(why_not(header_ + "300,1.46,5000,0\n400,1.45,1,0\n"),
            "diesel.csv:4:15: an emission spectrum has an integral above 0 (of oil that does not "
            "shine the yield is 0)");
  EXPECT_EQ(why_not(header_ + "300,1.46,5000,0\n300,1.45,1,1\n"),
            "diesel.csv:5:1: wavelength_nm 300 is not above the 300 before it (this column must "
            "ascend)");
  EXPECT_EQ(why_not("# yield: x\n# lifetime_ns: 1\nwavelength_nm,n,a_per_m,emission_per_nm\n"
                    "300,1.46,1,1\n400,1.45,1,1\n"),
            "diesel.csv:1:1: yield must be a finite number, not negative, not \"x\"");
  EXPECT_EQ(why_not("# yield: 1.5\n# lifetime_ns: 1\nwavelength_nm,n,a_per_m,emission_per_nm\n"
                    "300,1.46,1,1\n400,1.45,1,1\n"),
            "diesel.csv: yield is 1.5 (it counts photons emitted per photon absorbed: 1 at most)");
  EXPECT_EQ(why_not("wavelength_nm,n,a_per_m,emission_per_nm\n300,1.46,1,1\n400,1.45,1,1\n"),
            "diesel.csv:1:1: no line \"# yield: …\"");
}

TEST(Oil, OfNoNameIsRefused) {
  EXPECT_EQ(message<InputError>([] { oil(library(), "diesel"); }),
            "no oil model \"diesel\" (there are: light-refined, weakly-absorbing-crude, "
            "strongly-absorbing-crude, or a file .csv)");
  EXPECT_EQ(message<InputError>([] { oil(library(), "/nowhere/oil.csv"); }),
            "/nowhere/oil.csv: cannot be read (is the path right, and the file readable?)");
}

// Seen red: without the check of the range.
TEST(Oil, OfATableNeedsAllItemsOnce) {
  const auto why_not = [](const std::string& rows) {
    return message<InputError>([&] {
      oil_properties(
          DataTable::parse("class,item,value,low,high,unit,source,status\n" + rows, "oils.csv"));
    });
  };
  EXPECT_EQ(why_not("x,refractive_index,1.4,1.4,1.5,1,a,verified\n"),
            "oils.csv:2:3: \"absorption_337_nm\" of x is missing");
  EXPECT_EQ(why_not("x,colour,1.4,1.4,1.5,1,a,verified\n"),
            "oils.csv:2:3: no property of oil \"colour\" (there are: refractive_index, "
            "absorption_337_nm, absorption_slope, emission_peak, emission_fwhm, quantum_yield, "
            "lifetime)");
  EXPECT_EQ(why_not("x,refractive_index,1.6,1.4,1.5,1,a,verified\n"),
            "oils.csv:2:20: 1.6 is not from 1.4 to 1.5");
  std::string all;
  for (const OilProperty& p : library().oils)
    if (p.oil == classes[0])
      all += fmt::format("x,{},{},{},{},{},a,verified\n", p.item, p.value, p.low, p.high, p.unit);
  EXPECT_EQ(why_not(all), "nothing of that kind was thrown");
  EXPECT_EQ(why_not(all + "x,lifetime,1,1,1,ns,a,verified\n"),
            "oils.csv:9:3: \"lifetime\" of x appears twice");
}

}  // namespace
}  // namespace photic::optics
