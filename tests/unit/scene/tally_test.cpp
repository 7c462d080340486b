// [[tally]]: what is read, what is written, and all that is wrong with line and column.
#include <gtest/gtest.h>

#include "scene/forward_settings.hpp"
#include "scene/tally_memory.hpp"
#include "unit/scene/base_scene.hpp"
#include "unit/scene/lit_scene.hpp"

namespace photic::scene {
namespace {

const std::string irradiance = "[[tally]]\nkind = \"irradiance\"\n";
const std::string fluence = "[[tally]]\nkind = \"fluence\"\n";
const std::string radiance = "[[tally]]\nkind = \"radiance\"\n";
const std::string escape = "[[tally]]\nkind = \"boundaries\"\n";
const std::string cells = "depth_m = [0, 1]\nradius_m = [0, 1]\n";
const std::string air = "[atmosphere]\nprofile = \"us-standard\"\ntop_km = 50\n";

Texts remarks_of(const std::string& text) {
  return read_scene_text(text, "scene.toml", "/").remarks;
}

TEST(Tallies, ReadEveryKey) {
  const Scene scene = read_text(
      lit_scene(sun, irradiance + "depth_m = [0, 5.5]\nheight_m = [0]\nslab_m = 0.1\n" + radiance +
                         "height_m = [0]\ndirection_deg = [[0, 0], [150, -40]]\n" + balance));
  ASSERT_EQ(scene.tally.size(), 3U);
  EXPECT_EQ(scene.tally[0].kind, TallyKind::irradiance);
  EXPECT_EQ(scene.tally[0].depth_m, (std::vector<double>{0, 5.5}));
  EXPECT_EQ(scene.tally[0].height_m, std::vector<double>{0});
  EXPECT_EQ(scene.tally[0].slab_m, 0.1);
  EXPECT_EQ(scene.tally[1].direction_deg, (std::vector<TravelDirection>{{0, 0}, {150, -40}}));
  EXPECT_EQ(scene.tally[2].zenith_deg,
            (std::vector<double>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90}));
  EXPECT_TRUE(scene.telescope.empty());
  EXPECT_EQ(scene.gates.count(), 0);
}

// Seen red: with a sea written below air alone.
TEST(Tallies, AreWrittenAsTheyWereRead) {
  const std::string two_maps = fluence + "name = \"a\"\n" + cells + fluence +
                               "name = \"b-2\"\nheight_m = [0, 1, 3]\nx_m = [-1, 0.1]\n";
  for (const std::string& text :
       {lit_scene(sun, irradiance + "depth_m = [0, 0.1]\nslab_m = 0.3\n" + radiance +
                           "depth_m = [0]\nheight_m = [0.7]\ndirection_deg = [[0.1, 0.3]]"),
        lit_scene(lamp, two_maps + escape + "zenith_deg = [0, 0.1, 90]"),
        lit_scene(laser, std::string(telescope) + '\n' + balance), lit_scene(lamp, fluence + cells),
        lit_scene(sun, balance, air_alone),
        lit_scene(
            sun, balance,
            "[atmosphere]\nsurface = { albedo = { zenith_deg = [0, 90], albedo = [0.1, 0.2] } }\n"
            "[[atmosphere.layer]]\nbottom_height_m = 0\ntop_height_m = 1e3\niop = [{ "
            "wavelength_nm = 532, a_per_m = 0, b_per_m = 1e-5 }]"),
        lit_scene(sun, balance,
                  std::string(water) +
                      "\n[sea]\nsurface = { model = \"cox-munk\", wind_speed_m_s = 5, facets = "
                      "\"reciprocal\" }")}) {
    const Scene scene = read_text(text);
    const std::string written = write_scene(scene);
    EXPECT_TRUE(read_text(written) == scene) << written;
    EXPECT_EQ(write_scene(read_text(written)), written);
  }
}

// Seen red: with a sea written.
TEST(Tallies, AirAloneHasAGroundAndNoSea) {
  const Scene scene = read_text(lit_scene(sun, balance, air_alone));
  EXPECT_TRUE(scene.is_of_air_alone());
  EXPECT_TRUE(scene.sea.layer.empty());
  EXPECT_EQ(std::get<double>(scene.atmosphere->surface->albedo), 0.3);
  EXPECT_EQ(write_scene(scene).find("[sea]"), std::string::npos);
  EXPECT_FALSE(read_text(lit_scene(sun)).is_of_air_alone());
}

TEST(Tallies, FacetsAreLeftOpenOrNamed) {
  const std::string rough =
      std::string(water) + "\n[sea]\nsurface = { model = \"cox-munk\", wind_speed_m_s = 5";
  EXPECT_EQ(read_text(lit_scene(sun, balance, rough + " }")).sea.surface.facets, std::nullopt);
  EXPECT_EQ(
      read_text(lit_scene(sun, balance, rough + ", facets = \"reciprocal\" }")).sea.surface.facets,
      FacetWeight::reciprocal);
}

// Seen red: with the usual fraction.
TEST(Tallies, NoDirectionsAreDrawnTowardsTelescopes) {
  const std::string both = std::string(telescope) + '\n' + balance;
  const Scene scene = read_text(lit_scene(laser, both));
  EXPECT_EQ(directed_fraction_in(scene), 0);
  for (const ForwardSettings& settings : forward_settings(scene))
    EXPECT_EQ(settings.directed_fraction, 0);
  EXPECT_EQ(remarks_of(lit_scene(laser, both)),
            Texts{"scene.toml:19:1: beside tallies no directions are drawn towards telescopes: "
                  "simulation.directed_fraction is 0, and echoes take longer"});
  EXPECT_EQ(remarks_of(lit_scene(laser, both, water, "photons = 1\ndirected_fraction = 0")),
            Texts{});
  EXPECT_EQ(remarks_of(lit_scene(sun)), Texts{});
}

TEST(Tallies, AreNotOfOtherWaters) {
  EXPECT_EQ(
      remarks_of(lit_scene(laser, std::string(telescope) + '\n' + balance, water,
                           "photons = 1\ndirected_fraction = 0\n[[environment]]\nset = { "
                           "\"sea.layer.0.chlorophyll_mg_m3\" = 1 }")),
      Texts{"scene.toml:27:1: [[environment]] has only echoes: tallies are of the scene alone"});
}

// Seen red: without the octaves.
TEST(Tallies, TakeMemory) {
  const Scene one = read_text(lit_scene(sun, irradiance + "depth_m = [1]"));
  const Scene three = read_text(lit_scene(sun, irradiance + "depth_m = [1, 2]\nheight_m = [0]"));
  EXPECT_EQ(cells_of_tallies(one), 4);
  EXPECT_EQ(tally_memory(three).bytes(), 3 * tally_memory(one).bytes());
  EXPECT_EQ(tally_memory(three).batch, 3 * tally_memory(one).batch);
  // State: 72 bytes, and octaves of 128 x 8 bytes; twice. Batches: octaves of 128 x 4 bytes, two.
  EXPECT_GE(tally_memory(one).bytes(), 4 * (2 * (72 + 1024) + 2 * 512));
  EXPECT_EQ(cells_of_tallies(read_text(lit_scene(
                sun, radiance + "depth_m = [1, 2]\ndirection_deg = [[0, 0], [1, 0], [2, 0]]"))),
            6);
  EXPECT_EQ(cells_of_tallies(read_text(
                lit_scene(lamp, fluence + "depth_m = [0, 1, 2]\nradius_m = [0, 1, 2, 3]"))),
            6);
}

struct WrongTally {
  const char* name;
  std::string text;
  Texts expected;
};

std::vector<WrongTally> wrong_levels() {
  return {
      {"BelowTheBed",
       lit_scene(sun, irradiance + "depth_m = [0, 21]"),
       {"scene.toml:7:15: 21 m is below the sea bed at 20 m (end above it, or lower the last "
        "layer's bottom_depth_m)"}},
      {"AboveTheAir",
       lit_scene(sun, irradiance + "height_m = [0, 6e4]", air + water),
       {"scene.toml:7:16: 60000 m is above the top of the air at 50000 m (end below it: above "
        "there is a vacuum)"}},
      {"Negative",
       lit_scene(sun, irradiance + "depth_m = [-1]\nheight_m = [-1]"),
       {"scene.toml:7:11: 'depth_m' must be a list, each element a finite number, at least 0, not "
        "-1 (places above the sea have a height_m)",
        "scene.toml:8:12: 'height_m' must be a list, each element a finite number, at least 0, not "
        "-1 (places below the surface have a depth_m)"}},
      {"DepthsInAirAlone",
       lit_scene(sun, irradiance + "depth_m = [1]", air_alone),
       {"scene.toml:7:11: there are no depths: a ground takes the place of the sea (give heights: "
        "height_m)"}},
      {"NotAscending",
       lit_scene(sun, irradiance + "depth_m = [1, 1, 3, 2]"),
       {"scene.toml:7:15: 1 does not come after 1 (list them in ascending order, each once)",
        "scene.toml:7:21: 2 does not come after 3 (list them in ascending order, each once)"}},
      {"OneNumber",
       lit_scene(sun, irradiance + "depth_m = 1\nheight_m = []"),
       {"scene.toml:7:11: 'depth_m' must be a list of numbers, not 1 (write [1])",
        "scene.toml:8:12: 'height_m' must be a list of numbers, not [] (write [a, b, …])"}},
      {"None",
       lit_scene(sun, irradiance),
       {"scene.toml:5:1: [[tally]] needs 'depth_m' or 'height_m' (give levels in the water, in the "
        "air or both)"}},
      {"SlabNotPositive",
       lit_scene(sun, irradiance + "depth_m = [1]\nslab_m = 0"),
       {"scene.toml:8:10: 'slab_m' must be a finite number, greater than 0, not 0 (without it "
        "slabs are a twentieth of an attenuation length)"}},
      {"SlabThickerThanTheLayer",
       lit_scene(sun, irradiance + "depth_m = [1]\nslab_m = 20.5"),
       {"scene.toml:8:10: a slab of 20.5 m about 1 m is thicker than its layer from 0 to 20 m "
        "(write at most 20)"}},
      {"SlabThickerThanTheAir",
       lit_scene(sun, irradiance + "height_m = [1e3]\nslab_m = 2",
                 "[atmosphere]\nsurface = { albedo = 0 }\n[[atmosphere.layer]]\nbottom_height_m = "
                 "0\ntop_height_m = 1e3\niop = [{ wavelength_nm = 532, a_per_m = 0, b_per_m = 1e-5 "
                 "}]\n[[atmosphere.layer]]\nbottom_height_m = 1e3\ntop_height_m = 1001\niop = [{ "
                 "wavelength_nm = 532, a_per_m = 0, b_per_m = 1e-5 }]"),
       {"scene.toml:8:10: a slab of 2 m about 1000 m is thicker than its layer from 1000 to 1001 m "
        "(write at most 1)"}},
      {"SlabLostInTheRounding",
       lit_scene(sun, irradiance + "depth_m = [10]\nslab_m = 1e-6"),
       {"scene.toml:8:10: a slab of 1e-06 m about 10 m holds nothing: it is lost in the rounding "
        "(write at least 0.0001)"}},
      {"EscapeNotWhole",
       lit_scene(sun, escape + "zenith_deg = [10, 5, 80]"),
       {"scene.toml:7:15: the angles begin at 10 degrees, not at 0 (the bins of light that escapes "
        "go from 0 to 90 degrees)",
        "scene.toml:7:19: 5 does not come after 10 (list them in ascending order, each once)",
        "scene.toml:7:22: the angles end at 80 degrees, not at 90 (the bins of light that escapes "
        "go from 0 to 90 degrees)"}},
      {"EscapeBeyondTheHorizon",
       lit_scene(sun, escape + "zenith_deg = [0, 100]"),
       {"scene.toml:7:14: 'zenith_deg' must be a list, each element a finite number, at least 0 "
        "and at most 90, not 100 (90 is along the horizon)"}},
      {"EdgesNotAscending",
       lit_scene(lamp, fluence + "depth_m = [2, 1]\nradius_m = [0, 0]\n"),
       {"scene.toml:9:15: 1 does not come after 2 (list them in ascending order, each once)",
        "scene.toml:10:16: 0 does not come after 0 (list them in ascending order, each once)"}},
      {"XNotAscending",
       lit_scene(lamp, fluence + "depth_m = [1, 2]\nx_m = [0, -1]\n"),
       {"scene.toml:10:11: -1 does not come after 0 (list them in ascending order, each once)"}},
      {"OneEdge",
       lit_scene(lamp, fluence + "depth_m = [2]\nradius_m = [-1, 0]\n"),
       {"scene.toml:9:11: 'depth_m' must be a list of two or more numbers, not [2] (write [a, b, "
        "…])",
        "scene.toml:10:12: 'radius_m' must be a list, each element a finite number, at least 0, "
        "not -1"}},
      {"DepthsAndHeights",
       lit_scene(lamp, fluence + "depth_m = [1, 2]\nheight_m = [1, 2]\nradius_m = [0, 1]"),
       {"scene.toml:10:1: 'depth_m' and 'height_m' exclude each other in [[tally]] (keep one of "
        "them)"}},
      {"RingsAndX",
       lit_scene(lamp, fluence + cells + "x_m = [1, 2]"),
       {"scene.toml:11:1: 'radius_m' and 'x_m' exclude each other in [[tally]] (keep one of "
        "them)"}},
      {"FluenceWithoutEdges",
       lit_scene(lamp, fluence),
       {"scene.toml:7:1: [[tally]] needs 'depth_m' or 'height_m'",
        "scene.toml:7:1: [[tally]] needs 'radius_m' or 'x_m'"}},
      {"DirectionsBeyondStraightDown",
       lit_scene(sun, radiance + "depth_m = [1]\ndirection_deg = [[0, 0], [90, 0], [180.5, 0]]"),
       {"scene.toml:8:26: horizontal light crosses no level: its radiance is not known (take "
        "another zenith angle than 90 degrees)",
        "scene.toml:8:35: a zenith angle of 180.5 degrees is not from 0 to 180 (0 is light that "
        "travels straight up, 180 straight down)"}},
      {"OneDirection",
       lit_scene(sun, radiance + "depth_m = [1]\ndirection_deg = [30, 40]"),
       {"scene.toml:8:17: 'direction_deg' must be a list of pairs of angles, not of 30 (write "
        "[[zenith, azimuth], …], as [[0, 0]] for straight up)"}},
      {"NoDirection",
       lit_scene(sun, radiance + "depth_m = [1]\ndirection_deg = 30"),
       {"scene.toml:8:17: 'direction_deg' must be a list of directions, not 30 (write [[zenith, "
        "azimuth], …], as [[0, 0]] for straight up)"}},
      {"KeysOfAnotherKind",
       lit_scene(sun, escape + "depth_m = [1]\nname = \"a\""),
       {"scene.toml:7:11: 'depth_m' does not belong to kind = \"boundaries\" (it belongs to "
        "\"irradiance\", \"fluence\" and \"radiance\")",
        "scene.toml:8:8: 'name' does not belong to kind = \"boundaries\" (it belongs to "
        "\"fluence\")"}},
      {"KindMissing",
       lit_scene(sun, "[[tally]]\ndepth_m = [1]"),
       {"scene.toml:5:1: 'kind' is missing in [[tally]] (add it: the quantity)"}},
      {"KindUnknown",
       lit_scene(sun, "[[tally]]\nkind = \"absorption\"\ndepth_m = 1"),
       {"scene.toml:6:8: 'kind' must be \"irradiance\", \"boundaries\", \"fluence\" or "
        "\"radiance\", not text \"absorption\" (choose from: irradiance, boundaries, fluence, "
        "radiance)"}},
  };
}

std::vector<WrongTally> wrong_together() {
  const std::string up = radiance + "depth_m = [1]\ndirection_deg = [[0, 0]]";
  const std::string rough =
      std::string(water) + "\n[sea]\nsurface = { model = \"cox-munk\", wind_speed_m_s = 5";
  const std::string both = std::string(telescope) + '\n' + balance;
  const std::string other = "\n[[environment]]\nset = { \"sea.layer.0.chlorophyll_mg_m3\" = 1 }";
  return {
      {"RadianceOfALamp",
       lit_scene(lamp, up),
       {"scene.toml:8:8: of a source with a place a radiance would be an integral over the "
        "horizontal plane (take a beam without position_m, or kind = \"irradiance\")"}},
      {"RadianceOfARoughSea",
       lit_scene(sun, up, rough + " }"),
       {"scene.toml:6:8: radiances are known below and above a flat surface alone (write "
        "sea.surface = { model = \"flat\" }, or take kind = \"irradiance\")"}},
      {"FluenceOfTheSun",
       lit_scene(sun, fluence + cells),
       {"scene.toml:6:8: a beam as wide as the world has no fluence about a place (give the beam a "
        "position_m, or take kind = \"irradiance\")"}},
      {"TwoOfAKind",
       lit_scene(sun, std::string(balance) + '\n' + balance),
       {"scene.toml:8:8: two of [[tally]] are of the kind \"boundaries\" (make one of both: only "
        "fluences may be several)"}},
      {"FluencesWithoutNames",
       lit_scene(lamp, fluence + cells + fluence + cells),
       {"scene.toml:7:1: there are several fluences, and this one has no name (give each its own "
        "name)",
        "scene.toml:11:1: there are several fluences, and this one has no name (give each its own "
        "name)"}},
      {"FluencesOfOneName",
       lit_scene(lamp, fluence + "name = \"a\"\n" + cells + fluence + "name = \"a\"\n" + cells),
       {"scene.toml:14:8: two of [[tally]] are called \"a\" (give each its own name)"}},
      {"NameOfNoVariable",
       lit_scene(lamp, fluence + "name = \"a/b\"\n" + cells),
       {"scene.toml:9:8: \"a/b\" cannot be part of the name of a variable (take letters, digits, _ "
        "and -)"}},
      {"Bidirectional",
       lit_scene(laser, both, water, "photons = 1\nestimator = \"bidirectional\""),
       {"scene.toml:26:13: the bidirectional estimator has no tallies: it follows only light that "
        "comes to a telescope (write estimator = \"forward\", or leave [[tally]] out)"}},
      {"ForcedCollisions",
       lit_scene(sun, balance, water, "photons = 1\ntools = { forced_collisions = 1 }"),
       {"scene.toml:12:31: photons that are forced to stay do not cross the levels on their way "
        "out (write forced_collisions = 0, or leave [[tally]] out)"}},
      {"DirectedFraction",
       lit_scene(laser, both, water, "photons = 1\ndirected_fraction = 0.5"),
       {"scene.toml:26:21: directions drawn towards a telescope make tallies noisy (write "
        "directed_fraction = 0, or leave [[tally]] out)"}},
      {"ConservingFacetsWithATelescope",
       lit_scene(laser, both, rough + ", facets = \"conserving\" }"),
       {"scene.toml:25:62: telescopes see waves with facets = \"reciprocal\" alone (write that, "
        "leave facets out, or leave the telescopes out)"}},
      {"FacetsOfAnEnvironment",
       lit_scene(laser, telescope, rough + " }",
                 "photons = 1\n[[environment]]\nset = { \"sea.surface.facets\" = \"conserving\" }"),
       {"scene.toml:27:9: 'facets' must be as in the scene, which has none, not text "
        "\"conserving\": it weighs the light, whose histories are the same in all environments "
        "(simulate that in a scene of its own)"}},
      {"FacetsOfAFlatSea",
       lit_scene(sun, balance,
                 std::string(water) + "\n[sea]\nsurface = { facets = \"conserving\" }"),
       {"scene.toml:11:22: 'facets' does not belong to model = \"flat\" (it belongs to "
        "\"cox-munk\", \"gaussian\" and \"paper\")"}},
      {"EnvironmentsWithoutEchoes",
       lit_scene(sun, balance, water, "photons = 1" + other),
       {"scene.toml:12:1: [[environment]] has only echoes, and there is no telescope (add a "
        "[[telescope]], or leave [[environment]] out)"}},
      {"SensitivityWithoutEchoes",
       "sensitivity = [\"sea.layer.0.chlorophyll_mg_m3\"]\n" + lit_scene(sun),
       {"scene.toml:1:15: sensitivity has only echoes, and there is no telescope (add a "
        "[[telescope]], or leave sensitivity out)"}},
      {"NeitherTelescopeNorTally",
       lit_scene(laser, "[gates]\ndepth_max_m = 1\ndepth_step_m = 1"),
       {"scene.toml:14:1: the scene needs 'telescope' or 'tally' (add a [[telescope]] for echoes, "
        "a [[tally]] for irradiances, balances and other quantities, or both)"}},
      {"TelescopeAlone",
       lit_scene(laser,
                 "[[telescope]]\nposition_m = [0, 0, 12]\ndirection = [0, 0, -1]\ndiameter_m = "
                 "0.4\nfocal_length_m = 2\ndetector_diameter_m = 0.04"),
       {"scene.toml:17:1: [[channel]] is missing (add it: the light that one detector counts; any "
        "number of them)",
        "scene.toml:17:1: [gates] is missing (add it: the range gates)"}},
      {"ChannelAndGatesAlone",
       lit_scene(laser, std::string(balance) +
                            "\n[[channel]]\nname = \"e\"\nprocess = \"elastic\"\n[gates]\n"
                            "depth_max_m = 1\ndepth_step_m = 1"),
       {"scene.toml:9:1: 'channel' belongs to [[telescope]], of which there is none (add one, or "
        "leave 'channel' out)",
        "scene.toml:12:1: 'gates' belongs to [[telescope]], of which there is none (add one, or "
        "leave 'gates' out)"}},
      {"SeaBelowAirAlone",
       lit_scene(sun, balance,
                 std::string(air_alone) +
                     "\n[bottom]\nalbedo = 0.1\n[oil]\nclass = "
                     "\"light-refined\"\nthickness_um = 1\n" +
                     water),
       {"scene.toml:11:1: 'bottom' and 'atmosphere.surface' exclude each other: a ground takes the "
        "place of the sea (keep one of them)",
        "scene.toml:13:1: 'oil' and 'atmosphere.surface' exclude each other: a ground takes the "
        "place of the sea (keep one of them)",
        "scene.toml:16:1: 'sea' and 'atmosphere.surface' exclude each other: a ground takes the "
        "place of the sea (keep one of them)"}},
      {"NeitherSeaNorGround",
       lit_scene(sun, balance, ""),
       {"scene.toml:9:1: [sea] needs 'layer', 'column' or 'iop_table'"}},
      {"AlbedoOfTheGround",
       lit_scene(sun, balance,
                 "[atmosphere]\nprofile = \"us-standard\"\nsurface = { albedo = { zenith_deg = "
                 "[0, 80], albedo = [0.1, 0.2] } }"),
       {"scene.toml:9:41: the angles end at 80 degrees, not at 90 (give the albedo from 0 to 90 "
        "degrees)"}},
      {"TooManyCells",
       lit_scene(
           lamp, fluence + cells + "[[tally]]\nkind = \"irradiance\"\ndepth_m = [" +
                     [] {
                       std::string depths;
                       for (int i = 0; i < 200'000; ++i)
                         depths += (i ? ", " : "") + std::to_string(i) + "e-5";
                       return depths;
                     }() +
                     "]"),
       {"scene.toml:7:1: the tallies (telescopes 0, channels 0, gates 0, orders 6, cells of depth "
        "100, cells of [[tally]] 800001) would take 2.44 GiB; the limit is 2 GiB (take fewer "
        "levels, directions or edges)"}},
  };
}

// Seen red: with equal neighbours let through; with levels down to 1 m below the bed; with slabs up
// to twice as thick as their layer; with radiances at 90 degrees; with angles that end at 80.
TEST(Tallies, EveryTextOfLevelsAndEdges) {
  for (const WrongTally& c : wrong_levels()) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(diagnostics_of(c.text), c.expected);
  }
}

// Seen red: with two fluences that need no names; with a fluence of the sun; with a radiance of a
// rough sea; with other facets in an environment.
TEST(Tallies, EveryTextOfWhatGoesTogether) {
  for (const WrongTally& c : wrong_together()) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(diagnostics_of(c.text), c.expected);
  }
}

}  // namespace
}  // namespace photic::scene
