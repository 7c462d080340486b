// Reflection and transmission of slabs against published results of other methods, through the same
// walk as the echoes.
#include <gtest/gtest.h>

#include <cstdio>

#include "run/run.hpp"
#include "support/scenes.hpp"
#include "support/tables.hpp"
#include "support/z_test.hpp"

namespace photic::test {
namespace {

/// A pencil of light straight down from just above the sea, gates wide open in time, directed
/// sampling off or on.
std::string scene(const std::string& index, const std::string& layer, double directed_fraction,
                  double photons) {
  return R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, 1.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.01
half_divergence_mrad = 0.0
[[telescope]]
position_m = [0.0, 0.0, 1.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.10
focal_length_m = 1.0
detector_diameter_m = 0.04
)" + channel("elastic") +
         "[sea]\nrefractive_index = " + index + "\n" + layer +
         "[gates]\nstart_ns = 0.0\nstop_ns = 1e7\nstep_ns = 1e6\n" +
         simulation(photons, 11, fmt::format("directed_fraction = {}", directed_fraction));
}

const std::string van_de_hulst_layer = R"(
[[sea.layer]]
bottom_depth_m = 2.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.1, b_per_m = 0.9 } ]
phase_function = { model = "henyey-greenstein", g = 0.75 }
)";

/// Each photon's share is between 0 and 1, so that the binomial error bounds the true one.
double error_bound(double share, std::uint64_t photons) {
  return std::sqrt(share * (1 - share) / static_cast<double>(photons));
}

// van de Hulst 1980, Multiple Light Scattering, vol. 2, table 35: optical thickness 2, albedo 0.9,
// g = 0.75, normal incidence, no refraction: R = 0.09739, T = 0.66096. Seen red: the sign of g; the
// free path on a log base 10; c / c' left out; absorption along the way left out; 1 % too little
// booked as absorbed.
TEST(Slab, VanDeHulst) {
  const auto result = run::run(read(scene("1.0", van_de_hulst_layer, 0.0, 4e6)), *test::tables());
  ZFamily family(0.01);
  family.add(result.ledger.escaped, 0.09739, error_bound(0.09739, result.photons), "reflectance");
  family.add(result.ledger.sea_bed, 0.66096, error_bound(0.66096, result.photons), "transmittance");
  std::printf("R %.5f (0.09739), T %.5f (0.66096)\n", result.ledger.escaped, result.ledger.sea_bed);
  family.judge();
  EXPECT_NEAR(result.ledger.absorbed, 1 - 0.09739 - 0.66096, 1e-3);
}

// Giovanelli 1955, Opt. Acta 2, 153: semi-infinite, isotropic, albedo 0.9, n = 1.5: R = 0.2600, of
// which 0.0400 is reflected by the surface itself. A layer of optical thickness 60 stands for the
// infinite one. Seen red: internal reflection left out, or all of it but
// total reflection; c / c' left out; absorption along the way left out.
TEST(Slab, Giovanelli) {
  const auto result = run::run(read(scene("1.5", R"(
[[sea.layer]]
bottom_depth_m = 60.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.1, b_per_m = 0.9 } ]
phase_function = { model = "isotropic" }
)",
                                          0.0, 1e6)),
                               *test::tables());
  std::printf("R %.5f (0.2600)\n", result.ledger.escaped);
  // The table has four digits.
  EXPECT_NEAR(result.ledger.escaped, 0.2600, 5e-5 + 3 * error_bound(0.26, result.photons));
}

// What is emitted is absorbed, leaves, or is cut off, in the mean: free paths drawn from scattering
// alone, directed sampling and conversions keep weights right on average, not history by history.
// Four million photons know the sum to 3e-4. Seen red: with c / c' left out; with absorption along
// the way left out; with 1 % too little booked as absorbed.
TEST(Slab, PhotonsAreConserved) {
  for (const double directed_fraction : {0.0, 0.1}) {
    const auto l =
        run::run(read(scene("1.34", van_de_hulst_layer, directed_fraction, 4e6)), *test::tables())
            .ledger;
    EXPECT_NEAR(l.sum(), 1.0, 1e-3) << directed_fraction;
  }
}

// A conservative slab gives everything back: R + T = 1. Seen red: with 0.1 % lost at every event.
TEST(Slab, Conservative) {
  const auto result = run::run(read(scene("1.34", R"(
[[sea.layer]]
bottom_depth_m = 5.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.0, b_per_m = 1.0 } ]
phase_function = { model = "henyey-greenstein", g = 0.75 }
)",
                                          0.0, 1e6)),
                               *test::tables());
  EXPECT_EQ(result.ledger.absorbed, 0.0);
  EXPECT_NEAR(result.ledger.escaped + result.ledger.sea_bed + result.ledger.roulette, 1.0, 1e-12);
  EXPECT_NEAR(result.ledger.roulette, 0.0, 1e-3);
}

}  // namespace
}  // namespace photic::test
