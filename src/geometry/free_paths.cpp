#include "geometry/free_paths.hpp"

namespace photic::geometry {

FreePaths::FreePaths(const medium::Medium& medium, std::span<const double> share) {
  std::vector<double> walk_c, walk_mean_path, continuous_c, gain;
  for (std::size_t i = 0; i < medium.c.size(); ++i) {
    walk_c.push_back(medium.c[i] * share[i]);
    walk_mean_path.push_back(1 / walk_c.back());
    continuous_c.push_back(medium.c[i] * (1 - share[i]));
    gain.push_back(1 / share[i]);
  }
  walk_c_ = medium.with_integrals(walk_c, 1);
  continuous_c_ = medium.with_integrals(continuous_c, 0);
  walk_mean_path_ = TwinTable(medium.with_bed<double>(walk_mean_path, 1.0));
  collision_gain_ = TwinTable(medium.with_bed<double>(gain, 1.0));
  by_walk_tau_ = medium.layering_by(walk_c, edges_);
}

Slabs FreePaths::slabs(const medium::Medium& medium) const {
  return {medium.view(),          walk_c_.view(),         continuous_c_.view(),
          walk_mean_path_.view(), collision_gain_.view(), by_walk_tau_.view(edges_.view())};
}

}  // namespace photic::geometry
