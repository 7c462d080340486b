// The sources of light: what is read, what is written, and all that is wrong with line and column.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/scene/base_scene.hpp"
#include "unit/scene/lit_scene.hpp"

namespace photic::scene {
namespace {

Source source_of(const std::string& source) { return read_text(lit_scene(source)).source; }

// Seen red: with the light travelling to where the sun stands.
TEST(Sources, TheSunComesFromWhereItStands) {
  const Source sun_at = source_of("kind = \"beam\"\nzenith_deg = 30\nazimuth_deg = 90");
  EXPECT_EQ(sun_at.kind, SourceKind::beam);
  EXPECT_TRUE(sun_at.is_everywhere);
  EXPECT_FALSE(sun_at.is_pulsed());
  EXPECT_EQ(sun_at.position_m, (Vec3<double>{0, 0, 0}));
  EXPECT_NEAR(sun_at.direction.x, 0, 1e-15);
  EXPECT_NEAR(sun_at.direction.y, -0.5, 1e-15);
  EXPECT_NEAR(sun_at.direction.z, -std::sqrt(0.75), 1e-15);
  const Source by_direction = source_of("kind = \"beam\"\ndirection = [0, 1, -2]");
  EXPECT_EQ(by_direction.direction, (Vec3<double>{0, 1, -2}));
  EXPECT_FALSE(by_direction.zenith_deg.has_value());
}

TEST(Sources, ABeamWithAPlaceIsADiscOrAPencil) {
  const Source pencil = source_of("kind = \"beam\"\nzenith_deg = 0\nposition_m = [1, 2, 3]");
  EXPECT_FALSE(pencil.is_everywhere);
  EXPECT_EQ(pencil.position_m, (Vec3<double>{1, 2, 3}));
  EXPECT_EQ(pencil.diameter_m, 0);
  const Source disc = source_of(
      "kind = \"beam\"\nzenith_deg = 0\nposition_m = [1, 2, 3]\ndiameter_m = 2\npower_w = 5");
  EXPECT_EQ(disc.diameter_m, 2);
  EXPECT_EQ(disc.power_w, 5);
}

TEST(Sources, LampsAreInTheWaterOrTheAir) {
  EXPECT_EQ(source_of(lamp).half_angle_deg, 180);
  const char* up_in_clear_air = "kind = \"point\"\nposition_m = [0, 0, 1e6]\ndirection = [0, 0, 1]";
  EXPECT_EQ(source_of(up_in_clear_air).kind, SourceKind::point);
}

// Seen red: with the radius of parallel light for that of a cone; with twice for three times.
TEST(Sources, OfAGaussianHoldAllLightWithinThreeTimesItsWidth) {
  for (const double mrad : {0.0, 5.0, 523.0}) {
    const std::string place =
        "position_m = [0, 0, 12]\ndirection = [0, 0, -1]\ndiameter_m = 0.04\n"
        "half_divergence_mrad = " +
        std::to_string(mrad);
    const Source disc = source_of(place);
    EXPECT_EQ(disc.half_divergence_of_all(), mrad * 1e-3);
    EXPECT_EQ(disc.radius_of_all(), 0.02);
    const Source gaussian = source_of(place + "\nprofile = \"gaussian\"");
    EXPECT_EQ(gaussian.half_divergence(), mrad * 1e-3);
    EXPECT_EQ(gaussian.half_divergence_of_all(), 3 * mrad * 1e-3);
    const double spread = mrad > 0 ? std::tan(3e-3 * mrad) / std::tan(1e-3 * mrad) : 3;
    EXPECT_NEAR(gaussian.radius_of_all(), 0.02 * spread, 1e-12 * spread);
  }
}

// Seen red: with the position of a sun written; with an angle and a direction written.
TEST(Sources, AreWrittenAsTheyWereRead) {
  for (const std::string source :
       {"kind = \"beam\"\nzenith_deg = 0.1\nazimuth_deg = -1\nirradiance_w_m2 = 0.3",
        "kind = \"beam\"\ndirection = [0, 0, -1]\nposition_m = [0, 0, 1]\ndiameter_m = 0.1\n"
        "power_w = 0.7",
        "kind = \"point\"\nposition_m = [0, 0, -1]\ndirection = [1, 0, 0]\npower_w = 0.7",
        "kind = \"cone\"\nposition_m = [0, 0, -1]\ndirection = [1, 0, 0]\nhalf_angle_deg = 0.3\n"
        "power_w = 1e9",
        "position_m = [0, 0, 12]\ndirection = [0, 0, -1]\ndiameter_m = 0.04\n"
        "half_divergence_mrad = 5\nprofile = \"gaussian\"\nenergy_j = 0.1",
        "position_m = [0, 0, 12]\ndirection = [0, 0, -1]\ndiameter_m = 0.04\n"
        "half_divergence_mrad = 5\nphotons_per_pulse = 1e18"}) {
    SCOPED_TRACE(source);
    const Scene scene = read_text(lit_scene(source));
    const std::string text = write_scene(scene);
    EXPECT_TRUE(read_text(text) == scene) << text;
    EXPECT_EQ(write_scene(read_text(text)), text);
    EXPECT_EQ(text.find("[gates]"), std::string::npos);
  }
}

// Seen red: with its position.
TEST(Sources, ASunIsWrittenByItsAngle) {
  const std::string text = write_scene(read_text(lit_scene(sun)));
  EXPECT_TRUE(text.starts_with(
      "title = \"\"\n\n[source]\nkind = \"beam\"\nwavelength_nm = 532.0\nzenith_deg = 30.0\n"
      "azimuth_deg = 0.0\n\n[[tally]]\nkind = \"boundaries\"\nzenith_deg = [0.0, 10.0, "))
      << text;
}

struct WrongSource {
  const char* name;
  std::string text;
  Texts expected;
};

std::vector<WrongSource> wrong_sources() {
  const std::string air = "[atmosphere]\nprofile = \"us-standard\"\ntop_km = 50\n";
  return {
      {"BelowTheHorizon",
       lit_scene("kind = \"beam\"\nzenith_deg = 90"),
       {"scene.toml:4:14: 'zenith_deg' must be a finite number, at least 0 and less than 90, not "
        "90 (a sun at 90 degrees or more is below the horizon)"}},
      {"BeamGoesUp",
       lit_scene("kind = \"beam\"\ndirection = [1, 0, 0]"),
       {"scene.toml:4:13: the light of a beam comes from above and must point down (make the third "
        "number negative)"}},
      {"AngleAndDirection",
       lit_scene("kind = \"beam\"\nzenith_deg = 30\ndirection = [0, 0, -1]"),
       {"scene.toml:5:1: 'zenith_deg' and 'direction' exclude each other in [source] (keep one of "
        "them)"}},
      {"NoDirection",
       lit_scene("kind = \"beam\""),
       {"scene.toml:1:1: [source] needs 'direction' or 'zenith_deg'"}},
      {"DiameterWithoutAPlace",
       lit_scene("kind = \"beam\"\nzenith_deg = 3\ndiameter_m = 1"),
       {"scene.toml:1:1: 'position_m' is missing in [source] (add it: the centre of a disc, else "
        "the place of the source [x, y, z] in m; z is up, the sea level is 0)"}},
      {"BeamInTheWater",
       lit_scene("kind = \"beam\"\nzenith_deg = 3\nposition_m = [0, 0, 0]"),
       {"scene.toml:5:14: the beam begins at 0 m and not above the sea (raise it, or take kind = "
        "\"point\", which may be in the water)"}},
      {"BeamInTheAir",
       lit_scene("kind = \"beam\"\nzenith_deg = 3\nposition_m = [0, 0, 4e4]", balance, air + water),
       {"scene.toml:5:14: the beam begins at 40000 m, below the top of the air at 50000 m (raise "
        "it, or take kind = \"point\", which may be in the air)"}},
      {"OnTheSurface",
       lit_scene("kind = \"point\"\nposition_m = [0, 0, 0]\ndirection = [0, 0, 1]"),
       {"scene.toml:4:14: the source lies on the sea surface (put it into the air (z > 0) or into "
        "the water (z < 0))"}},
      {"BelowTheBed",
       lit_scene("kind = \"point\"\nposition_m = [0, 0, -30]\ndirection = [0, 0, 1]"),
       {"scene.toml:4:14: the source is 30 m deep and the sea bed 20 m (raise it, or lower the "
        "last layer's bottom_depth_m)"}},
      {"AboveTheAir",
       lit_scene("kind = \"point\"\nposition_m = [0, 0, 6e4]\ndirection = [0, 0, 1]", balance,
                 air + water),
       {"scene.toml:4:14: the source is at 60000 m, above the top of the air at 50000 m (lower it, "
        "or take kind = \"beam\", which comes from outside)"}},
      {"InTheGround",
       lit_scene("kind = \"point\"\nposition_m = [0, 0, -1]\ndirection = [0, 0, 1]", balance,
                 air_alone),
       {"scene.toml:4:14: the source is not above the ground at 0 m (put it into the air (z > "
        "0))"}},
      {"WiderThanAllSides",
       lit_scene("kind = \"cone\"\nposition_m = [0, 0, -5]\ndirection = [0, 0, 1]\n"
                 "half_angle_deg = 181"),
       {"scene.toml:6:18: 'half_angle_deg' must be a finite number, greater than 0 and at most "
        "180, not 181 (180 is light to all sides)"}},
      {"TwoStrengths",
       lit_scene(std::string(laser) + "\nenergy_j = 1\nphotons_per_pulse = 1e18"),
       {"scene.toml:8:1: 'energy_j' and 'photons_per_pulse' exclude each other in [source] (keep "
        "one of them)"}},
      {"StrengthOfAnotherKind",
       lit_scene(std::string(lamp) + "\nenergy_j = 1"),
       {"scene.toml:7:12: 'energy_j' does not belong to kind = \"cone\" (it belongs to "
        "\"laser\")"}},
      {"PowerOfALaser",
       lit_scene(std::string(laser) + "\npower_w = 1"),
       {"scene.toml:7:11: 'power_w' does not belong to kind = \"laser\" (it belongs to \"beam\", "
        "\"point\" and \"cone\")"}},
      {"ProfileOfALamp",
       lit_scene(std::string(lamp) + "\nprofile = \"gaussian\""),
       {"scene.toml:7:11: 'profile' does not belong to kind = \"cone\" (it belongs to "
        "\"laser\")"}},
      {"WingsToTheSide",
       lit_scene("position_m = [0, 0, 12]\ndirection = [0, 0, -1]\ndiameter_m = 0.04\n"
                 "half_divergence_mrad = 524\nprofile = \"gaussian\""),
       {"scene.toml:6:24: the wings of a Gaussian beam go out to 3 times its half divergence, and "
        "1572 mrad is a quarter turn or more (take at most 523 mrad, or profile = \"disc\")"}},
      {"IrradianceOfADisc",
       lit_scene("kind = \"beam\"\nzenith_deg = 3\nposition_m = [0, 0, 4]\nirradiance_w_m2 = 1"),
       {"scene.toml:6:1: 'position_m' and 'irradiance_w_m2' exclude each other in [source] (keep "
        "one of them)"}},
      {"PowerOfTheSun",
       lit_scene(std::string(sun) + "\npower_w = 1"),
       {"scene.toml:1:1: 'position_m' is missing in [source] (add it: the centre of a disc, else "
        "the place of the source [x, y, z] in m; z is up, the sea level is 0)"}},
      {"KindUnknown",
       lit_scene("kind = \"lamp\"\nposition_m = [0, 0, -5]"),
       {"scene.toml:3:8: 'kind' must be \"laser\", \"beam\", \"point\" or \"cone\", not text "
        "\"lamp\" (choose from: laser, beam, point, cone)"}},
      {"TelescopeWithABeam",
       lit_scene(sun, telescope),
       {"scene.toml:5:1: telescopes see light by its time, and a beam has no pulses (take "
        "source.kind = \"laser\", or a [[tally]] in place of telescopes)"}},
      {"BentLight",
       lit_scene(sun, balance, air + "refraction = true\n" + water),
       {"scene.toml:10:14: in plane air bent light is known along the axes of lasers and "
        "telescopes "
        "alone (leave it out, write geometry = \"spherical\", or take source.kind = \"laser\")"}},
      {"Bidirectional",
       lit_scene(lamp, telescope, water, "photons = 1\nestimator = \"bidirectional\""),
       {"scene.toml:7:1: telescopes see light by its time, and a cone has no pulses (take "
        "source.kind = \"laser\", or a [[tally]] in place of telescopes)",
        "scene.toml:24:13: the bidirectional estimator is for lasers alone (write estimator = "
        "\"forward\")"}},
  };
}

// Seen red: with discs let through that begin in the air; with telescopes let through beside a
// beam.
TEST(Sources, EveryTextWithLineAndColumn) {
  for (const WrongSource& c : wrong_sources()) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(diagnostics_of(c.text), c.expected);
  }
}

}  // namespace
}  // namespace photic::scene
