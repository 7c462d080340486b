// The histories that each scene of scenes/ takes, by each estimator.
#include "estimator/plan.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "core/error.hpp"
#include "estimator/random_blocks.hpp"
#include "scene/read.hpp"
#include "support/tables.hpp"

namespace photic::estimator {
namespace {

std::string stream_name(std::uint64_t stream) {
  const std::map<std::uint64_t, std::string> names{{0, "own"},
                                                   {air_stream, "air"},
                                                   {beside_walks_stream, "beside walks"},
                                                   {beside_water_stream, "beside water"},
                                                   {beside_air_stream, "beside air"}};
  return names.at(stream);
}

/// "0: walks in water, draws own, scores all, in ledger"
std::string text_of(const Plan& plan) {
  using Kind = HistorySet::Kind;
  const std::map<Kind, std::string> kinds{{Kind::histories, "histories"},
                                          {Kind::walks, "walks"},
                                          {Kind::surface_echo, "surface echo"},
                                          {Kind::analog, "analog"}};
  const std::map<Scored, std::string> scored{{Scored::all, "all"},
                                             {Scored::film, "film"},
                                             {Scored::none, "none"},
                                             {Scored::from_water, "from water"}};
  std::string out;
  for (std::size_t i = 0; i < plan.sets.size(); ++i) {
    const HistorySet& set = plan.sets[i];
    out +=
        fmt::format("{}: {} in {}, draws {}, scores {}{}{}", i, kinds.at(set.kind),
                    set.model->medium.kind == medium::MediumKind::air ? "air" : "water",
                    stream_name(set.stream), scored.at(set.scored),
                    set.from_laser ? "" : ", arrivals alone", set.in_ledger ? ", in ledger" : "");
    if (set.passes_to)
      out += fmt::format(", {} to {}", set.passes_to->chance < 1 ? "a share" : "all",
                         set.passes_to->set);
    out += "\n";
  }
  return out;
}

/// The plan of a scene by an estimator, or that there is none.
std::string plan_of(const std::filesystem::path& file, const std::string& estimator,
                    std::vector<scene::Override> more = {}) {
  try {
    more.push_back({"simulation.estimator=" + estimator});
    const auto scene = scene::read_scene(file.string(), more);
    const Model model = make_model(scene.scene, *test::tables());
    return text_of(make_plan(model));
  } catch (const InputError&) {
    return "refused";
  }
}

struct Plans {
  std::string forward, bidirectional, analog;
};
const Plans clear{"0: histories in water, draws own, scores all, in ledger\n",
                  "0: walks in water, draws own, scores all, in ledger\n",
                  "0: analog in water, draws own, scores all, in ledger\n"};
const Plans without_walks{clear.forward, "refused", clear.analog};
const Plans waves{clear.forward,
                  "0: walks in water, draws own, scores all, in ledger\n"
                  "1: surface echo in water, draws own, scores all\n",
                  clear.analog};
const Plans oil{clear.forward,
                "0: walks in water, draws own, scores all, in ledger\n"
                "1: histories in water, draws beside walks, scores film\n",
                "refused"};
const Plans air{
    "0: histories in water, draws own, scores all, in ledger, a share to 1\n"
    "1: histories in air, draws air, scores all, all to 2\n"
    "2: histories in water, draws own, scores all, arrivals alone, a share to 1\n",
    "0: walks in water, draws own, scores all, in ledger\n"
    "1: walks in air, draws air, scores all\n"
    "2: histories in water, draws beside water, scores none, a share to 3\n"
    "3: histories in air, draws beside air, scores from water, all to 4\n"
    "4: histories in water, draws beside water, scores all, arrivals alone, a share to "
    "3\n",
    "0: analog in air, draws air, scores all, in ledger, all to 1\n"
    "1: analog in water, draws own, scores all, arrivals alone, in ledger, a share to "
    "0\n"};
const Plans air_over_waves{
    air.forward,
    "0: walks in water, draws own, scores all, in ledger\n"
    "1: surface echo in water, draws own, scores all\n"
    "2: walks in air, draws air, scores all\n"
    "3: histories in water, draws beside water, scores none, a share to 4\n"
    "4: histories in air, draws beside air, scores from water, all to 5\n"
    "5: histories in water, draws beside water, scores all, arrivals alone, a share to 4\n",
    air.analog};
const Plans air_over_oil{
    // so much air that all light is followed in it
    "0: histories in water, draws own, scores all, in ledger, all to 1\n"
    "1: histories in air, draws air, scores all, all to 2\n"
    "2: histories in water, draws own, scores all, arrivals alone, all to 1\n",
    "0: walks in water, draws own, scores all, in ledger\n"
    "1: histories in water, draws beside walks, scores film\n"
    "2: walks in air, draws air, scores all\n"
    "3: histories in water, draws beside water, scores none, all to 4\n"
    "4: histories in air, draws beside air, scores from water, all to 5\n"
    "5: histories in water, draws beside water, scores all, arrivals alone, all to 4\n",
    "refused"};

const std::map<std::string, Plans> plans_of_scenes{{"airborne", clear},
                                                   {"airborne-high", air},
                                                   {"airborne-waves", waves},
                                                   {"argo", clear},
                                                   {"bathymetric", clear},
                                                   {"benchmark-hg", clear},
                                                   {"benchmark-peaked", clear},
                                                   {"biaxial", clear},
                                                   {"cone", without_walks},
                                                   {"fluorosensor-355", clear},
                                                   {"minimal", clear},
                                                   {"oil-spill", oil},
                                                   {"oil-spill-airborne", air_over_oil},
                                                   {"plume", without_walks},
                                                   {"rov", clear},
                                                   {"ship", clear},
                                                   {"ship-tilted", clear},
                                                   {"ship-waves", waves},
                                                   {"spaceborne", air},
                                                   {"spaceborne-waves", air_over_waves},
                                                   {"sun", without_walks},
                                                   {"three-layers", clear}};

// Seen red: with walks in the air that draw the run's own numbers; without minimal.toml in the
// list.
TEST(Plan, OfEveryScene) {
  std::map<std::string, int> files;
  for (const auto& entry : std::filesystem::directory_iterator(PHOTIC_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    const std::string name = entry.path().stem();
    SCOPED_TRACE(name);
    ++files[name];
    const auto plans = plans_of_scenes.find(name);
    if (plans == plans_of_scenes.end()) {
      ADD_FAILURE() << "a new scene has no plan here";
      continue;
    }
    EXPECT_EQ(plan_of(entry.path(), "forward"), plans->second.forward);
    EXPECT_EQ(plan_of(entry.path(), "bidirectional"), plans->second.bidirectional);
    EXPECT_EQ(plan_of(entry.path(), "analog"), plans->second.analog);
  }
  EXPECT_EQ(files.size(), plans_of_scenes.size());
}

// Under air light sets out where the laser stands, and walks stay in the water if any instrument
// stands there. Seen red: with light of a laser in the water that sets out in the air; with walks
// in the air.
TEST(Plan, OfInstrumentsInTheWater) {
  const std::filesystem::path file = PHOTIC_SOURCE_DIR "/scenes/airborne-high.toml";
  const scene::Override times{"gates={ start_ns = 0, stop_ns = 100, step_ns = 10 }"};
  const auto plan = [&](const std::string& estimator, const std::string& where) {
    return plan_of(file, estimator, {times, {where}});
  };
  const std::string laser = "source.position_m=[0, 0, -1]",
                    telescope = "telescope.0.position_m=[0, 0, -1]";
  const auto sets = [](const std::string& arrivals) {
    return "1: histories in air, draws air, scores all" + arrivals + ", all to 2\n";
  };
  const std::string& by_air = air.forward;
  const auto line = [](const std::string& text, std::size_t number) {
    std::size_t at = 0;
    for (; number > 0; --number) at = text.find('\n', at) + 1;
    return text.substr(at, text.find('\n', at) + 1 - at);
  };
  EXPECT_EQ(plan("forward", telescope), by_air);
  EXPECT_EQ(plan("forward", laser), line(by_air, 0) + sets(", arrivals alone") + line(by_air, 2));
  for (const auto& where : {laser, telescope}) {
    const std::string arrivals = where == laser ? ", arrivals alone" : "";
    EXPECT_EQ(
        plan("bidirectional", where),
        "0: walks in water, draws own, scores all, in ledger\n"
        "1: histories in water, draws beside water, scores none, a share to 2\n"
        "2: histories in air, draws beside air, scores all" +
            arrivals +
            ", all to 3\n"
            "3: histories in water, draws beside water, scores all, arrivals alone, a share to "
            "2\n");
  }
  EXPECT_EQ(plan("analog", telescope), air.analog);
  EXPECT_EQ(plan("analog", laser),
            "0: analog in air, draws air, scores all, arrivals alone, in ledger, all to 1\n"
            "1: analog in water, draws own, scores all, in ledger, a share to 0\n");
}

}  // namespace
}  // namespace photic::estimator
