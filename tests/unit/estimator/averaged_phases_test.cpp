// Phase functions averaged over cones, against sums over points of the cone.
#include "estimator/averaged_phases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/constants.hpp"
#include "unit/transport/sea.hpp"

namespace photic::estimator {
namespace {

const transport::Sea sea = transport::make_sea(40);

/// Fournier-Forand, Henyey-Greenstein and molecules.
const std::set<std::int32_t> elastic_tables(sea.elastic_phase.begin(), sea.elastic_phase.end());

EntryCone<double> cone_of(double half_angle) {
  const double x = one_minus_cos_of(half_angle);
  EntryCone<double> cone;
  cone.by_depth = true;
  cone.ring[0] = {x, 1, 2 * pi * x};
  return cone;
}

// Over the sphere a mean of phase functions is 1, whatever the cone. Seen red: with the mean inside
// the cone without what is scattered by less than the angle to its axis; with two points in the
// cells at the rim.
TEST(AveragedPhases, IntegrateToOne) {
  for (const double half_angle : {4e-5, 3e-3, 0.015, 0.1, 0.8, 1.7}) {
    const AveragedPhaseTables tables(sea, {cone_of(half_angle)}, {});
    const auto averaged = tables.view();
    for (const std::int32_t table : elastic_tables) {
      double sum = 0;
      for (int i = 0; i < AveragedPhases::cells; ++i) {
        const bool forward = i < AveragedPhases::forward_cells;
        const auto [from, to] = AveragedPhases::edges(i);
        const double middle = (from + to) / 2;
        sum += 2 * pi * (to - from) * averaged.value(0, forward ? middle : 2 - middle, table);
      }
      EXPECT_NEAR(sum, 1, 1e-5) << "half angle " << half_angle << ", table " << table;
    }
  }
}

// At angles away from the rim of the cone. Seen red: with the angle to the axis for that to the
// point.
TEST(AveragedPhases, AreMeansOverTheCone) {
  constexpr int radii = 300, azimuths = 300;
  for (const double half_angle : {0.003, 0.1, 0.5}) {
    const AveragedPhaseTables tables(sea, {EntryCone<double>{}, cone_of(half_angle)}, {});
    const auto averaged = tables.view();
    EXPECT_EQ(averaged.value(0, 0.1, 0), 0) << "of parallel rays";
    for (const std::int32_t table : elastic_tables) {
      for (const double share : {0.3, 1.7, 4.0, 15.0}) {
        const double angle = share * half_angle;
        if (angle > 3 || (table == 0 && share < 1)) continue;  // points miss a peak in the cone
        const Vec3<double> direction{std::sin(angle), 0, std::cos(angle)};
        double sum = 0;
        for (int i = 0; i < radii; ++i) {
          const double x = (i + 0.5) / radii * one_minus_cos_of(half_angle);
          for (int j = 0; j < azimuths; ++j) {
            const double azimuth = 2 * pi * (j + 0.5) / azimuths;
            const auto point =
                turned(Vec3<double>{0, 0, 1}, x, std::cos(azimuth), std::sin(azimuth));
            sum += sea.view().phases.value<double>(one_minus_cos(point, direction), table);
          }
        }
        const double mean = sum / (radii * azimuths);
        EXPECT_NEAR(averaged.value(1, 1 - std::cos(angle), table) / mean, 1, 1e-4)
            << "half angle " << half_angle << ", table " << table << ", at " << share;
      }
    }
  }
}

// Their rims are so small that differences along them are lost to rounding. Seen red: with cones as
// narrow as they are.
TEST(AveragedPhases, OfNarrowConesAreThePhaseFunctions) {
  const AveragedPhaseTables tables(sea, {cone_of(1e-14)}, {});
  for (const std::int32_t table : elastic_tables)
    for (double x = 1e-10; x < 2; x *= 1.3) {
      const double p = sea.view().phases.value<double>(x, table);
      EXPECT_NEAR(tables.view().value(0, x, table) / p, 1, 1e-4) << "table " << table << ", " << x;
    }
}

// Seen red: with the means of all tables.
TEST(AveragedPhases, AreThoseOfElasticScattering) {
  const AveragedPhaseTables tables(sea, {cone_of(0.1)}, {});
  ASSERT_LT(elastic_tables.size(), sea.phase_count());
  for (std::int32_t table = 0; table < sea.phase_count(); ++table)
    EXPECT_EQ(tables.view().value(0, 0.1, table) > 0, elastic_tables.contains(table)) << table;
}

}  // namespace
}  // namespace photic::estimator
