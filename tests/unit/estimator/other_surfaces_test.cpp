// Paths that meet the surface in environments with other waves and whitecaps: their ratios are
// those of what the surfaces send on.
#include "estimator/variations/other_surfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "unit/medium/scenes.hpp"

namespace photic::estimator {
namespace {

scene::Scene under(double wind_speed_m_s, double whitecaps) {
  scene::Scene scene = medium::scene_of({medium::iop_layer()}, medium::all_channels);
  auto& surface = scene.sea.surface;
  surface.model = scene::SurfaceModel::cox_munk;
  surface.wind_speed_m_s = wind_speed_m_s;
  surface.wind_direction_deg = 30;
  surface.whitecap_fraction = whitecaps;
  return scene;
}
Vec3<double> direction(double u, double v, double sign, double flattest) {
  const double z = flattest + (1 - flattest) * u, s = std::sqrt(1 - z * z);
  return {s * std::cos(2 * pi * v), s * std::sin(2 * pi * v), sign * z};
}

// Seen red: with Smith's factors, the norms of the series, or the fraction that whitecaps leave
// free the other way up.
TEST(OtherSurfaces, HaveTheRatioOfWhatSurfacesSendOn) {
  scene::Scene all = under(9, 0.1);
  const scene::Scene other = under(5, 0.03);
  all.environment.push_back({"other", {}, other.optics, other.sea});
  const medium::Medium here = medium::medium_of(all), there = medium::medium_of(other);
  const medium::MediumView sea = here.view(), other_sea = there.view();
  const auto surface = surface::rough_surface<double>(sea, 0);
  const auto other_surface = surface::rough_surface<double>(other_sea, 0);
  OtherSurfaces<double> met;
  double least = 10, most = 0;
  for (std::uint64_t n = 0; n < 1000; ++n) {
    const auto u = uniforms<double>(RandomKey{3}, n, 0, 0);
    const Vec3<double> in = direction(u[0], u[1], -1, 0.3), out = direction(u[2], u[3], -1, 0.8);
    const double value = surface.density(true, false, in, out);
    auto meeting = surface::meeting_of(surface, true, false, in, out);
    met.meet(sea, meeting);
    const double ratio = other_surface.density(true, false, in, out) / value;
    EXPECT_NEAR(1 + met.sum(sea, 0, 0), ratio, 1e-9 * (1 + ratio));
    least = std::min(least, ratio), most = std::max(most, ratio);

    meeting.by_whitecaps = 0;
    const auto facets = [&](const auto& of) {
      return of.facets(true, false, in, out).per_density *
             surface::slope_density(of.waves, meeting.slope);
    };
    meeting.between = direction(u[3], u[2], 1, 0.02);
    met.meet(sea, meeting);
    if (!(facets(surface) > 0)) continue;
    const double between = (1 + surface::smith(sea.waves, meeting.between)) /
                           (1 + surface::smith(other_sea.waves, meeting.between));
    const double of_facets = between * facets(other_surface) / facets(surface);
    EXPECT_NEAR(1 + met.sum(sea, 0, 0), of_facets, 1e-9 * (1 + of_facets));
  }
  EXPECT_LT(least, 0.5);
  EXPECT_GT(most, 1.5);
}

// Of waves of one direction facets that light meets by chance have the ratio of the densities of
// one slope, and those that light meets between two others Smith's besides.
// Seen red: with the ratio of densities of two slopes (the square of their widths' ratio).
TEST(OtherSurfaces, OfOneDimensionHaveTheRatioOfDensitiesOfOneSlope) {
  const auto paper = [](double wind_speed_m_s) {
    scene::Scene scene = under(wind_speed_m_s, 0.1);
    scene.sea.surface.model = scene::SurfaceModel::paper;
    return scene;
  };
  scene::Scene all = paper(9);
  const scene::Scene other = paper(5);
  all.environment.push_back({"other", {}, other.optics, other.sea});
  const medium::Medium here = medium::medium_of(all), there = medium::medium_of(other);
  const medium::MediumView sea = here.view(), other_sea = there.view();
  OtherSurfaces<double> met;
  for (std::uint64_t n = 0; n < 1000; ++n) {
    const auto u = uniforms<double>(RandomKey{4}, n, 0, 0);
    surface::FacetHit<double> hit;
    hit.slope = surface::sample_slope(sea.waves, u[0], u[1]);
    const auto density = [&](const medium::MediumView& of) {
      return surface::gaussian_along(of.waves.upwind_deviation, hit.slope.upwind);
    };
    EXPECT_EQ(hit.slope.crosswind, 0);
    met.meet(sea, hit);
    const double ratio = density(other_sea) / density(sea);
    EXPECT_NEAR(1 + met.sum(sea, 0, 0), ratio, 1e-9 * (1 + ratio));
    hit.between = direction(u[3], u[2], 1, 0.02);
    met.meet(sea, hit);
    const double smith = (1 + surface::smith(sea.waves, hit.between)) /
                         (1 + surface::smith(other_sea.waves, hit.between));
    EXPECT_NEAR(1 + met.sum(sea, 0, 0), smith * ratio, 1e-9 * (1 + smith * ratio));
  }
}

}  // namespace
}  // namespace photic::estimator
