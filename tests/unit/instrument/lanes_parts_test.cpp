// The parts below the transport with four lanes: each lane equals the scalar, bit for bit.
#include "instrument/disc.hpp"
#include "instrument/telescope.hpp"
#include "optics/fresnel.hpp"
#include "unit/instrument/telescopes.hpp"
#include "unit/transport/packs.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {
namespace {

using test::Random;

TEST(LanesOf, Refract) {
  Random random(1);
  int total = 0;
  for (int g = 0; g < groups; ++g) {
    Four<double> n1, n2, cosine;
    for (std::size_t i = 0; i < lanes; ++i) {
      n1[i] = random.chance(0.5) ? 1.0 : random.between(1, 1.5);
      n2[i] = random.chance(0.1) ? n1[i] : random.between(1, 1.5);
      cosine[i] = random.chance(0.1) ? double(random.below(2)) : random.uniform();
    }
    const auto packed = optics::refract(pack(n1), pack(n2), pack(cosine));
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto scalar = optics::refract(n1[i], n2[i], cosine[i]);
      expect_same(packed.cos_transmitted[i], scalar.cos_transmitted, "cosine");
      expect_same(packed.reflectance[i], scalar.reflectance, "reflectance");
      total += scalar.reflectance == 1;
    }
  }
  EXPECT_GT(total, groups / 10);
}

TEST(LanesOf, PhaseValueAndSample) {
  Random random(2);
  const auto sea = make_sea(40);
  const auto phases = sea.view().phases;
  for (int g = 0; g < groups; ++g) {
    Four<double> x, u;
    Four<std::int32_t> table;
    for (std::size_t i = 0; i < lanes; ++i) {
      x[i] = random.chance(0.1) ? 2.0 * random.below(2) : random.scale(1e-10, 2);
      u[i] = random.chance(0.3) ? random.scale(1e-6, 1) : random.uniform();
      table[i] = random.below(5);
    }
    const auto value = phases.value<Lanes4>(pack(x), pack(table));
    const auto sample = phases.sample<Lanes4>(pack(u), pack(table));
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(value[i], phases.value<double>(x[i], table[i]), "value");
      expect_same(sample[i], phases.sample<double>(u[i], table[i]), "sample");
    }
  }
}

TEST(LanesOf, Turned) {
  Random random(3);
  for (int g = 0; g < groups; ++g) {
    Four<Vec3<double>> w;
    Four<double> x, azimuth;
    for (std::size_t i = 0; i < lanes; ++i) {
      w[i] = random.chance(0.1) ? Vec3<double>{0, 0, random.chance(0.5) ? 1.0 : -1.0}
                                : random.direction();
      x[i] = random.scale(1e-12, 2);
      azimuth[i] = random.between(0, 2 * pi);
    }
    const auto out = turned(pack(w), pack(x), pack(azimuth, [](double a) { return std::cos(a); }),
                            pack(azimuth, [](double a) { return std::sin(a); }));
    const auto apart = one_minus_cos(pack(w), out);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto scalar = turned(w[i], x[i], std::cos(azimuth[i]), std::sin(azimuth[i]));
      expect_same(out, i, scalar, "direction");
      expect_same(apart[i], one_minus_cos(w[i], scalar), "one minus cosine");
    }
  }
}

TEST(LanesOf, CirclesOverlap) {
  Random random(4);
  int nested = 0, apart = 0;
  for (int g = 0; g < groups; ++g) {
    Four<double> r1, r2, d;
    for (std::size_t i = 0; i < lanes; ++i) {
      r1[i] = random.chance(0.1) ? 0.0 : random.uniform();
      r2[i] = random.chance(0.1) ? r1[i] : random.uniform();
      d[i] = random.chance(0.1) ? 0.0 : random.between(0, 2);
      nested += d[i] < std::abs(r1[i] - r2[i]);
      apart += d[i] > r1[i] + r2[i];
    }
    const auto packed = instrument::circles_overlap(pack(r1), pack(r2), pack(d));
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(packed[i], instrument::circles_overlap(r1[i], r2[i], d[i]), "overlap");
    }
  }
  EXPECT_GT(nested, groups / 2);
  EXPECT_GT(apart, groups / 2);
}

TEST(LanesOf, DiscSolidAngle) {
  Random random(5);
  for (int g = 0; g < groups; ++g) {
    Four<double> r, h, p;
    for (std::size_t i = 0; i < lanes; ++i) {
      r[i] = random.chance(0.1) ? 0.0 : random.uniform();
      h[i] = random.scale(1e-3, 100);
      p[i] = random.chance(0.1) ? 0.0 : random.scale(1e-3, 100);
    }
    const auto packed = instrument::disc_solid_angle(pack(r), pack(h), pack(p));
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(packed[i], instrument::disc_solid_angle(r[i], h[i], p[i]), "solid angle");
    }
  }
}

TEST(LanesOf, OverlapAndView) {
  Random random(6);
  int in_view = 0, sharp = 0;
  for (int g = 0; g < groups; ++g) {
    const auto scene = instrument::random_telescope(random);
    const auto telescope = instrument::make_telescope<double>(scene);
    const auto telescope4 = instrument::make_telescope<Lanes4>(scene);
    Four<double> per_range, tan_off_axis, x, y, rise;
    for (std::size_t i = 0; i < lanes; ++i) {
      per_range[i] = random.scale(1e-3, 10);
      if (random.chance(0.1)) {  // in focus, if the telescope has one
        per_range[i] = 1 / scene.focal_length_m - 1 / telescope.detector_distance;
        ++sharp;
      }
      tan_off_axis[i] =
          telescope.detector_radius / telescope.detector_distance * random.between(0, 3);
      const double azimuth = random.between(0, 2 * pi);
      const double tangent = random.scale(0.01, 10);
      rise[i] = random.scale(0.1, 1000);
      x[i] = rise[i] * tangent * std::cos(azimuth);
      y[i] = rise[i] * tangent * std::sin(azimuth);
    }
    const auto eta = telescope4.overlap(pack(per_range), pack(tan_off_axis));
    const auto kept = telescope4.may_see_beyond(pack(x), pack(y), pack(rise));
    for (std::size_t i = 0; i < lanes; ++i) {
      expect_same(eta[i], telescope.overlap(per_range[i], tan_off_axis[i]), "overlap");
      expect_same(kept[i], telescope.may_see_beyond(x[i], y[i], rise[i]), "view");
      in_view += kept[i];
    }
  }
  EXPECT_GT(in_view, groups);
  EXPECT_LT(in_view, 3 * groups);
  EXPECT_GT(sharp, groups / 10);
}

}  // namespace
}  // namespace photic::transport
