#include "estimator/tallies/boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/constants.hpp"

namespace photic::estimator {

Boundaries::Boundaries(const Cells& cells, std::vector<double> share, std::vector<double> lost,
                       const std::vector<double>& zenith_deg)
    : cells_(cells), share_(std::move(share)), lost_(std::move(lost)) {
  for (const double degrees : zenith_deg) cosines_.push_back(std::cos(degrees * radian_per_degree));
}

void Boundaries::absorb(std::size_t layer, double weight, tally::TallyScores& scores) const {
  const std::size_t first = layer * cells_.constituents;
  for (std::size_t i = first; i < first + cells_.constituents; ++i)
    if (share_[i] > 0) scores.add(cells_.absorbed + i, weight * share_[i]);
}

void Boundaries::fly(const Flight& flight, const ContinuousAbsorption& absorption,
                     tally::TallyScores& scores) const {
  double weight = flight.weight;
  each_layer(absorption, flight, [&](std::size_t layer, double length, double) {
    weight -= lose(absorption, layer, length, weight, scores);
  });
}

double Boundaries::lose(const ContinuousAbsorption& absorption, std::size_t layer, double length,
                        double weight, tally::TallyScores& scores) const {
  const double depth = absorption.per_m(layer) * length;
  const double lost = weight * depth * decay_over(depth).mean;
  absorb(absorption.first_layer() + layer, lost, scores);  // if weights grow, by collisions instead
  return lost;
}

void Boundaries::escape(double cosine, double weight, bool was_in_water,
                        tally::TallyScores& scores) const {
  const auto beyond =
      std::upper_bound(cosines_.begin() + 1, cosines_.end() - 1, cosine, std::greater());
  scores.add(cells_.escaped + static_cast<std::size_t>(beyond - cosines_.begin()) - 1, weight);
  if (const auto& cell = was_in_water ? cells_.left_water : cells_.reflected_by_surface)
    scores.add(*cell, weight);
}

}  // namespace photic::estimator
