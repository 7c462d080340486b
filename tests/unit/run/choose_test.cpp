// What estimator = "auto" takes.
#include "run/choose.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/read.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"

namespace photic::run {
namespace {

scene::Scene scene_of(const std::string& estimator) {
  return test::read(test::ship_instrument + test::channel("elastic") +
                    test::water(0.06, 0.1, test::peaked_phase) + test::depth_gates(30, 3) +
                    test::simulation(5000, 3, "", estimator));
}

RunOptions on_threads(int threads) {
  RunOptions options;
  options.threads = threads;
  return options;
}

scene::Scene chosen_scene(scene::Scene scene, const RunOptions& options) {
  scene.simulation =
      choose_estimator(scene, estimator::make_model(scene, *test::tables()), options);
  return scene;
}

// Seen red: with the number of threads in the reason.
TEST(Choose, IsTheSameOnAnyNumberOfThreads) {
  const scene::Scene chosen = chosen_scene(scene_of("auto"), on_threads(1));
  EXPECT_EQ(chosen_scene(scene_of("auto"), on_threads(3)), chosen);
  EXPECT_NE(chosen.simulation.estimator, scene::Estimator::automatic);
  EXPECT_TRUE(chosen.simulation.estimator_reason);
}

// Seen red: with the engine in the reason.
TEST(Choose, IsTheSameByAnyEngine) {
  const scene::Scene chosen = chosen_scene(scene_of("auto"), {});
  for (const Isa isa : isas_here()) {
    RunOptions options;
    options.lanes = isa;
    EXPECT_EQ(chosen_scene(scene_of("auto"), options), chosen) << isa_name(isa);
  }
}

// Without pilots: the other estimator has no tools. Seen red: with tools overlooked.
TEST(Choose, TakesTheForwardEstimatorForTools) {
  scene::Scene asked = scene_of("auto");
  asked.simulation.tools.forced_collisions = 1;
  const scene::Scene chosen = chosen_scene(asked, {});
  EXPECT_EQ(chosen.simulation.estimator, scene::Estimator::forward);
  EXPECT_EQ(chosen.simulation.estimator_reason,
            "the only one with the requested tools in this version");
}

// Environments are had by either estimator, and stay. Seen red: with pilots that drop them.
TEST(Choose, KeepsEnvironments) {
  scene::Scene asked = scene_of("auto");
  asked.environment.push_back({"clearer", {}, asked.optics, asked.sea});
  asked.environment.back().sea.layer[0].iop[0].a_per_m = 0.03;
  const scene::Scene chosen = chosen_scene(asked, {});
  EXPECT_EQ(chosen.environment, asked.environment);
  EXPECT_EQ(chosen.simulation.estimator, scene::Estimator::bidirectional);
  EXPECT_NE(chosen.simulation.estimator_reason->find("pilot runs"), std::string::npos);
}

// Seen red: with the pilots' seed.
TEST(Choose, ChangesNothingElse) {
  const scene::Scene asked = scene_of("auto");
  scene::Scene chosen = chosen_scene(asked, {});
  chosen.simulation.estimator = asked.simulation.estimator;
  chosen.simulation.estimator_reason.reset();
  chosen.simulation.walk_attenuation = asked.simulation.walk_attenuation;
  chosen.simulation.directed_fraction = asked.simulation.directed_fraction;
  chosen.simulation.scored_points = asked.simulation.scored_points;
  chosen.simulation.free_telescope_meetings = asked.simulation.free_telescope_meetings;
  chosen.simulation.free_laser_meetings = asked.simulation.free_laser_meetings;
  EXPECT_EQ(chosen, asked);
}

// Seen red: with columns left out of bidirectional_lacks.
TEST(Choose, TakesTheForwardEstimatorOverColumns) {
  scene::Scene asked = scene_of("auto");
  asked.sea.column.emplace_back().layer = asked.sea.layer;
  asked.sea.layer.clear();
  const scene::Simulation chosen = chosen_scene(asked, {}).simulation;
  EXPECT_EQ(chosen.estimator, scene::Estimator::forward);
  EXPECT_EQ(chosen.estimator_reason,
            "the bidirectional one cannot treat columns of water: five of its seven strategies "
            "move a walk and need a sea that is alike everywhere, and what stays does not converge "
            "on peaked water");
}

TEST(Choose, LeavesAChoiceThatIsMade) {
  EXPECT_EQ(chosen_scene(scene_of("forward"), {}), scene_of("forward"));
  scene::Scene asked = scene_of("bidirectional");
  asked.simulation.free_telescope_meetings = 0.3;
  asked.simulation.free_laser_meetings = 0;
  EXPECT_EQ(chosen_scene(asked, {}), asked);
}

// Seen red: with one of them named taken for both.
TEST(Choose, SaysHowOftenFreeWalksMeet) {
  const scene::Scene asked = scene_of("bidirectional");
  scene::Scene chosen = chosen_scene(asked, {});
  scene::Simulation& s = chosen.simulation;
  EXPECT_TRUE(s.free_telescope_meetings && s.free_laser_meetings);
  EXPECT_NE(s.estimator_reason->find("free walks"), std::string::npos);
  s.free_telescope_meetings.reset();
  s.free_laser_meetings.reset();
  s.estimator_reason.reset();
  EXPECT_EQ(chosen, asked);
  scene::Scene one = asked;
  one.simulation.free_laser_meetings = 0.7;
  EXPECT_EQ(chosen_scene(one, {}).simulation.free_laser_meetings, 0.7);
}

/// From an aeroplane, by a wide view, in peaked water.
scene::Scene wide_scene(const std::string& simulation) {
  return test::read(
      "[source]\nwavelength_nm = 532.0\nposition_m = [0.0, 0.0, 300.0]\n"
      "direction = [0.0, 0.0, -1.0]\ndiameter_m = 0.01\nhalf_divergence_mrad = 2.0\n"
      "[[telescope]]\nposition_m = [0.0, 0.0, 300.0]\ndirection = [0.0, 0.0, -1.0]\n"
      "diameter_m = 0.3\nfocal_length_m = 1.0\nhalf_field_of_view_mrad = 15.0\n" +
      test::channel("elastic") + test::water(0.06, 0.1, test::peaked_phase) +
      test::depth_gates(40, 4) + simulation);
}

// Of each kind some tens in a set of walks. Seen red: without free walks; with ten times as many.
TEST(Choose, HasWalksFreeInWideViews) {
  const auto s =
      chosen_scene(wide_scene(test::simulation(50000, 3, "", "bidirectional")), {}).simulation;
  EXPECT_GT(s.free_telescope_meetings, 0.02);
  EXPECT_LT(s.free_telescope_meetings, 0.2);
  EXPECT_GT(s.free_laser_meetings, 1);
  EXPECT_LE(s.free_laser_meetings, 2.5);
}

// A clock is never looked at, nor is how long one may run by it. Seen red: with a pilot that ends
// by max_time_s.
TEST(Choose, DoesNotDependOnTheTimeLimit) {
  scene::Scene one = scene_of("auto");
  one.simulation.photons.reset();
  one.simulation.max_time_s = 1e-6;
  scene::Scene other = one;
  other.simulation.max_time_s = 1000;
  scene::Scene chosen = chosen_scene(one, {});
  chosen.simulation.max_time_s = 1000;
  EXPECT_EQ(chosen, chosen_scene(other, {}));
}

/// Seen by a telescope over water of so much absorption, and as much scattering.
scene::Scene clear_scene(double per_m, const std::string& gates) {
  return test::read(test::ship_instrument + test::channel("elastic") +
                    test::water(per_m, per_m, test::henyey_greenstein_phase) + gates +
                    test::simulation(5000, 3, "", "auto"));
}

// Seen red: as it was, with photons that cost nothing, 1 for the squared error of a gate without a
// score, and a contest of those that saw nothing.
TEST(Choose, NeverTakesWhatSawNothing) {
  for (const double per_m : {1e-7, 1e-12}) {
    const auto chosen = chosen_scene(clear_scene(per_m, test::depth_gates(50, 5)), {});
    EXPECT_EQ(chosen.simulation.estimator, scene::Estimator::bidirectional);
  }
}

// The telescope looks away from the sea. Seen red: with the forward estimator.
TEST(Choose, SaysThatNothingWasSeen) {
  auto asked = clear_scene(0.1, "[gates]\nstart_ns = 80.0\nstop_ns = 120.0\nstep_ns = 10.0\n");
  asked.telescope[0].direction = {0, 0, 1};
  const auto chosen = chosen_scene(asked, {}).simulation;
  EXPECT_EQ(chosen.estimator, scene::Estimator::bidirectional);
  EXPECT_EQ(chosen.walk_attenuation, 0.6);
  EXPECT_EQ(chosen.estimator_reason, reason_unseen);
  EXPECT_NE(run(asked, *test::tables()).warnings.back().find("saw no light at all"),
            std::string::npos);
}

// Settings of the forward estimator that the scene names stay. Seen red: with all candidates.
TEST(Choose, LeavesForwardSettingsThatAreGiven) {
  scene::Scene asked = scene_of("auto");
  asked.simulation.directed_fraction = 0.4;
  EXPECT_EQ(chosen_scene(asked, {}).simulation.directed_fraction, 0.4);
  asked.simulation.scored_points = 3;
  const auto chosen = chosen_scene(asked, {}).simulation;
  EXPECT_EQ(chosen.scored_points, 3);
  const std::string given = "forward with directed_fraction = 0.4 and scored_points = 3";
  const std::size_t at = chosen.estimator_reason->find(given);
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(chosen.estimator_reason->find("forward", at + 1), std::string::npos);
}

// Seen red: with all candidates.
TEST(Choose, LeavesAWalkAttenuationThatIsGiven) {
  scene::Scene asked = scene_of("auto");
  asked.simulation.walk_attenuation = 0.7;
  const auto chosen = chosen_scene(asked, {}).simulation;
  EXPECT_EQ(chosen.walk_attenuation, 0.7);
  EXPECT_EQ(chosen.estimator_reason->find("walk_attenuation = 0.6"), std::string::npos);
}

// Of the settings that are tried those that the scene names stay. Seen red: with all of them tried.
TEST(Choose, LeavesSettingsOfWalksThatAreGiven) {
  scene::Scene asked = scene_of("auto");
  asked.simulation.photons = 200000;
  const auto open = chosen_scene(asked, {}).simulation;
  EXPECT_NE(open.estimator_reason->find("then, against the best so far: meetings = 30"),
            std::string::npos);
  EXPECT_NE(open.estimator_reason->find("walks = 4"), std::string::npos);
  asked.simulation.meetings = 70;
  asked.simulation.walks = 3;
  const auto named = chosen_scene(asked, {}).simulation;
  EXPECT_EQ(named.meetings, 70);
  EXPECT_EQ(named.walks, 3);
  EXPECT_EQ(named.estimator_reason->find("meetings = "), std::string::npos);
  EXPECT_EQ(named.estimator_reason->find("walks = "), std::string::npos);
}

// Nothing is converted there. Seen red: with any scene.
TEST(Choose, TriesConversionsWhereLightIsConverted) {
  for (const std::string process : {"elastic", "raman"}) {
    const auto asked = test::read(test::ship_instrument + test::channel(process) +
                                  "[[sea.layer]]\nchlorophyll_mg_m3 = 0.1\n" +
                                  test::depth_gates(30, 10) + test::simulation(2e5, 3, "", "auto"));
    const auto reason = *chosen_scene(asked, {}).simulation.estimator_reason;
    EXPECT_EQ(reason.find("conversion_probability = 0.6") != std::string::npos, process == "raman")
        << reason;
  }
}

// docs/decisions/0010 has the measurement. Longer free paths look better to a short run than they
// are. Seen red: without the weight of large scores.
TEST(Choose, TakesWhatIsBestOnPeakedWater) {
  const auto peaked = scene::read_scene(PHOTIC_SOURCE_DIR "/scenes/benchmark-peaked.toml").scene;
  const auto chosen = chosen_scene(peaked, {}).simulation;
  EXPECT_EQ(chosen.estimator, scene::Estimator::bidirectional);
  EXPECT_EQ(chosen.walk_attenuation, 0.6);
}

/// The shares that contend, as the reason names them.
std::vector<double> walk_attenuations_in(const std::string& reason) {
  const std::string name = "walk_attenuation = ";
  std::vector<double> out;
  for (auto at = reason.find(name); at != std::string::npos; at = reason.find(name, at + 1))
    out.push_back(std::stod(reason.substr(at + name.size())));
  return out;
}

// A walk whose weight grows at every vertex looks good in a pilot. Seen red: without the limit
// (0.35 contends); with one for the first layer alone.
TEST(Choose, NeverLetsWeightsGrow) {
  for (const auto& [upper, lower] : {std::pair{0.06, 0.06}, std::pair{0.4, 0.01}}) {
    const auto layer = [](double a, const std::string& bottom) {
      return fmt::format(
          "[[sea.layer]]\niop = [ {{ wavelength_nm = 532.0, a_per_m = {}, b_per_m = 0.1 }} ]\n"
          "phase_function = {}\n{}",
          a, test::peaked_phase, bottom);
    };
    const auto scene = test::read(test::ship_instrument + test::channel("elastic") +
                                  layer(upper, "bottom_depth_m = 2.0\n") + layer(lower, "") +
                                  test::depth_gates(30, 3) + test::simulation(2e5, 3, "", "auto"));
    const auto chosen = chosen_scene(scene, {}).simulation;
    auto shares = walk_attenuations_in(*chosen.estimator_reason);
    shares.push_back(chosen.walk_attenuation.value_or(1));
    for (const double share : shares) EXPECT_GE(share, 0.9 * 0.1 / (lower + 0.1));
  }
}

// What is made small is stated. Seen red: with the aim of a scene without a target.
TEST(Choose, SaysWhatItMakesSmall) {
  scene::Scene asked = scene_of("auto");
  const auto has = [](const scene::Scene& chosen, const char* words) {
    return chosen.simulation.estimator_reason->find(words) != std::string::npos;
  };
  EXPECT_TRUE(has(chosen_scene(asked, {}), "squared error at equal cost, geometric mean over"));
  asked.simulation.target_relative_error = 0.05;
  EXPECT_TRUE(has(chosen_scene(asked, {}),
                  "until the worst fifth of 10 gates has a relative "
                  "error of 0.05"));
}

// Seen red: with "auto" left in the scene.
TEST(Choose, WritesASceneThatRepeatsTheRun) {
  const tally::Result first = run(scene_of("auto"), *test::tables());
  const auto effective = scene::read_scene_text(first.scene_toml, "effective.toml", ".").scene;
  EXPECT_NE(effective.simulation.estimator, scene::Estimator::automatic);
  const tally::Result again = run(effective, *test::tables());
  EXPECT_EQ(again.scene_toml, first.scene_toml);
  EXPECT_EQ(again.state, first.state);
}

}  // namespace
}  // namespace photic::run
