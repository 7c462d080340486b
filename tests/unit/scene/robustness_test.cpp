// Damaged scenes: whatever the bytes, the reader gives a scene or says what is wrong with it.
#include <gtest/gtest.h>

#include <random>

#include "core/error.hpp"
#include "unit/scene/base_scene.hpp"
#include "unit/scene/lit_scene.hpp"
#include "unit/scene/row_scene.hpp"

namespace photic::scene {
namespace {

enum class Outcome { scene, refused };

/// Anything but a scene or an InputError with at least one diagnostic fails the test.
Outcome outcome_of(const std::string& text, const std::vector<Override>& overrides = {}) {
  try {
    const Scene scene = read_scene_text(text, "ship.toml", "/", overrides).scene;
    EXPECT_EQ(scene.gates.count() > 0, !scene.telescope.empty());
    EXPECT_TRUE(read_scene_text(write_scene(scene), "written.toml", "/").scene == scene);
    return Outcome::scene;
  } catch (const InputError& error) {
    EXPECT_FALSE(error.diagnostics().empty());
    for (const Diagnostic& d : error.diagnostics()) {
      EXPECT_TRUE(d.line > 0 || d.file.rfind("--set ", 0) == 0) << d.text();
      EXPECT_FALSE(d.reason.empty());
    }
    return Outcome::refused;
  }
}

TEST(Robustness, TruncatedAtEveryByte) {
  const std::string ship = starter_scene("ship");
  std::size_t refused = 0;
  for (std::size_t size = 0; size < ship.size(); ++size)
    if (outcome_of(ship.substr(0, size)) == Outcome::refused) ++refused;
  EXPECT_GT(refused, ship.size() / 2);
}

TEST(Robustness, OneByteChanged) {
  const std::string ship = starter_scene("ship");
  std::mt19937_64 random(20240601);
  std::size_t refused = 0;
  constexpr std::size_t tries = 3000;
  for (std::size_t i = 0; i < tries; ++i) {
    std::string damaged = ship;
    damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
    if (outcome_of(damaged) == Outcome::refused) ++refused;
  }
  EXPECT_GT(refused, tries / 10);
  EXPECT_LT(refused, tries);
}

TEST(Robustness, LinesMixedUp) {
  const auto& lines = base_lines();
  std::mt19937_64 random(7);
  for (int i = 0; i < 1000; ++i) {
    std::string mixed;
    for (int line = 0; line < 30; ++line) mixed += lines[random() % lines.size()] + '\n';
    outcome_of(mixed);
  }
}

const std::vector<std::string>& any_values() {
  static const std::vector<std::string> values{
      "1",
      "-1",
      "0.0",
      "1e308",
      "nan",
      "-inf",
      "true",
      "\"\"",
      "[]",
      "[[]]",
      "[1, 2, 3]",
      "{}",
      "[{}]",
      "{ model = 1 }",
      "{ model = 'paper', wind_speed_m_s = 5 }",
      "1979-05-27",
      "\xFF\xFE",
      "",
      "9223372036854775807",
      "{ depth_m = [0, 20], value = [1, 2] }",
      "{ model = 'gaussian', background = 0, maximum = 1e300, "
      "depth_m = 5, width_m = 1e-300 }"};
  return values;
}

TEST(Robustness, AnyValueForAnyKey) {
  const std::vector<std::string> paths{"title",
                                       "source",
                                       "source.kind",
                                       "source.wavelength_nm",
                                       "source.position_m",
                                       "source.position_m.1",
                                       "source.direction",
                                       "source.half_divergence_mrad",
                                       "source.profile",
                                       "telescope",
                                       "telescope.0",
                                       "telescope.0.name",
                                       "telescope.0.focal_length_m",
                                       "telescope.0.detector_shift_m",
                                       "telescope.0.focus_m",
                                       "channel",
                                       "channel.0.process",
                                       "optics",
                                       "optics.set",
                                       "sea",
                                       "sea.surface",
                                       "sea.surface.model",
                                       "sea.surface.wind_speed_m_s",
                                       "sea.surface.whitecaps",
                                       "sea.layer",
                                       "sea.layer.0",
                                       "sea.layer.0.bottom_depth_m",
                                       "sea.layer.0.chlorophyll_mg_m3",
                                       "sea.layer.0.cdom_a440_per_m.value",
                                       "sea.layer.1.cdom_a440_per_m",
                                       "sea.iop_table",
                                       "sea.iop_table.file",
                                       "sea.profile_tolerance",
                                       "sea.layer.1.iop",
                                       "sea.layer.1.iop.0",
                                       "sea.layer.1.phase_function",
                                       "sea.layer.1.phase_function.model",
                                       "gates",
                                       "gates.depth_min_m",
                                       "gates.depth_max_m",
                                       "gates.depth_step_m",
                                       "simulation",
                                       "simulation.photons",
                                       "simulation.orders_kept",
                                       "simulation.seed",
                                       "bottom",
                                       "atmosphere",
                                       "atmosphere.profile",
                                       "atmosphere.aerosol",
                                       "atmosphere.layer",
                                       "atmosphere.layer.0.iop",
                                       "",
                                       ".",
                                       "0",
                                       "source.0.x",
                                       "environment",
                                       "environment.0",
                                       "environment.0.name",
                                       "environment.0.set",
                                       "environment.0.set.set",
                                       "environment.1.set.sea.layer"};
  const std::string environment =
      "[[environment]]\nset = { \"sea.layer.0.chlorophyll_mg_m3\" = 0.5 }\n";
  const std::string surface = R"(surface = { model = "cox-munk", wind_speed_m_s = 5 })";
  const std::string base = edited({{19, 19, "[sea]\n" + surface}}) + environment;
  for (const std::string& path : paths) {
    for (const std::string& value : any_values()) {
      outcome_of(base, {path + "=" + value});
      outcome_of(base, {"environment.0.set." + path + "=" + value});
    }
  }
}

TEST(Robustness, AnyValueForAnyKeyOfColumns) {
  const std::string base =
      row_text({{33, 33, "minerals_g_m3 = { depth_m = [0, 5], value = [1, 2] }"}}) +
      "[[environment]]\nset = { 'sea.column.0.layer.0.chlorophyll_mg_m3' = 0.2 }\n";
  for (const std::string path : {"sea.layer",
                                 "sea.iop_table",
                                 "sea.column",
                                 "sea.column.0",
                                 "sea.column.1",
                                 "sea.column.plume.name",
                                 "sea.column.0.x_min_m",
                                 "sea.column.0.x_max_m",
                                 "sea.column.1.x_min_m",
                                 "sea.column.1.oil",
                                 "sea.column.1.bottom",
                                 "sea.column.1.bottom.albedo",
                                 "sea.column.1.layer",
                                 "sea.column.1.layer.0",
                                 "sea.column.1.layer.0.bottom_depth_m",
                                 "sea.column.1.layer.0.minerals_g_m3",
                                 "sea.column.1.layer.1.iop",
                                 "sea.y_min_m",
                                 "sea.y_max_m",
                                 "bottom",
                                 "oil",
                                 "sensitivity"}) {
    for (const std::string& value : any_values()) {
      outcome_of(base, {path + "=" + value});
      outcome_of(base, {"environment.0.set." + path + "=" + value});
    }
  }
}

TEST(Robustness, AnyValueForAnyKeyOfTalliesAndOtherSources) {
  const std::string tallies =
      "[[tally]]\nkind = \"irradiance\"\ndepth_m = [1]\n[[tally]]\nkind = \"fluence\"\ndepth_m = "
      "[0, 1]\nradius_m = [0, 1]\n" +
      std::string(balance);
  for (const std::string path : {"source.kind",
                                 "source.position_m",
                                 "source.direction",
                                 "source.zenith_deg",
                                 "source.diameter_m",
                                 "source.half_angle_deg",
                                 "source.power_w",
                                 "source.irradiance_w_m2",
                                 "telescope",
                                 "channel",
                                 "gates",
                                 "tally",
                                 "tally.0",
                                 "tally.0.kind",
                                 "tally.0.depth_m",
                                 "tally.0.depth_m.0",
                                 "tally.0.height_m",
                                 "tally.0.slab_m",
                                 "tally.1.name",
                                 "tally.1.radius_m",
                                 "tally.1.x_m",
                                 "tally.2.zenith_deg",
                                 "tally.0.direction_deg",
                                 "sea",
                                 "sea.surface.facets",
                                 "sea.layer",
                                 "atmosphere",
                                 "atmosphere.surface",
                                 "atmosphere.surface.albedo",
                                 "simulation.directed_fraction"})
    for (const std::string& value : any_values())
      for (const char* source : {sun, lamp})
        for (const char* world : {water, air_alone})
          outcome_of(lit_scene(source, tallies, world), {path + "=" + value});
}

TEST(Robustness, DeepNestingIsRefused) {
  EXPECT_EQ(outcome_of("x = " + std::string(100000, '[')), Outcome::refused);
  std::string mixture = "{ model = \"petzold\" }";
  for (int i = 0; i < 300; ++i) mixture = "{ model = \"mixture\", components = [" + mixture + "] }";
  EXPECT_EQ(outcome_of(edited({{25, 25, "phase_function = " + mixture}})), Outcome::refused);
}

std::string repeated(const std::string& part, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += part;
  return out;
}

/// The first problem of the ship with lines added.
std::string problem_with(const std::string& lines) {
  try {
    static_cast<void>(read_scene_text(starter_scene("ship") + '\n' + lines, "s", "/"));
  } catch (const InputError& error) {
    return error.diagnostics().front().reason;
  }
  return "";
}

// Seen red: with strings and comments looked at; with a header's parts forgotten at its second
// bracket; without the parts of keys around an inline table.
TEST(Robustness, TablesThatLieTooDeepInEachOther) {
  const std::string deep = "more than 256 tables lie in each other here";
  for (const std::string& lines :
       {repeated("a.", 256) + "b = 1", "[" + repeated("a.", 256) + "b]",
        "[[" + repeated("a.", 199) + "b]]\n" + repeated("c.", 56) + "x = 1",
        "x = " + repeated("{ a.b.c = ", 90) + "1" + repeated(" }", 90),
        "x = [\n1, { " + repeated("a . ", 256) + "b = 1 }]"})
    EXPECT_EQ(problem_with(lines), deep) << lines;
  for (const std::string& lines :
       {repeated("a.", 200) + "b = 1", "x = \"" + repeated(".", 300) + "\"",
        "x = \"\"\"\n" + repeated(".", 300) + "\"\"\"", "x = '" + repeated(".", 300) + "'",
        "# " + repeated(".", 300), "'" + repeated("a.", 300) + "' = 1",
        "x = [" + repeated("1.5, ", 300) + "1.5]", repeated("[a.b]\n[c.d]\n", 100)})
    EXPECT_NE(problem_with(lines), deep) << lines;
}

}  // namespace
}  // namespace photic::scene
