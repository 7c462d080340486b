#include "medium/shells.hpp"

namespace photic::medium {

Shells::Shells(double planet_m, const std::vector<double>& edges, const std::vector<double>& index)
    : planet_m_(planet_m), height_(edges.rbegin(), edges.rend()) {
  if (index.empty()) return;
  constexpr double vacuum = 1;
  // By differences of the indices, which are a few digits of these.
  const auto bent = [](double from, double to) { return (to - from) * (to + from) / (to * to); };
  double above = vacuum;
  for (std::size_t sphere = 0; sphere + 1 < height_.size(); ++sphere) {
    const double below = index[index.size() - 1 - sphere];
    upwards_.push_back(bent(below, above));
    downwards_.push_back(bent(above, below));
    above = below;
  }
}

}  // namespace photic::medium
