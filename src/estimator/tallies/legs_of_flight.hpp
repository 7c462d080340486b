// The legs of flights through spherical air, each within one shell, as tallies are shown them.
#pragma once

#include "estimator/tallies/tallies.hpp"
#include "geometry/shells.hpp"
#include "tally/tally_scores.hpp"
#include "transport/photon.hpp"
#include "transport/shell_flight.hpp"

namespace photic::estimator {

class LegsOfFlight {
 public:
  /// `tallies` may be null. The photon stands where the flight begins.
  LegsOfFlight(const Tallies* tallies, const medium::ShellsView& shells,
               const transport::Photon<double>& photon, tally::TallyScores& scores)
      : tallies_(tallies), scores_(scores), weight_(photon.weight) {
    if (tallies_ == nullptr || !tallies_->in_shells || !tallies_->in_shells->has_zones()) return;
    const auto plane = geometry::plane_of(geometry::place_in(shells, photon.position).from_centre,
                                          photon.direction);
    way_ = tallies_->in_shells->way_of(plane);
  }

  void operator()(const transport::ShellLeg& leg) {
    if (tallies_ == nullptr) return;
    if (tallies_->in_shells) {
      tallies_->in_shells->add(leg, weight_, way_, scores_);
      if (tallies_->in_shells->has_zones())
        way_.turn = way_.turn.by(geometry::turn_of(leg.from, leg.length, leg.to.radius));
    }
    const auto layer = static_cast<std::size_t>(leg.from.shell);
    if (tallies_->boundaries)
      weight_ -= tallies_->boundaries->lose(tallies_->inside.front().absorption, layer, leg.length,
                                            weight_, scores_);
    else if (tallies_->in_shells)
      weight_ *= tallies_->in_shells->share_after(layer, leg.length);
  }
  void end_on_ground(double weight) const {
    if (tallies_ != nullptr && tallies_->boundaries)
      tallies_->boundaries->absorb_at_bottom(weight, scores_);
  }

 private:
  const Tallies* tallies_;
  tally::TallyScores& scores_;
  double weight_;  ///< where the leg begins
  WayOverZones way_;
};

}  // namespace photic::estimator
