// First-order echoes of tilted lidars against the lidar equation integrated over every gate.
#include "analytic/first_order.hpp"

namespace photic::test {
namespace {

// Seen red: with the optical depth of the way home straight up; with the absorption of a slanting
// way across an edge straight down, or by the coefficient of the layer it began in; with the rest
// of a free path by that layer's.
TEST(FirstOrder, Tilted30DegreesInTwoLayers) {
  compare(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, 12.0]
direction = [0.5, 0.0, -0.8660254037844386]
diameter_m = 0.04
half_divergence_mrad = 2.0
[[telescope]]
position_m = [0.0, 0.2, 12.0]
direction = [0.5, 0.0, -0.8660254037844386]
diameter_m = 0.40
focal_length_m = 2.0
half_field_of_view_mrad = 30.0
)" + channel("elastic") +
              R"(
[[sea.layer]]
bottom_depth_m = 15.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.03, b_per_m = 0.03 } ]
phase_function = { model = "henyey-greenstein", g = 0.6 }
[[sea.layer]]
iop = [ { wavelength_nm = 532.0, a_per_m = 0.02, b_per_m = 0.035 } ]
phase_function = { model = "henyey-greenstein", g = 0.6 }
[gates]
range_min_m = 14.0
range_max_m = 64.0
range_step_m = 2.5
)",
          {shape(optics::henyey_greenstein(0.6))});
}

// An airborne lidar with a telescope at its beam and one beside it, with gates by depth. Seen red:
// timed straight down, where the first gates are empty.
TEST(FirstOrder, DepthsOfALidarTilted20Degrees) {
  compare(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, 300.0]
direction = [0.3420201433256687, 0.0, -0.9396926207859084]
diameter_m = 0.01
half_divergence_mrad = 1.0
[[telescope]]
name = "coaxial"
position_m = [0.0, 0.0, 300.0]
direction = [0.3420201433256687, 0.0, -0.9396926207859084]
diameter_m = 0.15
focal_length_m = 1.0
half_field_of_view_mrad = 5.0
[[telescope]]
name = "biaxial"
position_m = [0.3, 0.8, 300.2]
direction = [0.3420201433256687, 0.0, -0.9396926207859084]
diameter_m = 0.20
focal_length_m = 1.0
half_field_of_view_mrad = 10.0
)" + channel("elastic") +
              water(0.03, 0.03, "{ model = \"henyey-greenstein\", g = 0.6 }") + depth_gates(40, 2),
          {shape(optics::henyey_greenstein(0.6))}, {forward_in_short, bidirectional});
}

/// A ship's lidar tilted by so many degrees.
std::string tilted_ship(double degrees) {
  const double angle = degrees * pi / 180;
  const auto direction =
      fmt::format("direction = [{}, 0.0, {}]\n", std::sin(angle), -std::cos(angle));
  return "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, 12.0]\n" + direction +
         "diameter_m = 0.04\nhalf_divergence_mrad = 2.0\n[[telescope]]\nposition_m = [0.0, 0.3, "
         "12.0]\n" +
         direction + "diameter_m = 0.40\nfocal_length_m = 2.0\nhalf_field_of_view_mrad = 30.0\n" +
         channel("elastic") + water(0.03, 0.03, "{ model = \"henyey-greenstein\", g = 0.6 }") +
         depth_gates(24, 2);
}

// Hardly tilted, as a pilot flies, and far more. Seen red: with the level area of the lens for that
// across the ray, at 45 degrees.
TEST(FirstOrder, TranslationsUnderALensTiltedBy0_01And15And45Degrees) {
  for (const double degrees : {0.01, 15.0, 45.0}) {
    SCOPED_TRACE(degrees);
    compare(tilted_ship(degrees), {shape(optics::henyey_greenstein(0.6))}, {bidirectional});
  }
}

// A beam that goes down at 45 degrees, seen from its side, from higher up at 20 degrees, and from
// straight above: what a gate is called differs by metres. Seen red: with the depths of the first
// telescope for all.
TEST(FirstOrder, DepthsOfThreeTelescopesAtOtherHeightsAndTilts) {
  compare(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, 12.0]
direction = [1.0, 0.0, -1.0]
diameter_m = 0.04
half_divergence_mrad = 2.0
[[telescope]]
name = "coaxial"
position_m = [0.0, 0.2, 12.0]
direction = [1.0, 0.0, -1.0]
diameter_m = 0.40
focal_length_m = 2.0
half_field_of_view_mrad = 30.0
[[telescope]]
name = "higher, steeper"
position_m = [1.081, 0.0, 30.0]
direction = [0.3420201433256687, 0.0, -0.9396926207859084]
diameter_m = 0.40
focal_length_m = 1.0
half_field_of_view_mrad = 300.0
[[telescope]]
name = "above"
position_m = [14.0, 0.0, 20.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.40
focal_length_m = 1.0
half_field_of_view_mrad = 450.0
)" + channel("elastic") +
              water(0.03, 0.03, "{ model = \"henyey-greenstein\", g = 0.6 }") + depth_gates(24, 2),
          {shape(optics::henyey_greenstein(0.6))}, {forward_in_short, bidirectional});
}

}  // namespace
}  // namespace photic::test
