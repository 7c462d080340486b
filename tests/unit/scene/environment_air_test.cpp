// The air of environments and derivatives.
#include <gtest/gtest.h>

#include "unit/scene/air_scene.hpp"

namespace photic::scene {
namespace {

// Seen red: with the scene's air for that of the environment.
TEST(Atmosphere, OfEnvironmentsIsTheScenesWithItsChanges) {
  const Scene scene = base_scene(
      {us_standard,
       {"environment=[{ set = { \"atmosphere.visibility_km\" = 5, \"atmosphere.aerosol\" = "
        "\"maritime\" } }, { set = { \"sea.layer.0.chlorophyll_mg_m3\" = 0.2 } }]"},
       {"sensitivity=['atmosphere.visibility_km']"}});
  Atmosphere hazy = *scene.atmosphere;
  hazy.visibility_km = 5;
  hazy.aerosol = "maritime";
  EXPECT_EQ(scene_in(scene, scene.environment[0]).atmosphere, hazy);
  EXPECT_EQ(scene_in(scene, scene.environment[1]).atmosphere, scene.atmosphere);
  EXPECT_EQ(scene.sensitivity[0].value, 23);
  EXPECT_EQ(scene.sensitivity[0].above.atmosphere->visibility_km, 23.023);
}

// One of them in an environment takes the place of the other in the scene, whether that was given
// or filled in. Seen red: without take_out_replaced(), in OtherWater and in hold().
TEST(Atmosphere, OfEnvironmentsMayHaveAnOpticalDepthOrAVisibility) {
  const std::string depth = "aerosol_optical_depth_550";
  const auto scene_with = [&](const std::string& in_scene, const std::string& in_environment) {
    return base_scene({{"atmosphere={ profile = \"us-standard\"" + in_scene + " }"},
                       {"environment=[{ set = { \"atmosphere." + in_environment + " } }]"}});
  };
  for (const std::string& in_scene :
       {std::string(), std::string(", visibility_km = 40"), ", " + depth + " = 0.2"}) {
    for (const std::string& change : {depth + "\" = 0.4", std::string("visibility_km\" = 9"),
                                      std::string("aerosol\" = \"none\"")}) {
      SCOPED_TRACE(in_scene + "; " + change);
      const Scene scene = scene_with(in_scene, change);
      const Atmosphere air = *scene_in(scene, scene.environment[0]).atmosphere;
      EXPECT_EQ(air.aerosol_optical_depth_550.value_or(0), change.starts_with(depth) ? 0.4 : 0);
      EXPECT_EQ(air.visibility_km.value_or(0), change.starts_with("visibility") ? 9 : 0);
      EXPECT_EQ(read_text(write_scene(scene)), scene);
    }
  }
  const Scene derived = base_scene({us_standard,
                                    {"atmosphere." + depth + "=0.2"},
                                    {"sensitivity=['atmosphere." + depth + "']"}});
  EXPECT_EQ(derived.sensitivity[0].value, 0.2);
  EXPECT_EQ(derived.sensitivity[0].below.atmosphere->aerosol_optical_depth_550, 0.1998);
}

/// With two layers of air and one environment that sets this.
Texts with_environment(const Override& air, const std::string& set) {
  return diagnostics_of(edited({}), {air, {"environment=[{ set = { " + set + " } }]"}});
}

// Seen red, each for itself: with air that the scene lacks passed over; with keys left out of what
// is the same in all.
TEST(Atmosphere, EveryTextOfWhatEnvironmentsMustNotChange) {
  const Override layers{
      "atmosphere={ layer = [{ bottom_height_m = 0, top_height_m = 100, iop = [{ wavelength_nm = "
      "532, a_per_m = 0, b_per_m = 1e-4 }, { wavelength_nm = 700, a_per_m = 0, b_per_m = 1e-4 }] "
      "}] "
      "}"};
  const std::string bends =
      "it bends and times the light, whose histories are the same in all environments";
  const std::string borders =
      "light crosses from layer to layer in the same way in all environments";
  const std::string own = " (simulate that in a scene of its own)";
  const auto must = [&](const std::string& key, const std::string& scene, const std::string& here,
                        const std::string& why) {
    return Texts{"--set environment: '" + key + "' must be as in the scene, " + scene + ", not " +
                 here + ": " + why + own};
  };
  EXPECT_EQ(with_environment(us_standard, "\"atmosphere.profile\" = \"tropical\""),
            must("profile", "text \"us-standard\"", "text \"tropical\"", bends));
  EXPECT_EQ(with_environment(us_standard, "\"atmosphere.top_km\" = 50"),
            must("top_km", "100", "50", borders));
  EXPECT_EQ(with_environment(layers, "\"atmosphere.layer.0.top_height_m\" = 50"),
            must("top_height_m", "100", "50", borders));
  EXPECT_EQ(with_environment(layers, "\"atmosphere.layer.0.refractive_index\" = 1.1"),
            must("refractive_index", "1", "1.1", bends));
  EXPECT_EQ(with_environment({"title=x"}, "\"atmosphere.profile\" = \"us-standard\""),
            Texts{"--set environment: the scene itself has no air above the sea (give it an "
                  "[atmosphere], of little aerosol if need be)"});
  EXPECT_EQ(with_environment(us_standard, "\"atmosphere.visibility_km\" = 1e9"),
            Texts{"--set environment: 'visibility_km' must be a finite number, at least 0.2 and at "
                  "most 300, not 1000000000"});
  EXPECT_EQ(with_environment(us_standard,
                             "\"atmosphere.aerosol_optical_depth_550\" = 0.2, "
                             "\"atmosphere.visibility_km\" = 23"),
            Texts{"--set environment: it takes the place of visibility_km, which is also given "
                  "(leave one of them out)"});
}

}  // namespace
}  // namespace photic::scene
