// Telescopes that see one inside the other share their light: each has the echo that it has alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "support/agree.hpp"
#include "support/runs.hpp"
#include "support/scenes.hpp"

namespace photic::test {
namespace {

constexpr int views = 16;

struct Lidar {
  std::string name;
  double z;               ///< of laser and telescopes [m]
  double tilt;            ///< tangent
  double shift_m;         ///< of the detectors
  double narrowest_mrad;  ///< half field of view; the widest is ten times as wide
  std::string channels, gates;
  std::size_t settled;  ///< gates, at least, whose errors are small
  std::string estimator = "forward", more = "";
  double photons = 4e5;  ///< of each alone
};

/// The telescopes from number `first` to below `last`, the wide ones before the narrow ones.
scene::Scene scene_of(const Lidar& lidar, int first, int last, double photons, int seed) {
  std::string text = fmt::format(R"(
[source]
wavelength_nm = 532.0
position_m = [0.05, 0.0, {0}]
direction = [0.0, {1}, -1.0]
diameter_m = 0.04
half_divergence_mrad = 5.0
)",
                                 lidar.z, lidar.tilt);
  for (int i = first; i < last; ++i)
    text += fmt::format(R"([[telescope]]
name = "view{4}"
position_m = [0.0, 0.0, {0}]
direction = [0.0, {1}, -1.0]
diameter_m = 0.2
focal_length_m = 1.0
detector_shift_m = {2}
half_field_of_view_mrad = {3}
)",
                        lidar.z, lidar.tilt, lidar.shift_m,
                        lidar.narrowest_mrad * std::pow(10, (views - 1 - i) / (views - 1.0)), i);
  return read(text + lidar.channels + lidar.gates +
              "[[sea.layer]]\niop = [ { wavelength_nm = 532.0, a_per_m = 0.06, b_per_m = 0.1 }, { "
              "wavelength_nm = 650.0, a_per_m = 0.35, b_per_m = 0.08 } ]\nphase_function = { model "
              "= \"henyey-greenstein\", g = 0.6 }\n" +
              simulation(photons, static_cast<std::uint64_t>(seed), lidar.more, lidar.estimator));
}

/// The echo of one of several telescopes.
tally::Result only(const tally::Result& all, int telescope) {
  tally::Result one = all;
  const std::size_t cells = all.channels() * all.gates();
  const auto cut = [&](auto& of) {
    of = {of.begin() + static_cast<std::ptrdiff_t>(cells) * telescope,
          of.begin() + static_cast<std::ptrdiff_t>(cells) * (telescope + 1)};
  };
  cut(one.echo.mean);
  cut(one.echo.standard_error);
  return one;
}

/// Sixteen in one run against every third of them in a run of its own, at 1 %: by Šidák's
/// inequality no more than that, whatever views that share their light have in common.
void compare_with_each_alone(const Lidar& lidar) {
  SCOPED_TRACE(lidar.name);
  const auto together = run_in_lanes(scene_of(lidar, 0, views, 2 * lidar.photons, 5));
  ZFamily family(0.01);
  std::size_t settled = 0;
  for (int i = 0; i < views; i += 3)
    settled += add_settled(family, only(together, i),
                           run_in_lanes(scene_of(lidar, i, i + 1, lidar.photons, 100 + i)),
                           fmt::to_string(i));
  EXPECT_GE(settled, lidar.settled);
  family.judge();
}

// Seen red: with scores not passed to wider views; with the radius of the next wider detector in
// the place of each one's own.
TEST(NestedViews, OverTheSeaAreEachAsIfAlone) {
  const std::string gates = depth_gates(9, 3);
  compare_with_each_alone({"upright", 12, 0, 0, 10, channel("elastic"), gates, 18});
  compare_with_each_alone({"tilted and out of focus", 12, 0.1, 0.01, 10,
                           channel("elastic") + channel("raman"), gates, 30});
}
TEST(NestedViews, InTheSeaAreEachAsIfAlone) {
  const std::string gates = "[gates]\nrange_min_m = 3.0\nrange_max_m = 9.0\nrange_step_m = 2.0\n";
  compare_with_each_alone({"tilted and out of focus", -1, 0.1, 0.01, 20,
                           channel("elastic") + channel("raman"), gates, 30});
}

// Each strategy finds in its own way which views see its light. Seen red: with the ray of a walk as
// it was drawn for that of a free one; with own rays alone where the lens is out of focus.
TEST(NestedViews, OfWalksFromBothSidesAreEachAsIfAlone) {
  const std::string gates = depth_gates(9, 3), both = channel("elastic") + channel("raman");
  const std::string free = "free_telescope_meetings = 0.3\nfree_laser_meetings = 0.5\n";
  const std::string none = "free_telescope_meetings = 0.0\nfree_laser_meetings = 0.0\n";
  compare_with_each_alone({"tilted and out of focus, free", 12, 0.1, 0.01, 10, both, gates, 20,
                           "bidirectional", free, 1e5});
  compare_with_each_alone(
      {"upright and out of focus", 12, 0, 0.01, 10, both, gates, 20, "bidirectional", none, 1e5});
}

}  // namespace
}  // namespace photic::test
