// The albedo of the sea bed where light has it: its data must reach all light, and environments
// must not reflect what the scene absorbs.
#include <fmt/format.h>

#include "medium/sources.hpp"
#include "unit/medium/checked_scenes.hpp"

namespace photic::medium {
namespace {

/// Clear water of 20 m, light in lines, and a bed whose albedo begins at 25:10.
std::vector<scene::Edit> over_bed(const std::string& albedo, const std::string& more = "") {
  return {{18, 18, "[optics]\nemission = \"lines\""},
          {22, 25, "chlorophyll_mg_m3 = 0\n[bottom]\nalbedo = " + albedo + more}};
}

std::vector<scene::Edit> with_raman(std::vector<scene::Edit> edits) {
  edits.insert(edits.begin(), {16, 17, raman_channel});
  return edits;
}

/// In lines 26 and 27; the change begins at 27:9.
std::string other_bed(const std::string& albedo) {
  return "\n[[environment]]\nset = { \"bottom.albedo\" = " + albedo + " }";
}

constexpr const char* to_600 = "{ wavelength_nm = [500, 600], albedo = [0.1, 0.2] }";
constexpr const char* from_600 = "{ wavelength_nm = [600, 700], albedo = [0.1, 0.2] }";

// Seen red, each for itself: with the laser's light not looked at; with the channels' not; with
// one light reported alone.
TEST(BedOfAScene, MustBeKnownWhereLightIs) {
  EXPECT_EQ(problems(over_bed(to_600)), Texts{});
  EXPECT_EQ(problems(with_raman(over_bed("{ zenith_deg = [0, 90], albedo = [0.1, 0.2] }"))),
            Texts{});
  EXPECT_EQ(problems(over_bed(from_600)),
            Texts{"scene.toml:25:10: the sea bed's albedo covers 600 to 700 nm, not 532 nm; the "
                  "source emits there (add rows for it)"});
  EXPECT_EQ(problems(with_raman(over_bed(to_600))),
            Texts{"scene.toml:25:10: the sea bed's albedo covers 500 to 600 nm, not 648.793 nm; "
                  "channel \"r\" counts raman light there (add rows for it)"});
  EXPECT_EQ(
      problems(with_raman(over_bed("{ wavelength_nm = [400, 500], albedo = [0, 0] }"))).size(), 2U);
  EXPECT_EQ(problems(over_bed("0.1", other_bed(from_600))),
            Texts{"scene.toml:27:9: the sea bed's albedo covers 600 to 700 nm, not 532 nm; the "
                  "source emits there (add rows for it)"});
}

// Seen red, each for itself: with a scene without a bed not looked at; with the laser's light
// alone; with angles not looked at; with all reported at `set`.
TEST(BedOfAScene, MustReflectWhatAnEnvironmentReflects) {
  const auto reported = [](double nm, double deg) {
    return fmt::format(
        "in environment \"environment0\": the sea bed reflects light of {} nm and a zenith angle "
        "of "
        "{} degrees, but not in the scene itself (no history of the scene goes that way: give its "
        "bed a little albedo, too)",
        nm, deg);
  };
  EXPECT_EQ(problems(over_bed("0.1", other_bed("0"))), Texts{});
  EXPECT_EQ(problems(over_bed("0", other_bed("0"))), Texts{});
  EXPECT_EQ(problems(over_bed("0", other_bed("0.1"))),
            Texts{"scene.toml:27:9: " + reported(532, 0)});
  EXPECT_EQ(problems({{22, 25, "chlorophyll_mg_m3 = 0" + other_bed("0.1")}}),
            Texts{"scene.toml:24:9: " + reported(532, 0)});
  const auto dark_above_600 =
      over_bed("{ wavelength_nm = [500, 600, 700], albedo = [0.1, 0, 0] }", other_bed("0.1"));
  EXPECT_EQ(problems(dark_above_600), Texts{});
  EXPECT_EQ(problems(with_raman(dark_above_600)),
            Texts{"scene.toml:27:9: " + reported(648.793, 0)});
  EXPECT_EQ(problems(over_bed("{ zenith_deg = [0, 60, 90], albedo = [0.1, 0, 0] }",
                              other_bed("{ zenith_deg = [0, 90], albedo = [0, 0.1] }"))),
            Texts{"scene.toml:27:9: " + reported(532, 90)});
  EXPECT_EQ(problems(over_bed("0", "\n[environment_grid]\n\"bottom.albedo\" = [0, 0.1]")).size(),
            1U);
  EXPECT_EQ(problems(over_bed("0", "\n[[environment]]\nset = {}"),
                     {"environment.0.set.bottom.albedo=0.1"}),
            Texts{"--set environment.0.set.bottom.albedo: " + reported(532, 0)});
}

// Seen red: without it.
TEST(BedOfAScene, IsASourceOfTheMedium) {
  const auto reported = [](const std::string& albedo) {
    for (const Source& source : medium_of(scene::read_text(edited(over_bed(albedo)))).sources)
      if (source.quantity == "albedo of the sea bed") return source_line(source);
    return std::string("nothing");
  };
  EXPECT_EQ(reported("0.1"), "albedo of the sea bed, 532 nm: 0.1, given");
  EXPECT_EQ(reported(to_600), "albedo of the sea bed, 532 nm: 0.1 to 0.2, given");
}

}  // namespace
}  // namespace photic::medium
