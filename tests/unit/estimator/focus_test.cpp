// How sharply telescopes see: the share of the open lens whose rays reach the detector.
#include "estimator/focus.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "instrument/telescope.hpp"
#include "support/tables.hpp"
#include "unit/scene/base_scene.hpp"

namespace photic::estimator {
namespace {

using scene::edited;
using Texts = std::vector<std::string>;

/// The base scene with this telescope, its header being line 8, and one index at all wavelengths.
std::string seen_by(const std::string& telescope, const std::string& gates = "") {
  return edited({{10, 14, telescope},
                 {19, 19, "[sea]\nrefractive_index = 1.34"},
                 gates.empty() ? scene::Edit{31, 31, ""} : scene::Edit{27, 28, gates}});
}

Texts remarks_on(const std::string& text) {
  return scene::read_scene_text(text, "scene.toml", "/", {}, optics_check(test::tables())).remarks;
}

Texts focus_of(const std::string& text) {
  return reported_focus(make_model(scene::read_text(text), *test::tables()));
}

/// 12 m above the sea, with a lens of 0.4 m and f = 2 m.
const std::string above =
    "position_m = [0, 0, 12]\ndirection = [0, 0, -1]\ndiameter_m = 0.4\nfocal_length_m = 2\n";
const std::string view = "half_field_of_view_mrad = 10\n";

// Rays of a point at 12 m reach the detector within r_d |x_d (1 / f - 1 / d) - 1|^-1 = 0.12 m of
// the axis: 0.36 of the lens, and 0.144 m with the focus at 62 m, 0.52. A shift that is given is
// meant. Seen red: with the distance for its inverse; with no advice but 0; with a remark on a
// shift.
TEST(Focus, RemarksOnASurfaceThatIsBlurred) {
  const auto out_of_focus = [](const std::string& place, const char* share, const char* shift) {
    return Texts{
        fmt::format("scene.toml:{}: the sea's surface, 12 m away, is out of focus: its "
                    "light reaches the detector through {} of the open lens; focus_m = 12 "
                    "puts it in focus, detector_shift_m = {} leaves it so",
                    place, share, shift)};
  };
  EXPECT_EQ(remarks_on(seen_by(above + view)), out_of_focus("8:1", "0.36", "0"));
  EXPECT_EQ(remarks_on(seen_by(above + "detector_diameter_m = 0.04")),
            out_of_focus("8:1", "0.36", "0"));
  EXPECT_EQ(remarks_on(seen_by(above + view + "focus_m = 62")),
            out_of_focus("15:11", "0.52", "0.0666667"));
  EXPECT_EQ(remarks_on(seen_by(above + view + "focus_m = 12")), Texts{});
  for (const std::string shift : {"0", "0.4", "-0.1"})
    EXPECT_EQ(remarks_on(seen_by(above + view + "detector_shift_m = " + shift)), Texts{}) << shift;
}

// (0.05 h)^2 is 0.903 at 19 m and 0.893 at 18.9 m, 0.902 from 9.5 m at 60 degrees. Seen red: with
// the height for the way along the axis; with a limit of 0.91.
TEST(Focus, RemarksWhereTheShareIsBelowNineTenths) {
  const std::string lens = "diameter_m = 0.4\nfocal_length_m = 2\ndetector_diameter_m = 0.04";
  const auto from = [&](const std::string& place) { return remarks_on(seen_by(place + lens)); };
  const std::string down = "direction = [0, 0, -1]\n";
  EXPECT_EQ(from("position_m = [0, 0, 19]\n" + down), Texts{});
  EXPECT_EQ(from("position_m = [0, 0, 18.9]\n" + down).size(), 1U);
  EXPECT_EQ(from("position_m = [0, 0, 705e3]\n" + down), Texts{});
  const std::string slanted = "direction = [1.7320508075688772, 0, -1]\n";
  EXPECT_EQ(from("position_m = [0, 0, 9.5]\n" + slanted), Texts{});
  EXPECT_EQ(from("position_m = [0, 0, 9.4]\n" + slanted).size(), 1U);
}

// No focal length is that short: nothing is advised. Nor is anything remarked on of telescopes in
// the water or that look away from the sea. Seen red: with the advice; with the distance to the sea
// for one in the water.
TEST(Focus, DoesNotAdviseWhatCannotBe) {
  const std::string lens = "diameter_m = 0.4\nfocal_length_m = 2\n" + view;
  const auto from = [&](const std::string& place) {
    return remarks_on(seen_by(place + lens, "range_min_m = 1\nrange_max_m = 50\nrange_step_m = 1"));
  };
  EXPECT_EQ(
      from("position_m = [0, 0, 1.5]\ndirection = [0, 0, -1]\n"),
      Texts{"scene.toml:8:1: the sea's surface, 1.5 m away, is out of focus: its light reaches "
            "the detector through 0.0056 of the open lens; detector_shift_m = 0 leaves it so"});
  EXPECT_EQ(from("position_m = [0, 0, -1]\ndirection = [0, 0, -1]\n"), Texts{});
  EXPECT_EQ(from("position_m = [0, 0, -1]\ndirection = [0, 0, 1]\n"), Texts{});
}

// What is in the water seems to stand at 1 / n of its depth: the last gate, at 49.5 m, at 12 +
// 36.94 m. Seen red: with the depth itself; without the obstruction; with the edge of the gate.
TEST(Focus, IsShownOfTheSurfaceAndTheLastGate) {
  const std::string short_gates = "depth_min_m = -1\ndepth_max_m = 5\ndepth_step_m = 2";
  EXPECT_EQ(focus_of(seen_by(above + view, short_gates)),
            Texts{"t, focused at infinity: 0.36 from the sea's surface, 0.56 from the last gate "
                  "(depth 4 m)"});
  EXPECT_EQ(
      focus_of(seen_by(above + view)),
      Texts{"t, focused at infinity: 0.36 from the sea's surface, 1 from the last gate (depth "
            "49.5 m)"});
  // (0.12^2 - 0.05^2) / (0.2^2 - 0.05^2)
  EXPECT_EQ(focus_of(seen_by(above + view + "obstruction_diameter_m = 0.1", short_gates)),
            Texts{"t, focused at infinity: 0.32 from the sea's surface, 0.53 from the last gate "
                  "(depth 4 m)"});
  // r_d / |2.4 (1 / 2 - 1 / 48.94) - 1| = 0.133 m
  EXPECT_EQ(focus_of(seen_by(above + view + "focus_m = 12")),
            Texts{"t, focused at 12 m: 1 from the sea's surface, 0.44 from the last gate (depth "
                  "49.5 m)"});
  EXPECT_EQ(
      focus_of(seen_by(above + view + "detector_shift_m = -0.1")),
      Texts{"t, focused nowhere, with its detector before the focal plane: 0.23 from the sea's "
            "surface, 1 from the last gate (depth 49.5 m)"});
}

// Along an axis 60 degrees off nadir the sea is 18 m away, and the cosine in the water is 0.7631:
// a depth of 4 m is 5.242 m of the way and a range of 19 m is 1 m of it; a gate in the air is as
// far away as it is. Seen red: with the way in the water as in the air; with the
// height for the way along the axis.
TEST(Focus, IsShownAlongTheAxis) {
  const std::string slanted =
      "position_m = [0, 0, 9]\ndirection = [1.7320508075688772, 0, -1]\ndiameter_m = "
      "0.8\nfocal_length_m = 2\n" +
      view;
  const std::string head = "t, focused at infinity: 0.2 from the sea's surface, ";
  EXPECT_EQ(focus_of(seen_by(slanted, "depth_max_m = 8\ndepth_step_m = 8")),
            Texts{head + "0.3 from the last gate (depth 4 m)"});
  EXPECT_EQ(focus_of(seen_by(slanted, "range_min_m = 0\nrange_max_m = 38\nrange_step_m = 38")),
            Texts{head + "0.22 from the last gate (range 19 m)"});
  const std::string air =
      "\n[atmosphere]\nlayer = [{ bottom_height_m = 0, top_height_m = 9, iop = [{ wavelength_nm = "
      "532, a_per_m = 0, b_per_m = 0.1 }] }]\n";
  EXPECT_EQ(focus_of(seen_by(slanted, "range_min_m = 8\nrange_max_m = 10\nrange_step_m = 2" + air)),
            Texts{head + "0.051 from the last gate (range 9 m)"});
  EXPECT_EQ(
      focus_of(seen_by(slanted, "depth_min_m = -5\ndepth_max_m = -4\ndepth_step_m = 1" + air)),
      Texts{head + "0.051 from the last gate (depth -4.5 m)"});
}

// A telescope in the water sees what is in it as it is; there the nearest gate ahead stands for the
// surface. One that is 2 m below another sees each gate 1 m deeper. Seen red: with apparent depths;
// with gates behind the telescope.
TEST(Focus, IsShownOfTheNearestGateInTheWater) {
  const std::string lens = "diameter_m = 0.2\nfocal_length_m = 1\ndetector_diameter_m = 0.02\n";
  const std::string at_1_m = "position_m = [0, 0, -1]\ndirection = [0, 0, -1]";
  const auto focus_of_second = [&](const std::string& direction) {
    const std::string second = "[[telescope]]\nposition_m = [0, 0, -3]\n" + direction + lens;
    return focus_of(edited({{4, 5, at_1_m},
                            {10, 11, at_1_m},
                            {15, 15, second + "[[channel]]"},
                            {27, 28, "depth_min_m = 1\ndepth_max_m = 9\ndepth_step_m = 1"}}))
        .back();
  };
  const std::string down = "direction = [0, 0, -1]\n", up = "direction = [0, 0, 1]\n";
  EXPECT_EQ(focus_of_second(down),
            "telescope1, focused at infinity: 0.0025 from the first gate ahead (depth 3.5 m), 0.42 "
            "from the last gate (depth 9.5 m)");
  EXPECT_EQ(focus_of_second(up), "telescope1, focused at infinity: no gate lies on its axis");
  EXPECT_EQ(
      focus_of(seen_by("position_m = [0, 0, -3]\n" + up + lens,
                       "range_min_m = 0\nrange_max_m = 9\nrange_step_m = 1")),
      Texts{"t, focused at infinity: 0.0025 from the first gate ahead (range 0.5 m), 0.72 from "
            "the last gate (range 8.5 m)"});
}

// Seen red: with the shift as it is in the scene for the focus.
TEST(Focus, PutsTheDetectorWhereTheImageIs) {
  const scene::Telescope focused =
      scene::read_text(seen_by(above + view + "focus_m = 12")).telescope[0];
  EXPECT_NEAR(focused.effective_detector_shift_m(), 0.4, 1e-15);
  EXPECT_NEAR(focused.detector_distance_m(), 2.4, 1e-15);
  const auto t = instrument::make_telescope<double>(focused);
  EXPECT_NEAR(t.detector_distance, 2.4, 1e-15);
  EXPECT_NEAR(1 / t.per_sharp_range, 12, 1e-13);
}

}  // namespace
}  // namespace photic::estimator
