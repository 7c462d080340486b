// Bounds of time and depth that spare work must leave room for walks that are translated under
// tilted lenses, and for points of the lens that are nearer than its centre.
#include <gtest/gtest.h>

#include "support/changed_world.hpp"

namespace photic::test {
namespace {

/// A beam straight down beside a wide lens that sees it all, and a last gate that ends soon.
struct Lidar {
  double z_m;
  const char *telescope, *direction;
  double stop_ns;
};
std::string scene_of(const Lidar& lidar) {
  return fmt::format(
             "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.3, {0}]\ndirection = [0.0, "
             "0.0, -1.0]\ndiameter_m = 0.01\nhalf_divergence_mrad = 20.0\n[[telescope]]\n"
             "position_m = [{1}, 0.0, {0}]\ndirection = {2}\ndiameter_m = 0.6\n"
             "focal_length_m = 0.5\nhalf_field_of_view_mrad = 900.0\n[gates]\nstart_ns = 0.0\n"
             "stop_ns = {3}\nstep_ns = {4}\n",
             lidar.z_m, lidar.telescope, lidar.direction, lidar.stop_ns, lidar.stop_ns / 5) +
         channel("elastic") + water(0.1, 2.0, "{ model = \"henyey-greenstein\", g = 0.3 }") +
         simulation(3e4, 41, "max_order = 3\nmeetings = 100.0", "bidirectional");
}

// What comes later, or from deeper, is never scored. Seen red: with the time of the whole
// path for that of walks that are not translated yet, between rays, at the laser; without the lens'
// rise at the telescope, in the water and above it; without it in how deep light turns back.
TEST(TiltedLens, LosesNothingThatIsInTime) {
  for (const Lidar& lidar :
       {Lidar{-5, "0.0", "[0.6, 0.0, -0.8]", 15}, Lidar{-5, "-0.8", "[0.95, 0.0, -0.3]", 12},
        Lidar{1, "0.0", "[0.6, 0.0, -0.8]", 20}, Lidar{1, "-0.8", "[0.9, 0.0, -0.45]", 20}}) {
    SCOPED_TRACE(fmt::format("{} {}", lidar.z_m, lidar.direction));
    const std::string scene = scene_of(lidar);
    const auto bounded = simulate_in(scene, [](auto&) {});
    const auto generous = simulate_in(scene, [](auto& world) {
      constexpr double more_m = 10;
      for (auto& receiver : world.walks.receivers) {
        receiver.longest += more_m;
        receiver.deadline.path += more_m;
      }
      for (auto& deadline : world.instruments.deadlines) deadline.path += more_m;
      world.walks.deepest += more_m;
    });
    ASSERT_GT(bounded.echo.mean.back(), 0);
    for (std::size_t g = 0; g < bounded.gates(); ++g)
      EXPECT_NEAR(generous.echo.mean[g], bounded.echo.mean[g], 1e-9 * bounded.echo.mean[g]) << g;
  }
}

}  // namespace
}  // namespace photic::test
