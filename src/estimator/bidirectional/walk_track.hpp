// Walks of the bidirectional estimator on their way: one, or one in each lane.
#pragma once

#include <cstdint>

#include "core/flatten.hpp"
#include "estimator/bidirectional/walk_steps.hpp"
#include "lanes/lane_columns.hpp"

namespace photic::estimator {

/// Takes the walks from one instrument; see WalkSteps of the Source.
template <class T, class Source>
class WalkTracer {
 public:
  WalkTracer(const World<T>& world, const Samples<T>& samples, Source& source, Walks<T>& walks,
             tally::BatchTally& tally)
      : world_(world), samples_(samples), source_(source), walks_(walks), tally_(tally) {}

  /// Takes so many to their ends.
  PHOTIC_FLATTEN void trace(std::size_t count) {
    std::size_t begun = 0;
    WalkSteps steps(world_, samples_, source_, walks_, tally_);
    const auto each = [this](auto stage) { stage(walker_); };
    for (walker_.on = Mask<T>(false);;) {
      for (Mask<T> free = !walker_.on; any(free); free = !walker_.on) {
        if (waiting_ == 0) {
          if (begun >= count) break;
          births(begun, count - begun);
          begun += lanes;
        } else {
          walker_.on = walker_.on | take_from_queue(free);
        }
      }
      if (!any(walker_.on)) return;
      flights(steps, each);
      collisions(steps, each);
    }
  }

 private:
  static constexpr std::size_t lanes = lanes_of<T>;

  /// The next walks, as many as there are lanes.
  void births(std::size_t first, std::size_t left) {
    const Mask<T> exist = first_lanes<T>(left);
    WalkTrack<T> track;
    // Lanes without a walk draw the numbers of another: beyond the batch there are none.
    track.walk = select(exist, Index<T>(first) + lane_numbers<T>(), Index<T>(first));
    BirthRecord<T> record;
    WalkRatios<T>* const ratios = walks_.ratios();
    const Index<T> slot = Walks<T>::slot(track.walk, Index<T>(0));
    const auto& sea = world_.slabs;
    if (ratios) ratios->begin(sea, slot, exist);
    const auto met = [&](const Mask<T>& mask, const surface::FacetHit<T>& meeting) {
      if (ratios) ratios->met(sea, meeting, slot, Mask<T>(mask & exist));
    };
    const auto flown = [&](const Mask<T>& mask, const geometry::Segment<T>& way) {
      if (ratios) ratios->flown(sea, way, slot, Mask<T>(mask & exist));
    };
    const auto birth = source_.birth(track.walk, exist, record, met, flown);
    if (ratios)
      ratios->came_down(
          sea, world_.instruments.region(source_.instrument()), birth.photon.line,
          walks_.has_facets() ? T(T(0) - birth.entry.outside.z) : birth.spread.cos_air, slot,
          exist);
    const Mask<T> born = exist & birth.exists;
    track.photon = birth.photon;
    record.spread = birth.spread;
    record.facets = birth.facets;
    // Walks that do not set out still have a point of the lens.
    const Mask<T> left_out = exist & source_.left_out(birth);
    walks_.birth(born | left_out, track.walk, record, {walk_point(birth.photon)});
    walks_.leave_out(left_out, track.walk);
    if (walks_.has_facets()) walks_.enter(born | left_out, track.walk, birth.entry);
    waiting_columns_.each(
        track, [&](const auto& member, auto* column) { compress(born, member, column); });
    waiting_ = count(born);
    taken_ = 0;
  }
  /// Gives free lanes to walks that wait. Returns the lanes given.
  Mask<T> take_from_queue(const Mask<T>& free) {
    std::uint32_t given = 0;
    std::size_t n = 0;
    for (std::uint32_t left = lane_bits(free); left != 0 && n < waiting_; left &= left - 1, ++n)
      given |= left & -left;
    const Mask<T> mask = mask_of_bits<T>(given);
    waiting_columns_.each(
        walker_, [&](auto& member, const auto* column) { expand(mask, column + taken_, member); });
    walker_.event = select(mask, Index<T>(0), walker_.event);
    walker_.vertices = select(mask, Index<T>(0), walker_.vertices);
    lanes::assign<T>(mask, Ray<T>{walk_point(walker_.photon)}, walker_.ray);
    walker_.leg = select(mask, Leg<T>{}, walker_.leg);
    walker_.axis.exists = walker_.axis.exists & !mask;
    taken_ += n;
    waiting_ -= n;
    return mask;
  }

  const World<T>& world_;
  const Samples<T>& samples_;
  Source& source_;
  Walks<T>& walks_;
  tally::BatchTally& tally_;
  WalkTrack<T> walker_;

  /// Walks that have begun without a lane; readable for as many more.
  lanes::LaneColumns<T, WalkTrack<T>, 2 * lanes> waiting_columns_;
  std::size_t waiting_ = 0, taken_ = 0;
};

}  // namespace photic::estimator
