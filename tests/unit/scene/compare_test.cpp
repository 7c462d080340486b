// In what two scenes differ.
#include "scene/compare.hpp"

#include <gtest/gtest.h>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {

void PrintTo(const Difference& d, std::ostream* out) {
  *out << d.path << ": " << d.left << " | " << d.right;
}

namespace {

using Differences = std::vector<Difference>;

TEST(Differences, AreNoneBetweenAlikeScenes) {
  EXPECT_EQ(differences(base_scene(), base_scene()), Differences{});
  // Written in another way, but the same scene.
  EXPECT_EQ(differences(base_scene({"simulation.seed=1", "title=a"}), base_scene({"title='a'"})),
            Differences{});
}

// Seen red: with the keys of the right scene alone not looked for; with only the first element of
// an array looked at.
TEST(Differences, AreNamedByPath) {
  const Scene left = base_scene();
  const auto against = [&](const std::vector<Override>& overrides) {
    return differences(left, base_scene(overrides));
  };
  EXPECT_EQ(against({"simulation.seed=7"}), (Differences{{"simulation.seed", "1", "7"}}));
  EXPECT_EQ(against({"telescope.0.position_m.1=2.5"}),
            (Differences{{"telescope.0.position_m.1", "0", "2.5"}}));
  EXPECT_EQ(against({"sea.layer.1.iop.0.a_per_m=0.07"}),
            (Differences{{"sea.layer.1.iop.0.a_per_m", "0.06", "0.07"}}));
  EXPECT_EQ(against({"sea.layer.1.phase_function='petzold'"}),
            (Differences{{"sea.layer.1.phase_function.model", "text \"henyey-greenstein\"",
                          "text \"petzold\""},
                         {"sea.layer.1.phase_function.g", "0.9", "not given"}}));
  EXPECT_EQ(against({"channel=[{name='a', process='elastic'}, {name='b', process='raman'}]"}),
            (Differences{{"channel", "an array of 1", "an array of 2"}}));
  EXPECT_EQ(
      against({"sensitivity=['sea.layer.0.chlorophyll_mg_m3']"}),
      (Differences{{"sensitivity", "not given", "[text \"sea.layer.0.chlorophyll_mg_m3\"]"}}));
  EXPECT_EQ(against({"simulation.max_order=3"}),
            (Differences{{"simulation.max_order", "not given", "3"}}));
  EXPECT_EQ(differences(base_scene({"simulation.max_order=3"}), left),
            (Differences{{"simulation.max_order", "3", "not given"}}));
}

TEST(Differences, OfTextsAreSeenBeyondWhatAMessageShows) {
  const std::string alike(60, 'a');
  EXPECT_EQ(differences(base_scene({"title=" + alike + "b"}), base_scene({"title=" + alike + "c"}))
                .size(),
            1U);
}

TEST(Differences, ComeInTheOrderOfTheFile) {
  std::vector<std::string> paths;
  for (const Difference& d :
       differences(base_scene(), base_scene({"simulation.seed=7", "source.diameter_m=0.5"})))
    paths.push_back(d.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"source.diameter_m", "simulation.seed"}));
}

}  // namespace
}  // namespace photic::scene
