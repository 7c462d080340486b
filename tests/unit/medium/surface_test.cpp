// The sea surface of a scene as a medium's waves: slopes, wind, whitecaps, and their sources.
#include "medium/surface.hpp"

#include <numbers>

#include "unit/medium/scenes.hpp"

namespace photic::medium {
namespace {

scene::Surface cox_munk_sea(double wind_speed_m_s) {
  scene::Surface surface;
  surface.model = scene::SurfaceModel::cox_munk;
  surface.wind_speed_m_s = wind_speed_m_s;
  return surface;
}

scene::Surface paper_sea(double wind_speed_m_s) {
  scene::Surface surface;
  surface.model = scene::SurfaceModel::paper;
  surface.wind_speed_m_s = wind_speed_m_s;
  return surface;
}

scene::Surface gaussian_sea(double upwind, double crosswind) {
  scene::Surface surface;
  surface.model = scene::SurfaceModel::gaussian;
  surface.upwind_slope_variance = upwind;
  surface.crosswind_slope_variance = crosswind;
  return surface;
}

Medium medium_under(const scene::Surface& surface) {
  scene::Scene scene = scene_of({iop_layer()}, all_channels);
  scene.sea.surface = surface;
  return medium_of(scene);
}

// Seen red: with the variances of the two directions exchanged.
TEST(SlopesOfAScene, AreThoseOfItsModel) {
  const auto sea = slopes_of(cox_munk_sea(5));
  EXPECT_NEAR(sea.upwind_variance, 0.0158, 1e-15);
  EXPECT_NEAR(sea.crosswind_variance, 0.0126, 1e-15);
  EXPECT_NEAR(sea.series.c03, -0.125, 1e-15);
  scene::Surface changed = cox_munk_sea(5);
  changed.slick = true;
  changed.gram_charlier = false;
  const auto slick = slopes_of(changed);
  EXPECT_NEAR(slick.upwind_variance, 0.0089, 1e-15);
  EXPECT_NEAR(slick.crosswind_variance, 0.0072, 1e-15);
  EXPECT_EQ(slick.series.c03, 0);
  EXPECT_EQ(slick.norm, 1);
  const auto of_paper = slopes_of(paper_sea(5));
  EXPECT_NEAR(of_paper.upwind_variance, 0.086, 1e-15);
  EXPECT_EQ(of_paper.crosswind_variance, 0);
  const auto own = slopes_of(gaussian_sea(0.02, 0.01));
  EXPECT_EQ(own.upwind_variance, 0.02);
  EXPECT_EQ(own.crosswind_variance, 0.01);
  EXPECT_EQ(own.series.c40, 0);
}

// Cox & Munk's line for the slopes across the wind does not go to 0 with the wind, the paper's not
// either. Seen red: with the law asked at any wind.
TEST(SlopesOfAScene, AreNoneWithoutWind) {
  EXPECT_TRUE(slopes_of({}).is_flat());
  EXPECT_TRUE(slopes_of(cox_munk_sea(0)).is_flat());
  EXPECT_TRUE(slopes_of(paper_sea(0)).is_flat());
  EXPECT_TRUE(slopes_of(gaussian_sea(0, 0)).is_flat());
}

TEST(WhitecapsOfAScene, CoverWhatTheLawSaysOrTheScene) {
  scene::Surface surface = cox_munk_sea(10);
  EXPECT_NEAR(whitecap_fraction_of(surface).value, 9.768e-3, 1e-6);
  EXPECT_NE(whitecap_fraction_of(surface).source.find("Monahan"), std::string::npos);
  surface.whitecap_law = scene::WhitecapLaw::stramska2003;
  EXPECT_NEAR(whitecap_fraction_of(surface).value, 4.325e-3, 1e-6);
  EXPECT_NE(whitecap_fraction_of(surface).source.find("Stramska"), std::string::npos);
  surface.whitecap_fraction = 0.25;
  EXPECT_EQ(whitecap_fraction_of(surface).value, 0.25);
  EXPECT_EQ(whitecap_fraction_of(surface).source, "the scene");
}

// Seen red: with whitecaps on slicks.
TEST(WhitecapsOfAScene, AreThereByDefaultWithCoxMunkAlone) {
  const auto fraction = [](const scene::Surface& s) { return whitecap_fraction_of(s).value; };
  EXPECT_EQ(fraction({}), 0);
  EXPECT_EQ(fraction(cox_munk_sea(0)), 0);
  EXPECT_EQ(fraction(paper_sea(10)), 0);
  EXPECT_EQ(fraction(gaussian_sea(0.02, 0.01)), 0);
  scene::Surface slick = cox_munk_sea(10);
  slick.slick = true;
  EXPECT_EQ(fraction(slick), 0);
  slick.whitecaps = true;
  EXPECT_GT(fraction(slick), 0);
  scene::Surface none = cox_munk_sea(10);
  none.whitecaps = false;
  EXPECT_EQ(fraction(none), 0);
  scene::Surface of_paper = paper_sea(10);
  of_paper.whitecaps = true;
  EXPECT_NEAR(fraction(of_paper), 9.768e-3, 1e-6);
  scene::Surface own = gaussian_sea(0.02, 0.01);
  own.whitecap_fraction = 0.1;
  EXPECT_EQ(fraction(own), 0.1);
  own.upwind_slope_variance = own.crosswind_slope_variance = 0;
  EXPECT_EQ(fraction(own), 0);
}

// Seen red: with sine and cosine exchanged; with the direction that the wind blows to.
TEST(WavesView, KnowsWhereTheWindComesFrom) {
  const auto upwind = [](double deg) {
    scene::Surface surface = cox_munk_sea(5);
    surface.wind_direction_deg = deg;
    return medium_under(surface).view().waves;
  };
  EXPECT_EQ(upwind(0).upwind_x, 1);
  EXPECT_EQ(upwind(0).upwind_y, 0);
  EXPECT_NEAR(upwind(90).upwind_x, 0, 1e-15);
  EXPECT_NEAR(upwind(90).upwind_y, 1, 1e-15);
  EXPECT_NEAR(upwind(-150).upwind_x, -std::numbers::sqrt3 / 2, 1e-15);
  EXPECT_NEAR(upwind(-150).upwind_y, -0.5, 1e-15);
}

TEST(WavesView, HasTheSlopesAndWhitecapsOfTheScene) {
  const Medium sea = medium_under(cox_munk_sea(10));
  const WavesView waves = sea.view().waves;
  EXPECT_FALSE(sea.view().surface.one_direction_each);
  EXPECT_TRUE(sea.view().surface.leads_anywhere);
  EXPECT_FALSE(sea.view().surface.isotropic);
  EXPECT_FALSE(waves.one_dimensional);
  EXPECT_NEAR(waves.upwind_deviation * waves.upwind_deviation, 0.0316, 1e-15);
  EXPECT_NEAR(waves.crosswind_deviation * waves.crosswind_deviation, 0.0222, 1e-15);
  EXPECT_NEAR(waves.series.c21, -0.076, 1e-15);
  EXPECT_NEAR(waves.series.c03, -0.29, 1e-15);
  EXPECT_EQ(waves.series.c40, 0.40);
  EXPECT_EQ(waves.series.c22, 0.12);
  EXPECT_EQ(waves.series.c04, 0.23);
  EXPECT_NEAR(waves.per_norm, 1 / (1 + 8.4e-6), 1e-6);
  EXPECT_NEAR(waves.whitecap_fraction, 9.768e-3, 1e-6);
  ASSERT_EQ(waves.whitecap_reflectance.size, sea.view().lines);
  for (std::int32_t line = 0; line < sea.view().lines; ++line)
    EXPECT_NEAR(gather<double>(waves.whitecap_reflectance, line), 0.22, 1e-12);
  EXPECT_TRUE(medium_under(paper_sea(5)).view().waves.one_dimensional);
  EXPECT_FALSE(medium_under(paper_sea(5)).view().surface.leads_anywhere);
  EXPECT_FALSE(medium_under(paper_sea(5)).view().surface.one_direction_each);
  EXPECT_TRUE(medium_under(gaussian_sea(0, 0.1)).view().waves.one_dimensional);
}

// Seen red: with the laser's wavelength for all lines.
TEST(WavesView, HasAReflectanceOfWhitecapsForEachLine) {
  scene::Surface surface = cox_munk_sea(10);
  surface.whitecap_reflectance = scene::WhitecapReflectance::frouin1996;
  const Medium sea = medium_under(surface);
  const auto& table = sea.view().waves.whitecap_reflectance;
  ASSERT_EQ(sea.line.size(), 3U);
  EXPECT_NEAR(gather<double>(table, 0), 0.22, 1e-12);
  EXPECT_LT(gather<double>(table, 1), 0.22 * 0.92);  // Raman light, 650 nm
  EXPECT_NEAR(gather<double>(table, 2), 0.22 * (0.889225 + 15 / 95.0 * (0.760046 - 0.889225)),
              1e-9);  // chlorophyll's, 685 nm
}

TEST(WavesView, IsThatOfAFlatSeaWithoutWind) {
  for (const auto& surface :
       {scene::Surface{}, cox_munk_sea(0), paper_sea(0), gaussian_sea(0, 0)}) {
    const Medium sea = medium_under(surface);
    EXPECT_TRUE(sea.view().surface.one_direction_each);
    EXPECT_TRUE(sea.view().surface.isotropic);
    EXPECT_EQ(sea.view().waves.whitecap_fraction, 0);
  }
}

// Seen red: without the fraction's.
TEST(WavesOfAScene, AreSourcesOfTheMedium) {
  const auto listed = [](const scene::Surface& surface, const std::string& quantity) {
    std::string lines;
    for (const Source& source : medium_under(surface).sources)
      if (source.quantity == quantity) lines += source_line(source) + "\n";
    return lines;
  };
  const std::string slopes = "slopes of the sea surface", fraction = "fraction of whitecaps",
                    reflectance = "reflectance of whitecaps";
  EXPECT_EQ(listed(cox_munk_sea(10), slopes),
            "slopes of the sea surface: Cox & Munk 1954, J. Opt. Soc. Am. 44, 838, clean sea, with "
            "the Gram-Charlier series of the clean sea\n");
  EXPECT_EQ(listed(cox_munk_sea(10), fraction),
            "fraction of whitecaps: Monahan & O'Muircheartaigh 1980, J. Phys. Oceanogr. 10, 2094 "
            "[uncertain by a factor of two]\n");
  EXPECT_EQ(listed(cox_munk_sea(10), reflectance),
            "reflectance of whitecaps, 532-685 nm: " + library().whitecaps_koepke.source + "\n");
  scene::Surface frouin = cox_munk_sea(10);
  frouin.whitecap_reflectance = scene::WhitecapReflectance::frouin1996;
  EXPECT_EQ(listed(frouin, reflectance),
            "reflectance of whitecaps, 532-685 nm: " + library().whitecaps_koepke.source + "; " +
                library().whitecaps_frouin.source + "\n");
  scene::Surface own = gaussian_sea(0.02, 0.01);
  EXPECT_EQ(listed(own, slopes),
            "slopes of the sea surface: a Gaussian of the scene's own variances\n");
  EXPECT_EQ(listed(own, fraction) + listed(own, reflectance), "");
  own.whitecap_fraction = 0.1;
  EXPECT_EQ(listed(own, fraction), "fraction of whitecaps: the scene\n");
  for (const auto& quantity : {slopes, fraction, reflectance})
    EXPECT_EQ(listed({}, quantity) + listed(cox_munk_sea(0), quantity), "");
}

TEST(WhitecapsOfAScene, AreRefusedWhereTheirReflectanceIsNotKnown) {
  scene::Scene scene = scene_of({iop_layer()}, {test::channel_of(Process::elastic)});
  scene.sea.surface = cox_munk_sea(5);
  scene.sea.surface.whitecap_reflectance = scene::WhitecapReflectance::frouin1996;
  scene.sea.layer[0].iop.insert(scene.sea.layer[0].iop.begin(), {350, 0.1, 0.1, 0.01});
  scene.source.wavelength_nm = 355;
  EXPECT_EQ(refusal(scene),
            "no whitecap reflectance data at 355 nm: " + library().whitecaps_frouin.source +
                " cover 412-865 nm (write whitecap_reflectance = \"koepke1984\", or whitecaps = "
                "false)");
  scene.sea.surface.whitecaps = false;
  EXPECT_EQ(refusal(scene), "nothing was refused");
  scene.sea.surface.whitecaps = true;
  scene.sea.surface.whitecap_reflectance = scene::WhitecapReflectance::koepke1984;
  EXPECT_EQ(refusal(scene), "nothing was refused");
}

scene::Scene over(const scene::Surface& surface, const scene::Surface& other) {
  scene::Scene scene = scene_of({iop_layer()}, all_channels);
  scene.sea.surface = surface;
  scene.environment.push_back({"other", {}, scene.optics, scene.sea});
  scene.environment.front().sea.surface = other;
  return scene;
}
scene::Surface gaussian_cox_munk(double wind_speed_m_s, double whitecaps) {
  auto surface = cox_munk_sea(wind_speed_m_s);
  surface.gram_charlier = false;
  surface.whitecap_fraction = whitecaps;
  return surface;
}

// What no history of the scene meets, or hardly any.
TEST(SurfaceOfAnEnvironment, MayNotBeSteeper) {
  const auto expect_refused = [](const scene::Surface& here, const scene::Surface& there,
                                 const std::string& why) {
    const std::string all = refusal(over(here, there));
    EXPECT_NE(all.find("environment \"other\": " + why), std::string::npos) << all;
  };
  const auto wind = [](double speed) { return gaussian_cox_munk(speed, 0.01); };
  expect_refused(wind(5), wind(6), "its waves are steeper than the scene's");
  expect_refused(wind(5), wind(0), "a flat surface sends light only one way");
  expect_refused(paper_sea(5), paper_sea(6), "its waves are steeper than the scene's");
  expect_refused(cox_munk_sea(15), cox_munk_sea(14), "in the scene's wind Cox & Munk's series");
  expect_refused(gaussian_cox_munk(5, 0), wind(5), "there are whitecaps, but none in the scene");
  expect_refused(gaussian_cox_munk(5, 1), wind(5), "whitecaps leave some of the surface free");
  for (const auto& good :
       {over(wind(5), wind(4)), over(cox_munk_sea(10), cox_munk_sea(3)),
        over(wind(5), gaussian_cox_munk(5, 0.9)), over(paper_sea(5), paper_sea(4)),
        over(gaussian_sea(0, 0.02), gaussian_sea(0, 0.01))})
    EXPECT_TRUE(medium_of(good).view().surface.differs_in_environments);
  EXPECT_FALSE(medium_of(over(wind(5), wind(5))).view().surface.differs_in_environments);
}

// Seen red: without the check (the first pair was taken, with ratios that are no numbers).
TEST(SurfaceOfAnEnvironment, HasSlopesInTheDirectionsOfTheScene) {
  const auto both = gaussian_sea(0.02, 0.01), along = gaussian_sea(0.02, 0),
             across = gaussian_sea(0, 0.02);
  for (const auto& scene : {over(both, along), over(along, both), over(both, across),
                            over(across, both), over(along, gaussian_sea(0, 0.01))}) {
    const std::string all = refusal(scene);
    EXPECT_NE(all.find("environment \"other\": along or across the wind its facets or the scene's, "
                       "but not both, are all level"),
              std::string::npos)
        << all;
  }
}

}  // namespace
}  // namespace photic::medium
