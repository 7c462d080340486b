// --set path=value: what it changes, and what is said when it cannot.
#include <gtest/gtest.h>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

struct SetCase {
  const char* name;
  std::vector<Override> overrides;
  std::vector<std::string> expected;
};

const std::vector<SetCase>& override_cases() {
  static const std::vector<SetCase> all{
      {"Number",
       {"source.wavelength_nm=-1"},
       {"--set source.wavelength_nm: 'wavelength_nm' must be a finite number, greater than 0, not "
        "-1"}},
      {"NoValue",
       {"source.wavelength_nm"},
       {"--set source.wavelength_nm: there is no value (write path=value)"}},
      {"EmptyName",
       {"source..wavelength_nm=1"},
       {"--set source..wavelength_nm: there is an empty name in the path (write names and numbers "
        "with dots between)"}},
      {"EmptyPath",
       {"=1"},
       {"--set : there is an empty name in the path (write names and numbers with dots between)"}},
      {"UnknownKey",
       {"sea.layer.0.chlorophyl_mg_m3=0.5"},
       {"--set sea.layer.0.chlorophyl_mg_m3: unknown key 'chlorophyl_mg_m3' in [[sea.layer]] (did "
        "you mean 'chlorophyll_mg_m3'?)"}},
      {"UnknownTable",
       {"see.layer.0.x=1"},
       {"--set see.layer.0.x: unknown key 'see' in the scene (did you mean 'sea'?)"}},
      {"NoSuchElement",
       {"sea.layer.7.chlorophyll_mg_m3=1"},
       {"--set sea.layer.7.chlorophyll_mg_m3: there is no element 7 in 'layer' (it has 2, counted "
        "from 0)"}},
      {"HugeElement",
       {"sea.layer.99999999999999999999.chlorophyll_mg_m3=1"},
       {"--set sea.layer.99999999999999999999.chlorophyll_mg_m3: there is no element "
        "99999999999999999999 in 'layer' (it has 2, counted from 0)"}},
      {"NoSuchName",
       {"telescope.tt.diameter_m=1"},
       {"--set telescope.tt.diameter_m: nothing in 'telescope' is called 'tt' (its names and "
        "numbers: t)"}},
      {"NoSuchNameFar",
       {"telescope.coaxial.diameter_m=1"},
       {"--set telescope.coaxial.diameter_m: nothing in 'telescope' is called 'coaxial' (its names "
        "and numbers: t)"}},
      {"IntoANumber",
       {"source.wavelength_nm.x=1"},
       {"--set source.wavelength_nm.x: 'wavelength_nm' is 532: there is no 'x' in it"}},
      {"IntoText",
       {"title.x=1"},
       {R"(--set title.x: 'title' is text "Base": there is no 'x' in it)"}},
      {"TextThatIsNoChoice",
       {"simulation.estimator=forwards"},
       {R"(--set simulation.estimator: 'estimator' must be "auto", "bidirectional", "forward" or "analog", not text "forwards" (did you mean 'forward'?))"}},
      {"TextForNumber",
       {"simulation.photons=lots"},
       {R"(--set simulation.photons: 'photons' must be a whole number, at least 1 and below 2^63, not text "lots")"}},
      {"ElementOfVector",
       {"source.position_m.2=high"},
       {R"(--set source.position_m.2: 'position_m' must be three finite numbers [x, y, z], not [0, 0, text "high"])"}},
      {"Exclusive",
       {"telescope.0.half_field_of_view_mrad=10"},
       {"--set telescope.0.half_field_of_view_mrad: 'detector_diameter_m' and "
        "'half_field_of_view_mrad' exclude each other in [[telescope]] (keep one of them)"}},
      {"WholeTable",
       {R"(source={ kind = "laser" })"},
       {"--set source: 'wavelength_nm' is missing in [source] (add it: the wavelength of its light "
        "in nm)",
        "--set source: 'position_m' is missing in [source] (add it: the centre of a disc, else the "
        "place of the source [x, y, z] in m; z is up, the sea level is 0)",
        "--set source: 'direction' is missing in [source] (add it: the direction of the light, or "
        "the axis of its "
        "cone [x, y, z]; "
        "need not be normalised)",
        "--set source: 'diameter_m' is missing in [source] (add it: the diameter of the "
        "disc in m)",
        "--set source: 'half_divergence_mrad' is missing in [source] (add it: the angle between "
        "the axis and the edge of the beam in mrad)"}},
      {"CheckAcrossKeys",
       {"gates.depth_min_m=-20"},
       {"--set gates.depth_min_m: the gates begin at the depth -20 m, above the source or the "
        "first telescope (begin at -12 m or deeper)"}},
      {"SeaBed",
       {"sea.layer.1.bottom_depth_m=10"},
       {"--set sea.layer.1.bottom_depth_m: the layer ends at 10 m, not below the one above it, "
        "which ends at 20 m (layers go from the surface down)"}},
      {"LineBreakSmugglesNoKey",
       {R"(simulation.photons=5
seed=2)"},
       {R"(--set simulation.photons: 'photons' must be a whole number, at least 1 and below 2^63, not text "5\u000Aseed=2")"}},
      {"NotUtf8", {"title=\xFF"}, {"--set title: the value is not UTF-8 text"}},
      {"AfterTheFile",
       {"source.wavelength_nm=-1", "simulation.photons=0"},
       {"--set source.wavelength_nm: 'wavelength_nm' must be a finite number, greater than 0, not "
        "-1",
        "--set simulation.photons: 'photons' must be a whole number, at least 1 and below 2^63, "
        "not 0"}},
  };
  return all;
}

// Seen red: --set sorted before the file, values with line breaks read as several keys, the place
// of a vector kept when one of its numbers is replaced.
TEST(Override, EveryTextOfWhatIsWrong) {
  for (const SetCase& c : override_cases()) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(diagnostics_of(edited({}), c.overrides), c.expected);
  }
}

TEST(Override, ValuesAreTomlOrElseText) {
  EXPECT_EQ(base_scene({"simulation.photons=1e7"}).simulation.photons, 10'000'000U);
  EXPECT_EQ(base_scene({"simulation.estimator=forward"}).simulation.estimator, Estimator::forward);
  EXPECT_EQ(base_scene({"title=Ship = sea"}).title, "Ship = sea");
  EXPECT_EQ(base_scene({"title='532'"}).title, "532");
  EXPECT_EQ(base_scene({"title="}).title, "");
  EXPECT_EQ(base_scene({R"(title=C:\ship "one")"}).title, R"(C:\ship "one")");
}

TEST(Override, FindsElementsByNumberAndByName) {
  EXPECT_EQ(base_scene({"sea.layer.0.chlorophyll_mg_m3=0.5"}).sea.layer[0].chlorophyll_mg_m3, 0.5);
  EXPECT_EQ(base_scene({"telescope.t.diameter_m=0.8"}).telescope[0].diameter_m, 0.8);
  EXPECT_EQ(base_scene({"source.position_m.2=20"}).source.position_m.z, 20.0);
  const std::vector<Override> renamed{"sea.layer.0.name=top", "sea.layer.top.bottom_depth_m=3"};
  EXPECT_EQ(base_scene(renamed).sea.layer[0].bottom_depth_m, 3.0);
}

TEST(Override, CreatesMissingKeysAndTables) {
  EXPECT_EQ(base_scene({"simulation.seed=7"}).simulation.seed, 7U);
  EXPECT_EQ(base_scene({"sea.surface.model=flat"}).sea.surface.model, SurfaceModel::flat);
  const auto gates = base_scene({"gates={ start_ns = 90, stop_ns = 200, step_ns = 2 }"}).gates;
  EXPECT_FALSE(gates.depth_m);
  EXPECT_EQ(gates.time_ns->max, 200.0);
}

TEST(Override, TheLastOneHolds) {
  EXPECT_EQ(base_scene({"simulation.seed=7", "simulation.seed=8"}).simulation.seed, 8U);
}

}  // namespace
}  // namespace photic::scene
