// Bounds of time and depth that spare work must leave room for walks that are shifted under tilted
// lenses, and for points of the lens that are nearer than its centre.
#include <gtest/gtest.h>

#include "support/changed_world.hpp"

namespace photic::test {
namespace {

/// A beam straight down beside a wide lens that is tilted by 37 degrees and sees it all, with a
/// last gate that ends soon.
std::string tilted_lidar(double z_m, double stop_ns) {
  return fmt::format(
             "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.3, {0}]\ndirection = [0.0, "
             "0.0, -1.0]\ndiameter_m = 0.01\nhalf_divergence_mrad = 20.0\n[[telescope]]\n"
             "position_m = [0.0, 0.0, {0}]\ndirection = [0.6, 0.0, -0.8]\ndiameter_m = 0.6\n"
             "focal_length_m = 0.5\nhalf_field_of_view_mrad = 900.0\n[gates]\nstart_ns = 0.0\n"
             "stop_ns = {1}\nstep_ns = {2}\n",
             z_m, stop_ns, stop_ns / 5) +
         channel("elastic") + water(0.1, 0.3, "{ model = \"henyey-greenstein\", g = 0.3 }") +
         simulation(3e4, 41, "max_order = 2", "bidirectional");
}

// What comes later, or from deeper, is never scored. Seen red: @@.
TEST(TiltedLens, LosesNothingThatIsInTime) {
  for (const double z_m : {-5.0, 1.0}) {
    SCOPED_TRACE(z_m);
    const std::string scene = tilted_lidar(z_m, z_m < 0 ? 15.0 : 20.0);
    const auto bounded = simulate_in(scene, [](auto&) {});
    const auto generous = simulate_in(scene, [](auto& world) {
      constexpr double more_m = 10;
      for (auto& receiver : world.receivers) {
        receiver.longest += more_m;
        receiver.deadline.path += more_m;
      }
      for (auto& deadline : world.deadlines) deadline.path += more_m;
      world.deepest += more_m;
    });
    ASSERT_GT(bounded.echo.mean.back(), 0);
    for (std::size_t g = 0; g < bounded.gates(); ++g)
      EXPECT_NEAR(generous.echo.mean[g], bounded.echo.mean[g], 1e-9 * bounded.echo.mean[g]) << g;
  }
}

}  // namespace
}  // namespace photic::test
