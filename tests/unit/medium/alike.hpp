// What light meets in a medium's environment against a medium of its own.
#pragma once

#include <gtest/gtest.h>

#include "medium/medium.hpp"

namespace photic::medium {

/// Attenuation, and scattering at an angle, line by line and layer by layer.
inline void expect_meets_alike(const Medium& all, std::size_t environment, const Medium& own) {
  const MediumView a = all.view(), o = own.view();
  const std::size_t first = environment * all.c.size();
  const auto parts = static_cast<std::size_t>(a.environments.parts);
  for (std::size_t i = 0; i < all.c.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_NEAR(all.c[i] + all.environments.excess_c[first + i], own.c[i],
                1e-15 + 1e-12 * own.c[i]);
    const double b = all.albedo[i] * all.c[i];
    for (const double x : {1e-6, 1e-3, 0.1, 1.0, 1.9}) {
      double p = a.phases.value<double>(x, all.elastic_phase[i]);
      for (std::size_t k = 0; k < parts; ++k)
        p += all.environments.excess_part[(first + i) * parts + k] *
             a.phases.value<double>(x, all.environments.part_phase[i * parts + k]);
      const double expected =
          own.albedo[i] * own.c[i] * o.phases.value<double>(x, own.elastic_phase[i]);
      EXPECT_NEAR(b * p, expected, 2e-4 * expected) << x;
    }
  }
}

}  // namespace photic::medium
