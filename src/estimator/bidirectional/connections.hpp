// The connections of telescopes' walks: with the laser, with the laser's walks, and of those with
// the telescope.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/flatten.hpp"
#include "estimator/bidirectional/connection_end.hpp"
#include "estimator/bidirectional/meet.hpp"
#include "estimator/bidirectional/walk.hpp"
#include "geometry/sightline.hpp"
#include "lanes/each_score.hpp"
#include "lanes/give_out.hpp"
#include "lanes/lane_columns.hpp"
#include "lanes/queue.hpp"
#include "tally/batch_tally.hpp"
#include "transport/connect_ray.hpp"
#include "transport/flight.hpp"

namespace photic::estimator {

/// What may be put together: vertex or ray i of a laser's walk and m of a telescope's.
template <class T>
struct Pairing {
  Index<T> laser{}, i{}, back{}, m{};

  template <class F>
  constexpr void each_member(F f) {
    f(laser), f(i), f(back), f(m);
  }
};

template <class T>
Pairing<T> pairing_of(std::size_t laser, const Index<T>& i, std::size_t back, const Index<T>& m) {
  return {Index<T>(laser), i, Index<T>(back), m};
}

/// Rays i and m that may be made to meet, as they are or as the surface has reflected them.
template <class T>
struct RayPairing : Pairing<T> {
  Index<T> reflected{};  ///< 1: the laser's, 2: the telescope's, 3: both

  /// Vertices of the path that they make.
  [[nodiscard]] Index<T> order() const { return Pairing<T>::i + Pairing<T>::m + Index<T>(1); }
  template <class F>
  constexpr void each_member(F f) {
    Pairing<T>::each_member(f);
    f(reflected);
  }
};

/// Rays that meet at a depth if the telescope's walk is rotated.
template <class T>
struct RotatedPairing : RayPairing<T> {
  T depth{};  ///< [m]

  template <class F>
  constexpr void each_member(F f) {
    RayPairing<T>::each_member(f);
    f(depth);
  }
};

/// How telescopes' walks are moved to meet others: translated sideways so that they still come
/// through the lens, or rotated beyond their pivots.
enum class Moves : std::int8_t { translations, rotations, all };

/// Two rays that may be made to meet.
template <class T>
struct RayPair {
  using Ray = estimator::Ray<T>;
  Ray out, back;
  Spread<T> spread;      ///< of the laser's walk
  BirthRecord<T> birth;  ///< of the telescope's walk
  Index<T> rotates{};    ///< 1: it may be rotated about the vertical at ...
  T axis_x{}, axis_y{};
  RayPairing<T> pairing;
  LensLine<T> lens;  ///< where it comes through, if it is translated

  /// About which the telescope's walk may be rotated.
  [[nodiscard]] RotationAxis<T> axis() const { return {rotates == Index<T>(1), axis_x, axis_y}; }
  template <class F>
  constexpr void each_member(F f) {
    out.each_member(f);
    back.each_member(f);
    spread.each_member(f);
    birth.each_member(f);
    f(rotates), f(axis_x), f(axis_y);
    pairing.each_member(f);
    f(lens.at_surface.x), f(lens.at_surface.y), f(lens.per_depth.x), f(lens.per_depth.y);
  }
};

/// A telescope's ray, and the rotation axis of its walk, as they have been moved to meet another.
template <class T>
struct Moved {
  Ray<T> ray;
  RotationAxis<T> axis;
  T gain{1};        ///< new over old value of the phase function at the pivot
  T near_pivot{0};  ///< what all densities behind the ray gain by the pivot's new angle
  T longer{0};      ///< so much longer is its way from the lens [m]
};

/// What a longer way from the lens makes of a telescope's side of a meeting.
template <class T>
struct Longer {
  T gain{1};    ///< of the sample
  T path{};     ///< more of it [m]
  T length{};   ///< of the way, more of it [m]
  T behind{};   ///< what the densities behind the ray gain
  T meeting{};  ///< and that of meeting where it begins, but for what it adds itself
};

/// A telescope's walk's first way in the water.
template <class T>
struct FirstLeg {
  T length{};  ///< [m]
  T steep{};   ///< cosine to the vertical
};

/// A path from the laser to a telescope, and what it scores.
template <class T>
struct FoundPath {
  T value{};                                     ///< expected photons
  T length{};                                    ///< group path [m]
  T last{};                                      ///< depth at which light was last scattered [m]
  Index<T> order{}, of_laser{}, of_telescope{};  ///< vertices: all, and those of the two walks
  Mask<T> met_on_bed{};
};

using tally::Walked;

template <class T>
class Connections {
 public:
  Connections(const World<T>& world, const Receiver<T>& receiver, const Samples<T>& samples,
              const Walks<T>& from_laser, const Walks<T>& from_telescope, tally::BatchTally& tally)
      : world_(world),
        sea_(world.sea),
        telescope_(world.telescopes[receiver.telescope]),
        receiver_(receiver),
        samples_(samples),
        laser_(from_laser),
        back_(from_telescope),
        tally_(tally),
        scores_(receiver.telescope, world.path_to_origin[receiver.telescope]),
        ratios_(static_cast<std::size_t>(world.sea.environments.stride)) {}

  /// The laser's walk with the point of the lens of the telescope's that goes with it: the local
  /// estimate of a single ray.
  void to_telescope(std::size_t walk);
  /// The telescope's walk with the laser.
  void to_laser(std::size_t walk);
  /// Every vertex of the laser's walk with every vertex of the telescope's.
  void between(std::size_t walk);
  /// Every ray of so many walks of the laser with every ray of a telescope's, which is moved so
  /// that they meet.
  void meetings(std::size_t first_laser, std::size_t walks, std::size_t back,
                Moves moves = Moves::all);
  /// What still waits for others to fill a pack.
  void flush();

 private:
  using Vertex = estimator::Vertex<T>;
  using Ray = estimator::Ray<T>;
  using DepthLine = estimator::DepthLine<T>;
  using ConnectionEnd = estimator::ConnectionEnd<T>;
  using VertexQueue = lanes::Queue<T, Pairing<T>>;
  using RayQueue = lanes::Queue<T, RayPairing<T>>;

  template <class Act>
  void each_pair(std::size_t first_laser, std::size_t walks, std::size_t back, Act act);
  std::int32_t list_laser_rays(std::size_t first, std::size_t walks);
  void meetings_on_bed(std::size_t first_laser, std::size_t walks, std::size_t back);
  void translate(const RayPairing<T>& pairing, const Mask<T>& mask, const DepthLine& out_line,
                 const DepthLine& back_line, const AtLens<T>& start);
  Chord<T> chord_of(const DepthLine& out_line, const DepthLine& back_line, const Index<T>& m,
                    const AtLens<T>& start) const;
  Chord<T> tilted_chord(DepthLine out_line, DepthLine back_line, Index<T> m, AtLens<T> start) const;
  void rotate(const RayPairing<T>& pairing, const Mask<T>& mask, const DepthLine& out_line,
              const DepthLine& back_line, const RotationAxis<T>& axis);

  // What is done with the pairings of a mask once they fill a pack.
  void serve_to_telescope(const Pairing<T>& pairing, const Mask<T>& mask);
  void serve_to_laser(const Pairing<T>& pairing, const Mask<T>& mask);
  void serve_between(const Pairing<T>& pairing, const Mask<T>& mask);
  void serve_translated(const RayPairing<T>& pairing, const Mask<T>& mask);
  void serve_met_on_bed(const RayPairing<T>& pairing, const Mask<T>& mask);
  void serve_rotated(const RotatedPairing<T>& pairing, const Mask<T>& mask);

  void by_sightline(const Pairing<T>& pairing, const Mask<T>& mask, const Vertex& v,
                    const BirthRecord<T>& birth, const geometry::Sightline<T>& way);
  void by_sightline_to_laser(const Pairing<T>& pairing, const Mask<T>& mask, const Vertex& w,
                             const geometry::Sightline<T>& way);
  void along(const Pairing<T>& pairing, const Mask<T>& mask, const Index<T>& line,
             const ConnectionEnd& from, const ConnectionEnd& to, const Vertex& v, const Vertex& w,
             const T& length, const Usable<T>& usable);
  RayPair<T> pair_of(const RayPairing<T>& pairing) const;
  Moved<T> translated(const RayPair<T>& pair, const Vec3<T>& translation) const;
  void meet_translated(const RayPair<T>& pair, const Mask<T>& mask, const T& depth,
                       const Index<T>& place);
  void meet_tilted(const RayPair<T>& pair, Mask<T> mask, instrument::PlanePoint<T> lens, T depth,
                   Index<T> place);
  void meet_under_tilted(const RayPair<T>& pair, Mask<T> mask, Moved<T> moved, T depth,
                         Index<T> place);
  [[nodiscard]] Mask<T> can_meet(const RayPair<T>& pair, const Ray& moved, const T& depth) const;
  Longer<T> lengthened(const RayPair<T>& pair, T length) const;
  [[nodiscard]] FirstLeg<T> first_leg(const BirthRecord<T>& birth, const Index<T>& back) const;
  std::array<T, 2> rotate_pivot(RayPair<T>& pair, const Rotation<T>& rotation) const;
  template <bool upright>
  void meet_at(const RayPair<T>& pair, const Mask<T>& mask, const Moved<T>& moved, const T& depth,
               const Index<T>& place);

  [[nodiscard]] Usable<T> usable(const Index<T>& order) const {
    return {order, world_.most_vertices};
  }
  /// Freedom::translations of a walk that may be translated over an area, in paths of an order [m].
  [[nodiscard]] T translations_in(const Index<T>& order, const T& translation_area) const {
    return samples_.translated(order) * translation_area;
  }
  /// The same of meetings before the last vertex of a path, which is at a depth.
  [[nodiscard]] T translations_before(const T& last, const T& translations) const {
    if (!is_aslant(telescope_)) return translations;
    return select(all_points_reach(telescope_, last), translations, T(0));
  }
  [[nodiscard]] Freedom<T> freedom_before(const T& last, const Freedom<T>& freedom) const {
    return {translations_before(last, freedom.translations), freedom.axis};
  }
  /// `birth`: of a walk that detects a line.
  [[nodiscard]] AtLens<T> at_lens(const BirthRecord<T>& birth, const Index<T>& line) const {
    return {birth.lens, birth.outward,
            receiver_.region.in_air ? T(1) : gather<T>(sea_.group_index, line)};
  }
  /// Whether light of the laser's line can leave a layer as light of a line.
  [[nodiscard]] Mask<T> emits(const Index<T>& line, const Index<T>& layer) const {
    return (line == Index<T>(0)) | (gather<T>(sea_.conversion, sea_.at(line, layer)) > T(0));
  }
  /// Whether there is a bed that reflects light within the gates.
  [[nodiscard]] bool comes_to_bed() const {
    return sea_.bed_angles > 0 && all(world_.deepest >= T(sea_.top[sea_.layers]));
  }
  /// The densities behind a vertex of the laser's walk, in a path in which the telescope's walk may
  /// be moved so.
  [[nodiscard]] T behind_laser_vertex(const Pairing<T>& pairing, const Vertex& v,
                                      const Usable<T>& in_path, const Freedom<T>& freedom) const {
    return v.reverse_chance *
           (v.behind.all(freedom.translations) +
            laser_.rotated_before(pairing.laser, pairing.i, in_path, freedom.axis));
  }
  [[nodiscard]] DepthLine depth_line_of(const Ray& ray) const {
    return depth_line(sea_, ray, world_.deepest);
  }
  /// Of a telescope's ray m that may be translated: a first one may then begin elsewhere.
  [[nodiscard]] DepthLine translatable(DepthLine line, const Index<T>& m) const {
    if (!is_aslant(telescope_)) return line;
    const T most = select(m == Index<T>(0), T(2) * telescope_.lens_rise, T(0));
    const T from = line.from - most, to = line.to + most;
    line.from = select(from > T(0), from, T(0));
    line.to = select(to < world_.deepest, to, world_.deepest);
    return line;
  }
  /// Whether paths of an order can still be scored.
  [[nodiscard]] Mask<T> in_order(const Index<T>& order) const {
    return order <= Index<T>(world_.last_order > 0 ? world_.last_order
                                                   : std::numeric_limits<std::int32_t>::max());
  }
  /// Where the light of a telescope's walk was last scattered.
  [[nodiscard]] T last_depth(const Index<T>& back) const {
    return -back_.vertex(back, Index<T>(0)).position.z;
  }
  /// How a telescope's walk may be rotated in paths that convert at a place, or of which that is
  /// the last vertex. Directions are those of the edges there.
  [[nodiscard]] RotationAxis<T> axis_at(const Vec3<T>& place, const Vec3<T>& telescope_edge,
                                        const Vec3<T>& laser_edge) const {
    const Mask<T> scatters =
        world_.rotates_scattered ? leads_aside(telescope_edge, laser_edge) : Mask<T>(false);
    return {Mask<T>((receiver_.line > Index<T>(0)) | scatters), place.x, place.y};
  }
  /// Whether a path's pivot is where light comes upon its telescope's walk of so many vertices, as
  /// of a line there: an emitted line's is converted there, the laser's scattered for the last time
  /// if the walk has no vertex before.
  [[nodiscard]] static Mask<T> is_pivot(const Index<T>& line, const Index<T>& m) {
    return (line > Index<T>(0)) | (m == Index<T>(0));
  }
  // What whole paths, put together of two walks, are in environments.
  void complete_to_telescope(const Pairing<T>& pairing, const Vertex& v,
                             const geometry::Sightline<T>& way);
  void complete_to_laser(const Pairing<T>& pairing, const Vertex& w,
                         const geometry::Sightline<T>& way, const T& length);
  void complete_between(const Pairing<T>& pairing, const Index<T>& line, const Vertex& v,
                        const Vertex& w, const T& length);
  void complete_by_meeting(const RayPair<T>& pair, const Moved<T>& moved, const T& depth,
                           const Index<T>& layer);
  void score_in_environments(Pairing<T> pairing, Walked walked, Mask<T> mask, FoundPath<T> path);

  void score(const Pairing<T>& pairing, Walked walked, const Mask<T>& mask,
             const FoundPath<T>& path) {
    if (world_.compares) [[unlikely]]
      return score_in_environments(pairing, walked, mask, path);
    scores_.push(mask, scores_of(pairing, walked, path), tally_);
  }
  [[nodiscard]] lanes::LaneScores<T> scores_of(const Pairing<T>& pairing, Walked walked,
                                               const FoundPath<T>& path) const {
    Index<T> touched(0);
    if (sea_.bed_angles > 0)
      touched =
          select(path.met_on_bed, Index<T>(static_cast<std::int32_t>(transport::Touched::bed)),
                 laser_.touched(pairing.laser, path.of_laser) |
                     back_.touched(pairing.back, path.of_telescope));
    return {receiver_.telescope,
            world_.path_to_origin[receiver_.telescope],
            transport::light_of<T>(sea_, back_.line(pairing.back), touched),
            path.order,
            path.last,
            path.length,
            path.value,
            walked};
  }

  const World<T>& world_;
  const geometry::Slabs& sea_;
  const instrument::Telescope<T>& telescope_;
  const Receiver<T>& receiver_;
  const Samples<T>& samples_;
  const Walks<T>& laser_;
  const Walks<T>& back_;
  tally::BatchTally& tally_;
  VertexQueue to_telescope_, to_laser_, between_;
  RayQueue translated_, met_on_bed_;
  lanes::Queue<T, RotatedPairing<T>> rotated_;
  std::vector<std::int32_t> walk_of_, ray_of_;  ///< the laser's rays that may meet a telescope's
  lanes::LaneColumns<T, DepthLine, most_vertices + 1 + lanes_of<T>>
      lines_;  ///< of a telescope's walk
  lanes::ScoreQueue<T> scores_;
  Completion<T> completion_;
  std::vector<Element<T>> ratios_;  ///< of one lane, [environment]
};

template <class T>
void Connections<T>::flush() {
  to_telescope_.flush([this](const auto& e, const auto& mask) { serve_to_telescope(e, mask); });
  to_laser_.flush([this](const auto& e, const auto& mask) { serve_to_laser(e, mask); });
  between_.flush([this](const auto& e, const auto& mask) { serve_between(e, mask); });
  translated_.flush([this](const auto& e, const auto& mask) { serve_translated(e, mask); });
  met_on_bed_.flush([this](const auto& e, const auto& mask) { serve_met_on_bed(e, mask); });
  rotated_.flush([this](const auto& e, const auto& mask) { serve_rotated(e, mask); });
  scores_.flush(tally_);
}

}  // namespace photic::estimator

#include "estimator/bidirectional/connect_environments.hpp"  // IWYU pragma: export
#include "estimator/bidirectional/connect_rays.hpp"          // IWYU pragma: export
#include "estimator/bidirectional/connect_tilted.hpp"        // IWYU pragma: export
#include "estimator/bidirectional/connect_vertices.hpp"      // IWYU pragma: export
