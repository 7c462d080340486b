#include "optics/film.hpp"

#include <array>
#include <random>

#include "optics/refractive_index.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

/// Through a film from the air into water of index n.
FilmShares<double> into_water(const Film<double>& film, double n, double cos_air) {
  return film_shares(film, 1.0, n, cos_air, refract(1.0, n, cos_air).cos_transmitted);
}

struct Passed {
  double deg, film, bare;
};

// Seen red: with reflection to and fro left out; with the two faces' means over polarisations.
TEST(Film, LetsPassWhatItsFacesDoAndReflectsTheRest) {
  const double n = 1.3415;
  for (const auto& [deg, film, bare] : {Passed{0, 0.960306, 0.978729},
                                        {30, 0.958808, 0.977637},
                                        {60, 0.911822, 0.938715},
                                        {75, 0.749187, 0.784981},
                                        {85, 0.389183, 0.414293}}) {
    const Film<double> clear{1.48, 0};
    const double c = cosine_of(deg);
    const auto [cos_water, reflectance] = refract(1.0, n, c);
    const auto down = into_water(clear, n, c);
    const auto up = film_shares(clear, n, 1.0, cos_water, c);
    EXPECT_NEAR(down.transmittance, film, 5e-7) << deg;
    EXPECT_NEAR(up.transmittance, down.transmittance, 1e-15) << deg;
    EXPECT_NEAR(down.transmittance + down.reflectance, 1, 1e-15) << deg;
    EXPECT_NEAR(1 - reflectance, bare, 5e-7) << deg;
    EXPECT_NEAR(into_water({n, 0}, n, c).transmittance, 1 - reflectance, 1e-15) << deg;
  }
}

TEST(Film, AbsorbsAlongTheSlantAndPassesAlikeFromBothSides) {
  const double n = 1.34;
  for (const double deg : {0.0, 40.0, 80.0}) {
    const Film<double> film{1.49, 0.7};
    const double c = cosine_of(deg), cos_water = refract(1.0, n, c).cos_transmitted;
    const auto down = into_water(film, n, c);
    const auto up = film_shares(film, n, 1.0, cos_water, c);
    EXPECT_NEAR(up.transmittance, down.transmittance, 1e-15);
    EXPECT_LT(up.reflectance + up.transmittance, 1);
    EXPECT_LT(down.reflectance + down.transmittance, 1);
    const double slant = std::exp(-0.7 / cosine_in_film(1.49, 1.0, c));
    EXPECT_NEAR(down.transmittance / into_water({1.49, 0}, n, c).transmittance, slant,
                0.01 * slant);
  }
}

// What cannot leave water is reflected by the film's upper face, and goes through it twice.
TEST(Film, TakesFromTotalReflection) {
  const double n = 1.34, c = cosine_of(60);
  ASSERT_EQ(refract(n, 1.0, c).cos_transmitted, 0);
  const auto clear = film_shares(Film<double>{1.49, 0}, n, 1.0, c, 0.0);
  EXPECT_NEAR(clear.reflectance, 1, 1e-15);
  EXPECT_EQ(clear.transmittance, 0);
  const Film<double> film{1.49, 0.1};
  const double twice = std::exp(-0.2 / cosine_in_film(1.49, n, c));
  EXPECT_NEAR(film_shares(film, n, 1.0, c, 0.0).reflectance, twice, 2e-3);
}

// An oil that bends light less than water may reflect all of it at its lower face.
TEST(Film, ThinnerThanWaterReflectsAtItsLowerFace) {
  const auto shares = film_shares(Film<double>{1.2, 0.3}, 1.34, 1.0, cosine_of(70), 0.0);
  EXPECT_NEAR(shares.reflectance, 1, 1e-15);
  EXPECT_EQ(shares.transmittance, 0);
}

struct InterfaceRatio {
  double index, laser_nm, raman_nm, value;
};

/// What faces alone make of Raman light against bare water, straight up and down.
TEST(Film, HasTheInterfacesRatioOfRamanLight) {
  const auto over_bare = [](double index, double nm) {
    const double n = refractive_index(nm, 35, 20);
    return into_water({index, 0}, n, 1).transmittance / (1 - refract(1.0, n, 1.0).reflectance);
  };
  for (const auto& [index, laser_nm, raman_nm, value] : {InterfaceRatio{1.45, 337, 381, 0.97547},
                                                         {1.45, 355, 404, 0.97476},
                                                         {1.45, 532, 650, 0.97134},
                                                         {1.49, 337, 381, 0.96338},
                                                         {1.49, 355, 404, 0.96263},
                                                         {1.49, 532, 650, 0.95902}})
    EXPECT_NEAR(over_bare(index, laser_nm) * over_bare(index, raman_nm), value, 2e-5);
}

TEST(Film, MeanOfAnExponentialKeepsItsDigits) {
  for (const double x : {1e-9, 1e-4, 0.3, 0.999, 1.0, 1.001, 7.0, 60.0}) {
    const double exact = -std::expm1(-x) / x;
    EXPECT_NEAR(mean_of_exponential(x), exact, 2e-15 * exact);
    EXPECT_NEAR(mean_of_exponential(static_cast<float>(x)), exact, 3e-7 * exact);
  }
  EXPECT_EQ(mean_of_exponential(0.0), 1);
}

constexpr double a_laser = 5e4;  // weakly absorbing crude at 337 nm [1/m]

/// At 455 nm.
const double a_emitted = a_laser * std::exp(-0.015 * (455 - 337));

/// Of a film straight below a telescope of pi 0.04 m^2 in 12 m, photons per photon.
double echo(double thickness_m, double n_laser, double n_emitted) {
  const FilmOnWater<double> laser{{1.49, a_laser * thickness_m}, n_laser};
  const FilmOnWater<double> emitted{{1.49, a_emitted * thickness_m}, n_emitted};
  return 0.014 * film_emission(laser, true, 1.0, emitted, true, 1.0) * pi * 0.04 / 144;
}

// Where the film lies on what bends light alike, the lower face sends nothing back: what is
// published leaves that out. On water it adds half a per cent.
// Seen red: without the index squared; with the optical depths' sum in place of the exponential.
TEST(Film, ShinesAsTheClosedFormHasIt) {
  for (const auto& [thickness, photons, image] : {std::array{1e-7, 2.017e-9, 0.0056},
                                                  {1e-6, 1.965e-8, 0.0055},
                                                  {1e-5, 1.532e-7, 0.0043},
                                                  {1e-3, 3.458e-7, 0.0}}) {
    const double alone = echo(thickness, 1.49, 1.49);
    EXPECT_NEAR(alone, photons, 6e-4 * photons);
    const double a = a_laser * thickness, b = a_emitted * thickness;
    const double faces = std::pow(1 - std::pow(0.49 / 2.49, 2), 2);
    EXPECT_NEAR(alone,
                faces * 0.014 / (4 * pi * 1.49 * 1.49) * a / (a + b) * -std::expm1(-a - b) * pi *
                    0.04 / 144,
                1e-14 * photons);
    EXPECT_NEAR(echo(thickness, 1.345, 1.34) / alone - 1, image, 1.5e-4);
  }
}

/// The integral of what the film emits over a half of all directions.
double emitted_to(const FilmOnWater<double>& laser, bool from_above, double c,
                  const FilmOnWater<double>& emitted, bool up) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double cosine = (i + 0.5) / steps;
    sum += film_emission(laser, from_above, c, emitted, up, cosine) * 2 * pi / steps;
  }
  return sum;
}

TEST(Film, LetsOutWhatItsUpperFaceDoes) {
  // Little is absorbed of the laser's light, evenly, and none again.
  const FilmOnWater<double> laser{{1.49, 1e-6}, 1.49}, emitted{{1.49, 0}, 1.49};
  const double let_in = 1 - std::pow(0.49 / 2.49, 2);
  EXPECT_NEAR(emitted_to(laser, true, 1, emitted, true) / (1e-6 * let_in), 0.116825, 1e-6);
}

/// A photon in the film, step by step: how often it goes out above and below of so many that are
/// absorbed first.
struct Traced {
  double up = 0, down = 0;
};
Traced trace(const FilmOnWater<double>& laser, bool from_above, double c,
             const FilmOnWater<double>& emitted, int photons) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  Traced traced;
  for (int i = 0; i < photons; ++i) {
    bool s = uniform(generator) < 0.5, excites = true, sinks = from_above;
    const auto film = [&]() -> const FilmOnWater<double>& { return excites ? laser : emitted; };
    const double n1 = from_above ? 1 : laser.water;
    double cosine = cosine_in_film(laser.film.index, n1, c), depth = from_above ? 0 : 1;
    const auto r = fresnel_reflectances(n1, laser.film.index, c, cosine);
    if (uniform(generator) < (s ? r.s : r.p)) continue;
    for (;;) {
      const double way = sinks ? 1 - depth : depth, tau = film().film.optical_thickness;
      const double free = tau > 0 ? -std::log(uniform(generator)) * cosine / tau : 2;
      if (free < way) {
        if (!excites) break;
        depth += sinks ? free : -free;
        excites = false;
        cosine = 2 * uniform(generator) - 1;
        sinks = cosine < 0;
        cosine = std::abs(cosine);
        s = uniform(generator) < 0.5;
        continue;
      }
      depth = sinks ? 1 : 0;
      const double n2 = sinks ? film().water : 1, n = film().film.index;
      const auto back = fresnel_reflectances(n, n2, cosine, cosine_in_film(n2, n, cosine));
      if (uniform(generator) >= (s ? back.s : back.p)) {
        if (!excites) (sinks ? traced.down : traced.up) += 1.0 / photons;
        break;
      }
      sinks = !sinks;
    }
  }
  return traced;
}

// The closed form against photons that are followed from face to face, from above and from below,
// upwards and downwards. Bounds: six standard errors.
// Seen red: with the exponentials that fall against each other taken to fall alike.
TEST(Film, ShinesAsPhotonsFollowedThroughIt) {
  constexpr int photons = 400'000;
  for (const double thickness : {0.05, 0.8, 4.0})
    for (const bool from_above : {true, false}) {
      const FilmOnWater<double> laser{{1.49, thickness}, 1.345},
          emitted{{1.47, 0.4 * thickness}, 1.335};
      const double c = from_above ? 0.8 : 0.9;
      const auto traced = trace(laser, from_above, c, emitted, photons);
      const double up = emitted_to(laser, from_above, c, emitted, true),
                   down = emitted_to(laser, from_above, c, emitted, false);
      EXPECT_NEAR(traced.up, up, 6 * std::sqrt(up / photons)) << thickness << from_above;
      EXPECT_NEAR(traced.down, down, 6 * std::sqrt(down / photons)) << thickness << from_above;
    }
}

}  // namespace
}  // namespace photic::optics
