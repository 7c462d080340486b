#include "optics/spheres.hpp"

#include <fmt/format.h>

#include "optics/mie.hpp"
#include "optics/refractive_index.hpp"
#include "optics/sampled_spheres.hpp"
#include "optics/sea_particles.hpp"
#include "unit/optics/support.hpp"

namespace photic::optics {
namespace {

constexpr double um = 1e-6;

Spheres in_water(const SeaParticles& particles, double wavelength_nm = 532, double index = 1.34) {
  return spheres_in_water(particles, wavelength_nm, index);
}

std::shared_ptr<const SpheresOptics> shared(const Spheres& spheres) {
  return std::make_shared<const SpheresOptics>(optics_of_spheres(spheres));
}

/// One of each kind of distribution and of material.
std::vector<Spheres> all_kinds() {
  return {in_water(paper_phytoplankton),
          in_water({1.15, 0.02, 4, 0.1, 3}),
          {0.532 * um, 1.53, 0.006, LogNormal{0.0212 * um, 2.24, 0.005 * um, 5 * um}},
          {0.4 * um, 1.2, 0, SizeTable{{0.05 * um, 0.1 * um, 0.2 * um, 1 * um}, {0, 3, 2, 0.01}}}};
}

// The same sums by brute force: the midpoint rule over ln(radius), smooth piece by smooth piece.
struct Direct {
  double number = 0, volume = 0, extinction = 0, scattering = 0;
  std::vector<double> p;

  Direct(const Spheres& s, const std::vector<double>& degrees) : p(degrees.size()) {
    const double k = 2 * pi / s.wavelength_m;
    const auto ends = smooth_between_m(s.sizes);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      constexpr int steps = 6000;
      const double width = std::log(ends[i] / ends[i - 1]) / steps;
      for (int j = 0; j < steps; ++j) {
        const double r = ends[i - 1] * std::exp((j + 0.5) * width);
        const double n = number_per_log_radius(s.sizes, r) * width;
        const MieSphere sphere(k * r, {s.index, -s.absorption_index});
        const auto q = sphere.efficiencies();
        number += n;
        volume += n * 4 / 3 * pi * r * r * r;
        extinction += n * pi * r * r * q.extinction;
        scattering += n * pi * r * r * q.scattering;
        for (std::size_t a = 0; a < p.size(); ++a) {
          const double cosine = std::cos(degrees[a] * radian_per_degree);
          p[a] += n * mueller(sphere.amplitudes(cosine)).s11 / (k * k);
        }
      }
    }
    for (double& value : p) value /= scattering;
  }
};

// Seen red: with panels never halved; with the error estimated as 0; with half the angles; with p
// over extinction; without absorption.
TEST(Spheres, AreTheDirectSumOverTheirSizes) {
  const std::vector<double> degrees{0, 0.01, 1, 7, 33.3, 90, 120, 150, 170, 177, 179.5, 180};
  for (const Spheres& spheres : all_kinds()) {
    const SpheresOptics optics = optics_of_spheres(spheres);
    const Direct direct(spheres, degrees);
    EXPECT_LT(optics.error, spheres_tolerance);
    EXPECT_NEAR(optics.extinction_m2 / (direct.extinction / direct.number), 1, 1e-5);
    EXPECT_NEAR(optics.scattering_m2 / (direct.scattering / direct.number), 1, 1e-5);
    EXPECT_NEAR(optics.volume_m3 / (direct.volume / direct.number), 1, 1e-5);
    for (std::size_t a = 0; a < degrees.size(); ++a)
      EXPECT_NEAR(optics.phase.at(x_of(degrees[a])) / direct.p[a], 1, 1e-4) << degrees[a];
  }
}

// Without the angles, in a fraction of the time.
TEST(Spheres, HaveTheSameCrossSectionsWithoutTheirPhaseFunction) {
  auto kinds = all_kinds();
  kinds.push_back(in_water(paper_minerals));
  const SpheresCache cache;
  for (const Spheres& spheres : kinds) {
    const SpheresOptics optics = optics_of_spheres(spheres);
    const SphereSections sections = cache.sections(spheres);
    EXPECT_NEAR(sections.scattering_m2 / optics.scattering_m2, 1, 1e-5);
    EXPECT_NEAR(sections.absorption_m2, optics.absorption_m2, 1e-5 * optics.extinction_m2);
    EXPECT_NEAR(sections.volume_m3 / optics.volume_m3, 1, 1e-5);
    EXPECT_EQ(cache.sections(spheres).scattering_m2, sections.scattering_m2);
  }
}

// Over the angles, against the sums of coefficients. Seen red: with p over extinction; with g not
// weighted by the scattering.
TEST(Spheres, ConserveEnergy) {
  for (const Spheres& spheres : all_kinds()) {
    const SpheresOptics optics = optics_of_spheres(spheres);
    EXPECT_NEAR(4 * pi * optics.phase.mean(), 1, 1e-9);
    EXPECT_NEAR(4 * pi * optics.phase.mean_with_cosine(), optics.mean_cosine, 1e-9);
    EXPECT_NEAR(optics.extinction_m2 / (optics.scattering_m2 + optics.absorption_m2), 1, 1e-9);
  }
}

TEST(Spheres, OfOneSizeAreOneSphere) {
  const double r = 0.7 * um, wavelength = 0.4 * um;
  const SpheresOptics optics =
      optics_of_spheres({wavelength, 1.2, 0.01, Junge{4, r, r * (1 + 1e-8)}});
  const MieSphere sphere(2 * pi * r / wavelength, {1.2, -0.01});
  const double area = pi * r * r;
  EXPECT_NEAR(optics.extinction_m2 / (area * sphere.efficiencies().extinction), 1, 1e-5);
  EXPECT_NEAR(optics.absorption_m2 / (area * sphere.efficiencies().absorption), 1, 1e-5);
  EXPECT_NEAR(optics.volume_m3 / (4.0 / 3 * pi * r * r * r), 1, 1e-5);
  // What goes straight back is Q_back / (4 pi) of the area, by definition.
  EXPECT_NEAR(
      optics.phase.at(2) * optics.scattering_m2 / (area * sphere.efficiencies().back / (4 * pi)), 1,
      1e-5);
}

// Radii 0.01-1 um and 0.1-10 um in water of index 1.34: computed before with at least 160 radii a
// distribution, by another program, to the digits given. Seen red: with numbers per radius
// for those per ln(radius); without absorption.
TEST(Spheres, OfThePaperScatterAsWasComputedBefore) {
  const auto b_back = [](const Spheres& s) {
    return PhaseTable(phase_of_spheres(shared(s))).backscatter_fraction();
  };
  SeaParticles large_algae = paper_phytoplankton;
  large_algae.min_radius_um = 0.1;
  large_algae.max_radius_um = 10;
  EXPECT_NEAR(b_back(in_water(paper_phytoplankton)), 0.092, 6e-4);
  EXPECT_NEAR(b_back(in_water(large_algae)), 0.0158, 6e-5);
  EXPECT_NEAR(optics_of_spheres(in_water(large_algae)).mean_cosine, 0.892, 6e-4);
  EXPECT_NEAR(b_back(in_water(paper_minerals)), 0.0244, 6e-5);
  EXPECT_NEAR(b_back(in_water(paper_minerals, 550)), 0.0264, 6e-5);
  const SpheresOptics minerals = optics_of_spheres(in_water(paper_minerals));
  EXPECT_NEAR(minerals.mean_cosine, 0.845, 6e-4);
  EXPECT_NEAR(minerals.scattering_m2 / minerals.extinction_m2, 0.977, 6e-4);
}

// Rayleigh's: the cross-section goes as the sixth power of the radius, p as 1 + cos^2.
TEST(Spheres, AreRayleighsIfSmall) {
  const double r0 = 1e-4 * um, r1 = 1e-3 * um, k = 2 * pi / (0.4 * um);
  const SpheresOptics optics = optics_of_spheres({0.4 * um, 1.5, 0, Junge{4, r0, r1}});
  const double polarisability = (1.5 * 1.5 - 1) / (1.5 * 1.5 + 2);
  // The means of r^6 under r^-4: integrals of r^2 and of r^-4.
  const double mean =
      (r1 * r1 * r1 - r0 * r0 * r0) / 3 / ((1 / (r0 * r0 * r0) - 1 / (r1 * r1 * r1)) / 3);
  const double expected = 8.0 / 3 * pi * std::pow(k, 4) * polarisability * polarisability * mean;
  EXPECT_NEAR(optics.scattering_m2 / expected, 1, 1e-3);
  for (const double x : {0.0, 0.5, 1.0, 2.0})
    EXPECT_NEAR(optics.phase.at(x) / rayleigh(0).p(x), 1, 1e-3) << x;
}

/// |S|^2 of a faint sphere but for its contrast, Rayleigh-Gans theory: van de Hulst 1957, sec. 7.2;
/// Bohren & Huffman 1983, eq. (6.14) [from memory].
double faint_s11(double size, double x) {
  const double u = 2 * size * std::sqrt(x / 2), cosine = 1 - x;
  const double form = u < 1e-2 ? 1 - u * u / 10 : 3 * (std::sin(u) - u * std::cos(u)) / (u * u * u);
  return std::pow(size, 6) * form * form * (1 + cosine * cosine) / 2;
}

Spheres faint(double contrast, double absorption_index = 0) {
  return {0.532 * um / 1.34, 1 + contrast, absorption_index, Junge{4, 0.1 * um, 1 * um}};
}

// The mean of |S|^2 over sizes, and of the solid angle, in the limit of no contrast. Seen red: with
// the coefficients' own differences at 1e-13; with 1e-4 for 1e-8, where the theory is not the limit
// yet.
TEST(Spheres, NearlyOfTheMediumScatterAsRayleighAndGansSay) {
  const double k = 2 * pi / (0.532 * um / 1.34), from = std::log(0.1), to = std::log(1.0);
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  const auto s11 = [&](double x) {  // numbers per ln(radius) go as radius^-3
    const auto at = [&](double t) { return std::exp(-3 * t) * faint_s11(k * std::exp(t) * um, x); };
    return Rule::integrate(at, from, to);
  };
  const double back = Rule::integrate(s11, 1.0, 2.0), all = back + Rule::integrate(s11, 0.0, 1.0);
  EXPECT_NEAR(back / all, 0.00780, 5e-6);
  for (const double contrast :
       {1e-7, 1.001e-8, 0.999e-8, 1e-13, 0.0, -0.999e-8, -1.001e-8, -1e-7}) {
    const auto optics = shared(faint(contrast));
    for (const double x : {0.0, 1e-3, 0.3, 1.0, 1.7, 2.0})
      EXPECT_NEAR(optics->phase.at(x) / (s11(x) / (2 * pi * all)), 1, 3e-6) << contrast << " " << x;
    EXPECT_NEAR(PhaseTable(phase_of_spheres(optics)).backscatter_fraction(), back / all,
                1e-4 * back / all);
  }
}

// On both sides of where another index stands in, and straight through 1. Seen red: with
// |m^2 - 1| for its square; with absorption as its square.
TEST(Spheres, HaveCrossSectionsThatFallAsTheirContrastDoes) {
  const SpheresCache cache;
  const auto scattering = [&](double contrast, double k = 0) {
    return cache.sections(faint(contrast, k)).scattering_m2;
  };
  const double at_1 = scattering(1e-7) / 1e-14;
  for (const double contrast : {1.001e-8, 0.999e-8, -0.999e-8, 1e-11, 1e-15}) {
    const double rounded = (1 + contrast) - 1;  // as far as 1 + contrast has its digits
    EXPECT_NEAR(scattering(contrast) / (rounded * rounded) / at_1, 1, 1e-6) << contrast;
    EXPECT_NEAR(sampled_sections(faint(contrast)).scattering_m2 / scattering(contrast), 1, 1e-3);
  }
  EXPECT_EQ(scattering(0), 0);
  EXPECT_NEAR(scattering(0, 1e-10) / 1e-20 / at_1, 1, 1e-6);
  // All of a faint sphere absorbs as its material does: 4 pi k / wavelength.
  for (const double k : {1e-7, 1e-9, 1e-12}) {
    const SpheresOptics optics = optics_of_spheres(faint(0, k));
    const double bulk = optics.volume_m3 * 4 * pi * k / (0.532 * um / 1.34);
    EXPECT_NEAR(optics.absorption_m2 / bulk, 1, 1e-5) << k;
    EXPECT_NEAR(optics.extinction_m2 / (bulk + optics.scattering_m2), 1, 1e-5) << k;
    EXPECT_NEAR(sampled_sections(faint(0, k)).absorption_m2 / bulk, 1, 1e-3) << k;
  }
}

TEST(Spheres, FitIntoAPhaseTable) {
  const auto optics = shared(in_water(paper_phytoplankton));
  const PhaseShape shape = phase_of_spheres(optics);
  const PhaseTable table(shape);
  EXPECT_NEAR(table_integral(shape), 1, 1e-5);
  EXPECT_NEAR(table.mean_cosine(), optics->mean_cosine, 1e-5);
  for (double degrees = 0.02; degrees <= 180; degrees *= 1.003) {
    const double x = x_of(degrees);
    EXPECT_NEAR(table.view().value<double>(x) / shape.p(x), 1, 1e-4) << degrees;
  }
}

// The forward peak of minerals up to 10 um, outside the glory, which is narrower than the table's
// cells. Seen red: with half the core's share.
TEST(Spheres, KeepTheForwardPeakOfLargeSpheres) {
  const auto optics = shared(in_water(paper_minerals));
  const PhaseShape shape = phase_of_spheres(optics);
  const PhaseTable table(shape);
  for (double degrees = 0.02; degrees < 150; degrees *= 1.003) {
    const double x = x_of(degrees);
    EXPECT_NEAR(table.view().value<double>(x) / shape.p(x), 1, 2e-4) << degrees;
  }
  EXPECT_NEAR(shape.core_mass / (2 * pi * PhaseView::x_core * optics->phase.at(0)), 1, 1e-3);
}

// Calibration beads of polystyrene: fringes all around, and a glory that is narrower the larger
// they are. The table has their integral, their b_b and g, p straight back, and p between its nodes
// as far as fringes allow. Seen red: with octaves of x alone, cells of 7 degrees straight back;
// with the line of each cell behind 90 degrees from its other edge.
TEST(Spheres, OfNearlyOneSizeFitIntoAPhaseTable) {
  constexpr double wavelength = 0.532 * um / 1.34;
  for (const double radius_um : {0.05, 0.5, 1.0, 2.1, 3.0, 10.0}) {
    for (const double width : {0.01, 0.05}) {
      SCOPED_TRACE(fmt::format("{} um, {}", radius_um, width));
      const double r = radius_um * um;
      const auto optics = shared({wavelength, 1.19, 0, Junge{4, r * (1 - width), r * (1 + width)}});
      const PhaseShape shape = phase_of_spheres(optics);
      EXPECT_NEAR(table_integral(shape), 1, 1.5e-5);
      const PhaseTable table(shape);
      EXPECT_NEAR(table.mean_cosine(), optics->mean_cosine, 2e-5);
      const double back = integral(shape.p, 1, 2);
      EXPECT_NEAR(table.backscatter_fraction(), back, 1e-3 * back);
      EXPECT_NEAR(table.view().value(2.0) / shape.p(2), 1, 2e-5);
      // Behind 90 degrees, against the larger one of p and its mean there. The finest fringes go as
      // cos(2 size angle), and cells are up to 0.26 degrees long: a straight line is this far off.
      const double phase = 2 * 2 * pi * r / wavelength * 0.26 * radian_per_degree;
      for (double degrees = 90; degrees <= 180; degrees += 0.07) {
        const double x = x_of(degrees), p = shape.p(x);
        EXPECT_NEAR(table.view().value<double>(x), p,
                    (1e-4 + phase * phase / 8) * std::max(p, back / (2 * pi)))
            << degrees;
      }
    }
  }
}

// Seen red: with the refusal left out.
TEST(Spheres, TooLargeForAPhaseTableAreRefused) {
  const auto optics = shared({0.4 * um, 1.5, 0, Junge{4, 50 * um, 50.00001 * um}});
  expect_contains(message<InputError>([&] { phase_of_spheres(optics); }),
                  "has detail that is too fine: as tabulated by the program it integrates to");
}

// What its time goes with: at most a second for either of these.
TEST(Spheres, OfThePaperNeedFewRadii) {
  EXPECT_LE(optics_of_spheres(in_water(paper_phytoplankton)).radii, 300);
  EXPECT_LE(optics_of_spheres(in_water(paper_minerals)).radii, 5000);
}

// Seen red: computed each time.
TEST(Spheres, AreComputedOnceForEachKind) {
  const SpheresCache cache;
  const Spheres first = all_kinds()[0];
  const auto once = cache(first);
  EXPECT_EQ(cache(first), once);
  for (Spheres other : {in_water(paper_phytoplankton, 533), all_kinds()[2], all_kinds()[3]})
    EXPECT_NE(cache(other), once);
  Spheres darker = first;
  darker.absorption_index *= 2;
  EXPECT_NE(cache(darker), once);
  EXPECT_GT(cache(darker)->absorption_m2, once->absorption_m2);
  EXPECT_EQ(cache(first), once);
}

// Seen red: tabulated each time.
TEST(Spheres, HaveTheirPhaseFunctionTabulatedOnce) {
  const SpheresCache cache;
  const Spheres kind = all_kinds()[0];
  const auto once = cache.phase(kind);
  EXPECT_EQ(cache.phase(kind), once);
  const PhaseShape direct = phase_of_spheres(shared(kind));
  for (const double x : {PhaseView::x_core, 0.01, 2.0}) EXPECT_EQ(once->p(x), direct.p(x)) << x;
  expect_contains(
      message<InputError>([&] {
        static_cast<void>(cache.phase({0.4 * um, 1.5, 0, Junge{4, 50 * um, 50.00001 * um}}));
      }),
      "has detail that is too fine");
}

TEST(Spheres, RefuseDistributionsThatAreNone) {
  for (const SizeDistribution& sizes : std::vector<SizeDistribution>{
           Junge{4, 0, 1}, Junge{4, 2, 1}, Junge{std::nan(""), 1, 2}, LogNormal{1, 1, 0.1, 2},
           LogNormal{0, 2, 0.1, 2}, SizeTable{{1}, {1}}, SizeTable{{1, 2}, {1}},
           SizeTable{{1, 2}, {0, 0}}, SizeTable{{1, 2}, {1, -1}}, SizeTable{{2, 1}, {1, 1}}})
    EXPECT_THROW(smooth_between_m(sizes), ContractViolation) << sizes.index();
}

}  // namespace
}  // namespace photic::optics
