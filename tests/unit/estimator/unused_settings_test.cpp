// Settings that a scene names and that its estimator does not use.
#include "estimator/unused_settings.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "estimator/model.hpp"
#include "scene/read.hpp"
#include "support/tables.hpp"
#include "unit/scene/base_scene.hpp"

namespace photic::estimator {
namespace {

using Texts = std::vector<std::string>;
using Overrides = std::vector<scene::Override>;

scene::Reading read(const std::string& simulation, const Overrides& overrides = {},
                    const std::string& channel = R"(process = "elastic")") {
  return scene::read_scene_text(scene::edited({{17, 17, channel},
                                               {23, 25, "[[sea.layer]]\nchlorophyll_mg_m3 = 1"},
                                               {30, 30, "photons = 1e6\n" + simulation}}),
                                "scene.toml", "/", overrides, optics_check(test::tables()));
}

/// The remarks on settings without effect; the first line of `simulation` is number 30.
Texts remarks(const std::string& simulation, const Overrides& overrides = {},
              const std::string& channel = R"(process = "elastic")") {
  Texts out;
  for (const std::string& text : read(simulation, overrides, channel).remarks)
    if (text.find("has no effect") != std::string::npos) out.push_back(text);
  return out;
}

const std::string of_walks =
    "walks = 3\nmeetings = 50\nconnected_fraction = 0.5\nwalk_attenuation = 0.8\n"
    "free_telescope_meetings = 1\nfree_laser_meetings = 0\n";
const std::string of_histories = "directed_fraction = 0.4\nscored_points = 2\n";
const std::string of_raman = R"(process = "raman")";

// Seen red: without the row of `walks`.
TEST(UnusedSettings, OfWalksWhereThereAreNone) {
  const auto all = [](const std::string& why) {
    return Texts{"scene.toml:30:9: 'walks'" + why,
                 "scene.toml:31:12: 'meetings'" + why,
                 "scene.toml:32:22: 'connected_fraction'" + why,
                 "scene.toml:33:20: 'walk_attenuation'" + why,
                 "scene.toml:34:27: 'free_telescope_meetings'" + why,
                 "scene.toml:35:23: 'free_laser_meetings'" + why};
  };
  const std::string advice = "; leave it out, or write estimator = \"bidirectional\"";
  EXPECT_EQ(remarks(of_walks + "estimator = \"forward\""),
            all(" has no effect: the forward estimator has no walks" + advice));
  EXPECT_EQ(remarks(of_walks + "estimator = \"analog\""),
            all(" has no effect: the analog estimator has no walks" + advice));
  EXPECT_EQ(remarks(of_walks + "estimator = \"bidirectional\""), Texts{});
  EXPECT_EQ(remarks(of_walks + of_histories + "estimator = \"auto\""), Texts{});
}

// Where it has no choice. Seen red: without regard to tools; to waves; with the advice to write
// what would be refused.
TEST(UnusedSettings, OfWalksWhereAutoTakesTheForwardEstimator) {
  const std::string place = "scene.toml:30:9: 'walks' has no effect: ";
  const Overrides tools{"simulation.tools.forced_collisions=1"};
  EXPECT_EQ(remarks("walks = 3", tools),
            Texts{place + "auto takes the forward estimator, the only one with simulation.tools; "
                          "leave it or the tools out"});
  EXPECT_EQ(remarks("walks = 3\nestimator = \"forward\"", tools),
            Texts{place + "the forward estimator has no walks; leave it out"});
  EXPECT_EQ(
      remarks("walks = 3", {"telescope.0.direction=[1, 0, -0.15]",
                            "sea.surface={ model = \"gaussian\", upwind_slope_variance = 0.02, "
                            "crosswind_slope_variance = 0 }"}),
      Texts{place + "auto takes the forward estimator, the only one for one-dimensional waves seen "
                    "by rays within 12 degrees of the horizontal; leave it out"});
}

// Seen red: without the row of `tools.weight_threshold`.
TEST(UnusedSettings, OfTheForwardEstimatorWhereItHasNoHistories) {
  const Overrides more{"simulation.reception=overlap", "simulation.tools.weight_threshold=0.2"};
  const auto all = [](const std::string& why) {
    const std::string all_of_it =
        " has no effect: " + why + "; leave it out, or write estimator = \"forward\"";
    return Texts{"scene.toml:30:21: 'directed_fraction'" + all_of_it,
                 "scene.toml:31:17: 'scored_points'" + all_of_it,
                 "--set simulation.reception: 'reception'" + all_of_it,
                 "--set simulation.tools.weight_threshold: 'tools.weight_threshold'" + all_of_it};
  };
  EXPECT_EQ(remarks(of_histories + "estimator = \"bidirectional\"", more),
            all("it is a setting of the forward estimator"));
  EXPECT_EQ(remarks(of_histories + "estimator = \"analog\"", more),
            all("analog photons are followed by chance alone"));
  EXPECT_EQ(remarks(of_histories + "estimator = \"forward\"", more), Texts{});
}

// Histories beside walks have these settings: other values give other echoes there. Seen red:
// without regard to air; to oil; to telescopes that share light unless it is received by "overlap".
TEST(UnusedSettings, AreNotThoseOfHistoriesBesideWalks) {
  const std::string text = of_histories + "estimator = \"bidirectional\"";
  EXPECT_EQ(remarks(text, {"atmosphere={ profile = \"us-standard\", top_km = 20 }"}), Texts{});
  EXPECT_EQ(remarks(text, {"oil={ class = \"weakly-absorbing-crude\", thickness_um = 5 }"}),
            Texts{});
  const auto telescope = [](const char* name, const char* diameter_m) {
    return std::string("{ name = \"") + name +
           "\", position_m = [0, 0, 12], direction = [0, 0, -1], diameter_m = 0.4, "
           "focal_length_m = 2, detector_diameter_m = " +
           diameter_m + " }";
  };
  EXPECT_EQ(remarks("reception = \"overlap\"\nestimator = \"bidirectional\"",
                    {"telescope=[" + telescope("a", "0.01") + ", " + telescope("b", "0.04") + "]"}),
            Texts{});
}

// Seen red: without the rule; in air, where no points are chosen.
TEST(UnusedSettings, OfPointsThatAnotherSettingChooses) {
  const Overrides all{"simulation.tools.local_forced_collisions=all"};
  EXPECT_EQ(remarks("scored_points = 2", all),
            Texts{"scene.toml:30:17: 'scored_points' has no effect: local_forced_collisions = "
                  "\"all\" chooses the points that are scored; leave one of them out"});
  EXPECT_EQ(remarks("scored_points = 2",
                    {all.front(), "atmosphere={ profile = \"us-standard\", top_km = 20 }"}),
            Texts{});
}

// Seen red: without the rule; with a film's light taken for converted; in environments, which have
// the scene's settings.
TEST(UnusedSettings, OfConversionsWhereNothingIsConverted) {
  const std::string conversion = "conversion_probability = 0.5\n";
  const std::string place = "scene.toml:30:26: 'conversion_probability' has no effect: ";
  const Texts none{place +
                   "no light that a channel counts is converted in the water; leave it out"};
  EXPECT_EQ(remarks(conversion), none);
  EXPECT_EQ(remarks(conversion + "estimator = \"forward\""), none);
  EXPECT_EQ(remarks(conversion, {"oil={ class = \"weakly-absorbing-crude\", thickness_um = 5 }"},
                    R"(process = "oil")"),
            none);
  EXPECT_EQ(remarks(conversion, {}, of_raman), Texts{});
  const std::string fluorescence = R"(process = "chlorophyll")";
  EXPECT_EQ(remarks(conversion,
                    {"environment=[{ set = { \"sea.layer.0.chlorophyll_mg_m3\" = 0, "
                     "\"sea.layer.1.chlorophyll_mg_m3\" = 0 } }]"},
                    fluorescence),
            Texts{});
  EXPECT_EQ(
      remarks(conversion + "estimator = \"analog\"", {}, of_raman),
      Texts{place + "analog photons are converted as often as the water converts them; leave it "
                    "out"});
}

// Seen red: without the rule; with the laser's reason for telescopes; in air, whose walks may be
// free where those in the water are not.
TEST(UnusedSettings, OfFreeWalksThatCannotBe) {
  const std::string free = "free_telescope_meetings = 1\nfree_laser_meetings = 2\n";
  const std::string walks = free + "estimator = \"bidirectional\"";
  const std::string collimated = "source.half_divergence_mrad=0";
  const Texts laser{
      "scene.toml:31:23: 'free_laser_meetings' has no effect: there are no free "
      "walks of the laser: its rays are parallel; leave it out, or write 0"};
  EXPECT_EQ(remarks(walks), Texts{});
  EXPECT_EQ(remarks(walks, {collimated}), laser);
  EXPECT_EQ(remarks(free, {collimated}), laser);
  EXPECT_EQ(remarks("free_laser_meetings = 0", {collimated}), Texts{});
  EXPECT_EQ(remarks(walks, {collimated, "atmosphere={ profile = \"us-standard\", top_km = 20 }"}),
            Texts{});
  EXPECT_EQ(
      remarks(walks, {"telescope.0.position_m=[0.5, 0, -1]", "telescope.0.direction=[0.2, 0, -1]",
                      "gates={ start_ns = 0, stop_ns = 100, step_ns = 10 }"}),
      Texts{"scene.toml:30:27: 'free_telescope_meetings' has no effect: there are no free "
            "walks of telescopes: not from t: in the water, and tilted or with a view to the "
            "side; leave it out, or write 0"});
}

/// The simulation of a result.
scene::Simulation effective(const std::string& simulation, const Overrides& overrides,
                            const std::string& channel) {
  const Model model = make_model(read(simulation, overrides, channel).scene, *test::tables());
  const auto again = scene::read_scene_text(scene::write_scene(reported_scene(model)), "s", "/", {},
                                            optics_check(test::tables()));
  for (const std::string& text : again.remarks)
    EXPECT_EQ(text.find("has no effect"), std::string::npos) << text;
  return model.scene.simulation;
}

// A result's scene names what is in effect. Seen red: with the settings as they were; with the free
// walks of the laser open, so that pilots would decide on them.
TEST(UnusedSettings, AreNotInResults) {
  const std::string named =
      "walks = 3\nmeetings = 50\nconnected_fraction = 0.5\nwalk_attenuation = 0.8\n"
      "free_telescope_meetings = 1\nfree_laser_meetings = 2\nconversion_probability = 0.5\n" +
      of_histories;
  const Overrides collimated{"source.half_divergence_mrad=0"};
  const auto forward = effective(named + "estimator = \"forward\"", collimated, of_raman);
  EXPECT_FALSE(forward.walks || forward.meetings || forward.connected_fraction ||
               forward.walk_attenuation || forward.free_telescope_meetings ||
               forward.free_laser_meetings);
  EXPECT_EQ(forward.directed_fraction, 0.4);
  EXPECT_EQ(forward.scored_points, 2);
  EXPECT_EQ(forward.conversion_probability, 0.5);
  const auto walks = effective(named + "estimator = \"bidirectional\"", collimated, of_raman);
  EXPECT_FALSE(walks.directed_fraction || walks.scored_points);
  EXPECT_EQ(walks.walks, 3);
  EXPECT_EQ(walks.free_telescope_meetings, 1);
  EXPECT_EQ(walks.free_laser_meetings, 0);
  EXPECT_EQ(walks.conversion_probability, 0.5);
  const auto analog = effective(named + "estimator = \"analog\"", collimated, of_raman);
  EXPECT_FALSE(analog.walks || analog.directed_fraction || analog.conversion_probability);
  const std::string elastic = R"(process = "elastic")";
  for (const char* estimator : {"forward", "bidirectional"})
    EXPECT_FALSE(effective(std::string("estimator = \"") + estimator + '"', {}, elastic)
                     .conversion_probability);
}

}  // namespace
}  // namespace photic::estimator
