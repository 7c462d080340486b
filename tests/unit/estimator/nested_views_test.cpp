// Which telescopes see one inside the other.
#include "estimator/nested_views.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "estimator/model.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::estimator {
namespace {

using Groups = std::vector<NestedViews>;

/// Four telescopes: a wide view, a narrow one, the wide one again, and another place between.
scene::Scene four_telescopes() {
  const std::string there =
      "position_m = [0.0, 0.0, 12.0]\ndirection = [0.0, 0.1, -1.0]\ndiameter_m = 0.4\n"
      "focal_length_m = 2.0\ndetector_shift_m = 0.01\n";
  return test::read(test::ship_instrument + "name = \"beside\"\n" +
                    "[[telescope]]\nname = \"wide\"\nhalf_field_of_view_mrad = 50.0\n" + there +
                    "[[telescope]]\nname = \"narrow\"\nhalf_field_of_view_mrad = 10.0\n" + there +
                    "[[telescope]]\nname = \"middle\"\ndetector_diameter_m = 0.08\n" + there +
                    test::channel("elastic") + test::water(0.06, 0.1, test::peaked_phase) +
                    test::depth_gates(10, 1) + test::simulation(1000, 5));
}

// By the sizes of their detectors, however these are given. Seen red: sorted by the key of one of
// the two.
TEST(NestedViews, DifferInTheirDetectorsAlone) {
  EXPECT_EQ(nested_views(four_telescopes()), (Groups{{0}, {2, 3, 1}}));
}

// Seen red: with any of these left out of what has to be the same.
TEST(NestedViews, AreOfOneLens) {
  using Change = std::function<void(scene::Telescope&)>;
  const std::vector<Change> changes{
      [](auto& t) { t.position_m.x = 0.01; },     [](auto& t) { t.direction.y = 0.11; },
      [](auto& t) { t.diameter_m = 0.41; },       [](auto& t) { t.focal_length_m = 2.1; },
      [](auto& t) { t.detector_shift_m = 0.02; }, [](auto& t) { t.obstruction_diameter_m = 0.01; }};
  for (const Change& change : changes) {
    scene::Scene scene = four_telescopes();
    change(scene.telescope[2]);
    EXPECT_EQ(nested_views(scene), (Groups{{0}, {3, 1}, {2}})) << &change - changes.data();
  }
}

// Seen red: with directions as they are given.
TEST(NestedViews, MayGiveTheirDirectionByVectorsOfAnyLength) {
  scene::Scene scene = four_telescopes();
  scene.telescope[2].direction = 4.0 * scene.telescope[2].direction;
  EXPECT_EQ(nested_views(scene), (Groups{{0}, {2, 3, 1}}));
}

// Seen red: with focus and shift as they are given.
TEST(NestedViews, MayGiveTheirFocusOrTheirShift) {
  scene::Scene scene = four_telescopes();
  for (const std::size_t t : {1, 2, 3}) scene.telescope[t].detector_shift_m = 0.4;
  scene.telescope[2].detector_shift_m = 0;
  scene.telescope[2].focus_m = 12;
  EXPECT_EQ(nested_views(scene), (Groups{{0}, {2, 3, 1}}));
  scene.telescope[2].focus_m = 13;
  EXPECT_EQ(nested_views(scene), (Groups{{0}, {3, 1}, {2}}));
}

// A wide view holds another one of its size.
TEST(NestedViews, MayBeOfOneSize) {
  scene::Scene scene = four_telescopes();
  scene.telescope[2].half_field_of_view_mrad = 50;
  EXPECT_EQ(nested_views(scene), (Groups{{0}, {3, 1, 2}}));
}

// Seen red: without the estimator; without the reception.
TEST(NestedViews, ShareSingleRaysAlone) {
  const Groups alone{{0}, {1}, {2}, {3}}, shared{{0}, {2, 3, 1}};
  scene::Scene scene = four_telescopes();
  scene.simulation.reception = scene::Reception::overlap;
  EXPECT_EQ(nested_views(scene), alone);
  scene.simulation.reception = scene::Reception::ray;
  using enum scene::Estimator;
  for (const auto estimator : {forward, bidirectional, automatic}) {
    scene.simulation.estimator = estimator;
    EXPECT_EQ(nested_views(scene), shared);
  }
  scene.simulation.estimator = analog;
  EXPECT_EQ(nested_views(scene), alone);
  EXPECT_TRUE(reported_nested_views(scene).empty());
}

// What the tallies get of them. Seen red: with each telescope's next narrower one.
TEST(NestedViews, AreInTheShapeOfTheTallies) {
  const auto wider = make_model(four_telescopes(), *test::tables()).shape.wider;
  EXPECT_EQ(wider, (decltype(wider){std::nullopt, std::nullopt, 3, 1}));
}

TEST(NestedViews, AreListedFromTheNarrowestOn) {
  EXPECT_EQ(reported_nested_views(four_telescopes()),
            std::vector<std::string>{"telescopes narrow, middle and wide have views inside each "
                                     "other: what is drawn for one serves all"});
}

}  // namespace
}  // namespace photic::estimator
