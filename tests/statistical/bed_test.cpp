// What a sea bed does to whole runs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/runs.hpp"
#include "support/scenes.hpp"

namespace photic::test {
namespace {

const std::string channels = channel("elastic") + channel("raman");

/// Two layers down to 5.2 m.
std::string shallow(const std::string& bottom) {
  const std::string phase = "phase_function = { model = \"henyey-greenstein\", g = 0.7 }\n";
  return ship_instrument + channels +
         "[[sea.layer]]\nbottom_depth_m = 2.0\niop = [ { wavelength_nm = 532.0, a_per_m = 0.06, "
         "b_per_m = 0.2 }, { wavelength_nm = 700.0, a_per_m = 0.3, b_per_m = 0.15 } ]\n" +
         phase +
         "[[sea.layer]]\nbottom_depth_m = 5.2\niop = [ { wavelength_nm = 532.0, a_per_m = 0.1, "
         "b_per_m = 0.15 }, { wavelength_nm = 700.0, a_per_m = 0.3, b_per_m = 0.1 } ]\n" +
         phase + bottom + depth_gates(10, 2);
}

struct Estimator {
  const char* name;
  double photons;
  const char* more;
};
const Estimator estimators[] = {
    {"forward", 1e5, ""}, {"bidirectional", 2e4, ""}, {"analog", 1e5, ""}};

tally::Result run_over(const std::string& bottom, const Estimator& e) {
  return run_in_lanes(read(shallow(bottom) + simulation(e.photons, 3, e.more, e.name)));
}

// Seen red: with an albedo of 0 taken for a bed that reflects.
TEST(SeaBed, OfAlbedo0IsTheBlackOne) {
  for (const Estimator& e : estimators) {
    SCOPED_TRACE(e.name);
    const auto black = run_over("", e), zero = run_over("[bottom]\nalbedo = 0\n", e);
    EXPECT_EQ(zero.echo.mean, black.echo.mean);
    EXPECT_EQ(zero.echo.standard_error, black.echo.standard_error);
    EXPECT_EQ(zero.grid("echo_by_order").mean, black.grid("echo_by_order").mean);
    EXPECT_EQ(zero.ledger, black.ledger);
    EXPECT_EQ(zero.process_names(), black.process_names());
    EXPECT_GT(black.ledger.sea_bed, 0.01);
  }
}

// Seen red: with what the bed absorbs left out of the ledger, in each estimator.
TEST(SeaBed, LosesNoPhotons) {
  // Directed photons leave the ledger to a few.
  const Estimator undirected = {"forward", 1e5, "directed_fraction = 0"};
  for (const Estimator& e : {undirected, estimators[1], estimators[2]}) {
    SCOPED_TRACE(e.name);
    const auto black = run_over("", e), bright = run_over("[bottom]\nalbedo = 0.6\n", e);
    EXPECT_NEAR(bright.ledger.sum(), 1, 4 * bright.ledger_standard_error + 1e-9);
    EXPECT_LT(bright.ledger_standard_error, 0.01);
    EXPECT_LT(bright.ledger.sea_bed, 0.6 * black.ledger.sea_bed);
    EXPECT_GT(bright.ledger.sea_bed, 0.2 * black.ledger.sea_bed);
  }
}

// The light of a mirror that is not there: what the bed reflects before or after it is converted
// is converted light, and none of the gates above the bed sees it.
TEST(SeaBed, IsSeenByConvertedLight) {
  for (const Estimator& e : {Estimator{"forward", 1e6, ""}, {"bidirectional", 1e5, ""}}) {
    SCOPED_TRACE(e.name);
    const auto black = run_over("", e), bright = run_over("[bottom]\nalbedo = 0.6\n", e);
    ASSERT_EQ(bright.process_names(), (std::vector<std::string>{"elastic", "bottom", "raman"}));
    const std::size_t raman = black.gates();
    const auto brighter = [&](std::size_t gate) {
      return bright.echo.mean[raman + gate] / black.echo.mean[raman + gate];
    };
    EXPECT_NEAR(brighter(0), 1, 0.03);
    EXPECT_GT(brighter(2), 1.03);
    EXPECT_GT(brighter(3), 5);
    for (std::size_t gate = 0; gate < bright.gates(); ++gate) {
      const std::size_t of_raman = (bright.process_names().size() + 2) * bright.gates() + gate;
      EXPECT_NEAR(bright.grid("echo_by_process").mean[of_raman] / bright.echo.mean[raman + gate], 1,
                  1e-12);
    }
  }
}

// Against the difference of two beds from the same histories, which is not quite linear: light may
// touch the bed twice.
TEST(SeaBed, HasTheDerivativeThatItsAlbedosHave) {
  const auto with = [](const char* albedo) {
    return fmt::format("[[environment]]\nset = {{ \"bottom.albedo\" = {} }}\n", albedo);
  };
  for (const Estimator& e : {estimators[0], estimators[1]}) {
    SCOPED_TRACE(e.name);
    const auto r =
        run_in_lanes(read("sensitivity = [\"bottom.albedo\"]\n" +
                          shallow("[bottom]\nalbedo = 0.2\n" + with("0.19") + with("0.21")) +
                          simulation(e.photons, 3, e.more, e.name)));
    const std::size_t cells = r.echo.mean.size();
    for (std::size_t i = 2; i < 5; ++i) {  // from the gate of the bed on
      const double change = r.environment_echo.mean[cells + i] - r.environment_echo.mean[i];
      EXPECT_NEAR(r.sensitivity.mean[i] * 0.02 / change, 1, 1e-3);
      EXPECT_GT(r.logarithmic_sensitivity.mean[i], 0.9);
    }
    EXPECT_NEAR(r.logarithmic_sensitivity.mean[0], 0, 0.05) << "above it";
  }
}

}  // namespace
}  // namespace photic::test
