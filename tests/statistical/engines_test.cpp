// The lane engine, in float and in every instruction set that is here, against the scalar one, in
// double: of the same photons, so that what rounding does stands out from what chance does.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "core/constants.hpp"
#include "run/run.hpp"
#include "schedule/engines.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::test {
namespace {

/// Mean and largest difference of the engines, in standard errors of either.
struct Difference {
  double rms = 0, largest = 0;
  std::size_t gates = 0;
};
Difference difference(const tally::Result& lanes, const tally::Result& scalar) {
  Difference d;
  double sum = 0;
  for (std::size_t i = 0; i < scalar.echo.mean.size(); ++i) {
    if (!(scalar.echo.standard_error[i] > 0)) continue;
    const double x = (lanes.echo.mean[i] - scalar.echo.mean[i]) / scalar.echo.standard_error[i];
    sum += x * x;
    d.largest = std::max(d.largest, std::abs(x));
    ++d.gates;
  }
  d.rms = std::sqrt(sum / static_cast<double>(d.gates));
  return d;
}

struct Case {
  std::string name, toml;
  double photons_forward, photons_bidirectional;
  friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

/// It looks so far aside.
std::string from_height(double height_m, double tangent = 0) {
  return fmt::format(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, {0:.1f}]
direction = [{1:.6f}, 0.0, -1.0]
diameter_m = 0.04
half_divergence_mrad = 0.05
[[telescope]]
position_m = [0.0, 0.0, {0:.1f}]
direction = [{1:.6f}, 0.0, -1.0]
diameter_m = 1.0
focal_length_m = 2.0
detector_diameter_m = 0.001
)",
                     height_m, tangent);
}
/// Gates of 4 ns from where light from a slanted lidar's axis returns.
std::string slant_gates(double height_m, double tangent) {
  const double start_ns =
      2 * height_m * std::sqrt(1 + tangent * tangent) / metre_per_nanosecond - 12;
  return fmt::format("[gates]\nstart_ns = {:.3f}\nstop_ns = {:.3f}\nstep_ns = 4.0\n", start_ns,
                     start_ns + 200);
}
const std::string three = channel("elastic") + channel("raman") + channel("chlorophyll");
const std::string peaked = channel("elastic") + water(0.06, 0.10, peaked_phase);

class Engines : public testing::TestWithParam<Case> {};

// Nothing is said of chance here: by how much the echoes of the same photons may differ is a
// fifth of what they are uncertain by. Seen red: with paths that begin 0.02 m too long in lanes;
// with photons that leave the numbers of their point of the surface behind when they wait for a
// lane.
TEST_P(Engines, Agree) {
  const Case& c = GetParam();
  for (const std::string estimator : {"forward", "bidirectional"}) {
    const bool forward = estimator == "forward";
    const auto scene =
        read(c.toml +
             simulation(forward ? c.photons_forward : c.photons_bidirectional, 31, "", estimator));
    run::RunOptions options;
    const auto scalar = run::run(scene, *test::tables(), options);
    for (const Isa isa : isas_here()) {
      SCOPED_TRACE(fmt::format("{}, {}", estimator, isa_name(isa)));
      options.lanes = isa;
      const auto d = difference(run::run(scene, *test::tables(), options), scalar);
      std::printf("%s, %s: rms %.3f, largest %.3f standard errors in %zu gates\n",
                  estimator.c_str(), isa_name(isa), d.rms, d.largest, d.gates);
      EXPECT_GT(d.gates, 15U);
      EXPECT_LT(d.rms, 0.03);
      EXPECT_LT(d.largest, 0.15);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Engines,
    testing::Values(Case{"Peaked", ship_instrument + peaked + depth_gates(50, 0.5), 4e5, 1e5},
                    Case{"ThreeChannelsInLayers",
                         ship_instrument + three + three_layers + depth_gates(14, 0.5), 2e5, 5e4},
                    Case{"UnderWaves",
                         from_height(300) + three +
                             "[sea]\nsurface = { model = \"cox-munk\", wind_speed_m_s = 9.0 }\n" +
                             three_layers + depth_gates(14, 0.5),
                         1e5, 4e4},
                    Case{"From3km", from_height(3000) + peaked + depth_gates(40, 1), 4e5, 1e5},
                    Case{"From705km", from_height(705000) + peaked + depth_gates(20, 0.25), 4e5,
                         1e5},
                    Case{"From705kmAside",
                         from_height(705000, 0.3) + peaked + slant_gates(705000, 0.3), 4e5, 1e5}),
    testing::PrintToStringParamName());

}  // namespace
}  // namespace photic::test
