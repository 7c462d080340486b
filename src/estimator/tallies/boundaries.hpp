// The ends of all light: what layers and their constituents absorb, what boundaries do, and what
// escapes, by its direction.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "estimator/tallies/continuous_absorption.hpp"
#include "estimator/tallies/flight.hpp"
#include "tally/tally_scores.hpp"

namespace photic::estimator {

/// The boundaries of one side of the surface.
class Boundaries {
 public:
  /// The first cells of its grids.
  struct Cells {
    std::size_t absorbed = 0;      ///< of this side's first layer
    std::size_t constituents = 0;  ///< cells of a layer
    std::size_t escaped = 0;
    std::optional<std::size_t> reflected_by_surface, left_water, bottom, film;
  };
  /// `share`: of a layer's absorption, each constituent's, [layer][constituent]; `lost`: the share
  /// of weight that a collision in a layer takes. `zenith_deg`: edges.
  Boundaries(const Cells& cells, std::vector<double> share, std::vector<double> lost,
             const std::vector<double>& zenith_deg);

  /// Books the absorption along a flight.
  void fly(const Flight& flight, const ContinuousAbsorption& absorption,
           tally::TallyScores& scores) const;
  /// Books that along a piece within a layer, of light of a weight at its start; returns what that
  /// loses. If weights grow, collisions lose it instead.
  double lose(const ContinuousAbsorption& absorption, std::size_t layer, double length,
              double weight, tally::TallyScores& scores) const;
  /// Books that of a collision; `weight`: before it loses any there.
  void collide(std::size_t layer, double weight, tally::TallyScores& scores) const {
    if (lost_[layer] > 0) absorb(layer, weight * lost_[layer], scores);
  }
  /// Books light that is absorbed in a layer.
  void absorb(std::size_t layer, double weight, tally::TallyScores& scores) const;
  /// Light goes away for good, under a cosine to straight up. Light that was in the water has left
  /// it; other light has been reflected.
  void escape(double cosine, double weight, bool was_in_water, tally::TallyScores& scores) const;
  void absorb_at_bottom(double weight, tally::TallyScores& scores) const {
    if (cells_.bottom) scores.add(*cells_.bottom, weight);
  }
  void absorb_in_film(double weight, tally::TallyScores& scores) const {
    if (cells_.film) scores.add(*cells_.film, weight);
  }

 private:
  Cells cells_;
  std::vector<double> share_, lost_;
  std::vector<double> cosines_;  ///< edges of the zenith angles, descending
};

}  // namespace photic::estimator
