#include "medium/air_table.hpp"

#include <gtest/gtest.h>

#include "support/tables.hpp"

namespace photic::medium {
namespace {

// The values of air_at(), at its places. Seen red: with wavelengths and layers changed over.
TEST(AirTable, HoldsTheLayersAtTheirPlaces) {
  const optics::AirLibrary& library = test::tables()->air();
  const optics::AirProfile profile = optics::with_aerosols(
      library, library.atmosphere("tropical"), 10, optics::AerosolProfiles::seasons.front());
  const std::vector<double> nm{300, 532, 1064};
  const OpticalTable table = air_table(*test::tables(), profile, {}, nm);
  ASSERT_EQ(table.layers() + 1, profile.z_km.size());
  EXPECT_EQ(table.of, Layered::air);
  EXPECT_TRUE(table.emission.empty() && table.a_exciting_per_m.empty());
  for (std::size_t w = 0; w < nm.size(); ++w) {
    const optics::AirOptics air = optics::air_at(library, profile, {}, nm[w]);
    for (std::size_t k = 0; k < table.layers(); k += 6) {
      const optics::AirLayer& layer = air.layers[k];
      const std::size_t at = k * nm.size() + w;
      EXPECT_EQ(table.last_m[k], 1e3 * layer.top_km);
      EXPECT_EQ(table.a_per_m[at], layer.a_per_m());
      EXPECT_EQ(table.b_per_m[at], layer.b_per_m());
      EXPECT_EQ(table.parts[0].b_per_m[at], layer.molecules_b_per_m);
      EXPECT_EQ(table.parts[1].a_per_m[at], layer.ozone_a_per_m);
      EXPECT_EQ(table.parts[2].b_per_m[at], layer.aerosols_b_per_m);
      EXPECT_EQ(table.refractive_index[at], layer.refractive_index);
      EXPECT_NEAR(table.mean_cosine[at],
                  layer.aerosols_g * layer.aerosols_b_per_m / layer.b_per_m(), 2e-4);
      EXPECT_EQ(table.phase_function_per_sr[(at + 1) * table.angles() - 1], layer.phase.p(2));
    }
  }
  ASSERT_EQ(table.sources.back().quantity, "a of ozone");  // another table from 532 nm on
  EXPECT_EQ(table.sources.front().first_nm, 300);
  EXPECT_EQ(table.sources.front().last_nm, 1064);
}

}  // namespace
}  // namespace photic::medium
