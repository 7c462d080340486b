// The connections of telescopes' walks: with the laser, with the laser's walks, and of those with
// the telescope.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
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

/// Rays of which one belongs to a free walk, and the depth where they meet.
template <class T>
struct FreePairing : RayPairing<T> {
  T depth{};       ///< [m]
  Index<T> bed{};  ///< 1: on the bed

  template <class F>
  constexpr void each_member(F f) {
    RayPairing<T>::each_member(f);
    f(depth), f(bed);
  }
};

/// How walks are moved to meet others: a telescope's translated sideways so that it still comes
/// through the lens, or rotated beyond its pivot; or either as a free walk.
enum class Moves : std::int8_t { translations, rotations, free_telescope, free_laser, all };
inline bool includes(Moves asked, Moves one) { return asked == one || asked == Moves::all; }

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

/// Whose walk of a path is a free one.
enum class Free : std::int8_t { none, telescope, laser };

/// The new way between a free walk's first vertex and its instrument.
template <class T>
struct NewLeg {
  Vertex<T> first;
  Ray<T> leaving;    ///< the walk's ray from there
  Vec3<T> arriving;  ///< direction in which the walk now comes there
  geometry::Sightline<T> way;
  T length{};  ///< in the water [m]
};

/// Two rays as they meet, after one of both walks has been moved, and what that makes of the path.
template <class T>
struct Met {
  Free free = Free::none;
  const NewLeg<T>* leg = nullptr;  ///< of a free walk
  Ray<T> out, back;
  Spread<T> out_spread, back_spread;
  FirstVertex<T> out_first, back_first;
  T rest{1};  ///< by how much all other densities behind the telescope's ray grow
  T translation_area{};
  Vec3<T> out_moved{};        ///< from where the laser's walk was drawn; level
  RotationAxis<T> axis;       ///< of the telescope's walk, where it is now
  RotationAxis<T> own_axis;   ///< where it was drawn
  bool rotates_anew = false;  ///< it may be rotated otherwise than it was drawn
  T gain{1};                  ///< of the sample
  T longer{};                 ///< so much longer is the way from a tilted lens [m]
  Index<T> line{};            ///< of the light that comes back
};

/// Where two rays meet.
template <class T>
struct MeetingPoint {
  T length_out{}, length_back{};  ///< of the rays [m]
  T tau{};                        ///< optical depth of both
  T reach_out{}, reach_back{};    ///< chances that walks would come along them
  Mask<T> converts{}, bed{};
  T coefficient{};  ///< of what light does there, over c'
  T p{};            ///< its phase function's value [1/sr]
  T path{};         ///< group path of both walks [m]
};

/// The way from a vertex to the laser.
template <class T>
struct WayToLaser {
  Mask<T> lit{};      ///< it comes to the laser within its cone
  T water{}, path{};  ///< length in the water, and group path as the laser's walks count it [m]
  T tau{}, reach{};   ///< optical depth; chance that a walk of the laser would come along it
  T area{};           ///< across it, of the laser's cone [m^2]
  T weight{};         ///< of a walk of the laser in the water, before it is attenuated
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
  Free free = Free::none;
};

template <class T>
struct FreeStart;

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
  void serve_free_telescope(FreePairing<T> pairing, Mask<T> mask);
  void serve_free_laser(FreePairing<T> pairing, Mask<T> mask);

  [[nodiscard]] Mask<T> comes_by_surface(const Vertex& first, const T& leaves_z) const;
  [[nodiscard]] FreeStart<T> free_telescope_start(std::size_t back) const;
  [[nodiscard]] FreeStart<T> free_laser_start(const Index<T>& laser) const;
  template <class Push>
  void free_meetings(const RayPairing<T>& pairing, const Mask<T>& mask, const DepthLine& out_line,
                     const DepthLine& back_line, const FreeStart<T>& start, const T& sign,
                     const MeetingGrid<T>& grid, const T& offset, Push push);
  [[nodiscard]] Vec3<T> apart(const RayPair<T>& pair, const T& depth) const;
  [[nodiscard]] T collision_gain(const Vertex& first) const;
  void meet_free(const FreePairing<T>& pairing, const Mask<T>& mask, const Met<T>& met);
  void free_telescope_by(const FreePairing<T>& pairing, const Mask<T>& mask, const RayPair<T>& pair,
                         const Vertex& first, const Vec3<T>& moved,
                         const geometry::Sightline<T>& way);
  void free_laser_by(const FreePairing<T>& pairing, const Mask<T>& mask, const RayPair<T>& pair,
                     const Vertex& first, const Vec3<T>& moved, const geometry::Sightline<T>& way);
  void put_first(const T& footprint, FirstVertex<T>& first) const;

  void by_sightline(const Pairing<T>& pairing, const Mask<T>& mask, const Vertex& v,
                    const BirthRecord<T>& birth, const geometry::Sightline<T>& way);
  void by_sightline_to_laser(const Pairing<T>& pairing, const Mask<T>& mask, const Vertex& w,
                             const geometry::Sightline<T>& way);
  void along(const Pairing<T>& pairing, const Mask<T>& mask, const Index<T>& line,
             const ConnectionEnd& from, const ConnectionEnd& to, const Vertex& v, const Vertex& w,
             const T& length, const Usable<T>& usable);
  WayToLaser<T> way_to_laser(const Mask<T>& mask, const Vec3<T>& from, const Index<T>& place,
                             const geometry::Sightline<T>& way) const;
  RayPair<T> pair_of(const RayPairing<T>& pairing) const;
  Met<T> met(const RayPair<T>& pair) const;
  void translate(Met<T>& met, const Vec3<T>& translation) const;
  void meet_translated(const RayPair<T>& pair, const Mask<T>& mask, const T& depth,
                       const Index<T>& place);
  void meet_tilted(const RayPair<T>& pair, Mask<T> mask, instrument::PlanePoint<T> lens, T depth,
                   Index<T> place);
  [[nodiscard]] Mask<T> can_meet(const RayPair<T>& pair, const Ray& moved, const T& depth) const;
  void lengthen(const RayPairing<T>& pairing, const BirthRecord<T>& birth, T length,
                Met<T>& met) const;
  [[nodiscard]] FirstLeg<T> first_leg(const BirthRecord<T>& birth, const Index<T>& back) const;
  void rotate_pivot(const RayPairing<T>& pairing, const Rotation<T>& rotation, Met<T>& met) const;
  void change_first(const Mask<T>& only, const T& per_p, const T& chance, Ray& ray,
                    FirstVertex<T>& first) const;
  [[nodiscard]] MeetingPoint<T> meeting_point(const Met<T>& met, const Mask<T>& first,
                                              const Mask<T>& last, const T& depth,
                                              const Index<T>& place) const;
  [[nodiscard]] PathFreedom<T> freedom_at(const RayPairing<T>& pairing, const Met<T>& met,
                                          const MeetingPoint<T>& at, const T& last,
                                          const Index<T>& place) const;
  void meet_at(const RayPairing<T>& pairing, const Mask<T>& mask, const Met<T>& met, const T& depth,
               const Index<T>& place);

  [[nodiscard]] Usable<T> usable(const Index<T>& order) const {
    return {order, world_.most_vertices};
  }
  /// How far walks may be moved in paths of an order, whose last vertex is at a depth: by the lens,
  /// whose rays have an area, and by free areas of both walks. Before the last vertex only walks
  /// that all points of the lens can begin are translated.
  [[nodiscard]] PathFreedom<T> path_freedom(const Index<T>& order, const T& translation_area,
                                            const T& last, const T& telescope_area,
                                            const T& laser_area) const {
    const T by_lens = samples_.translated(order) * translation_area;
    T before = by_lens;
    if (is_aslant(telescope_)) before = select(all_points_reach(telescope_, last), before, T(0));
    if (!samples_.frees()) return {before, before, by_lens};
    const T of_telescope = samples_.freed(samples_.free_telescope, order) * telescope_area;
    const T of_laser = samples_.freed(samples_.free_laser, order) * laser_area;
    return {before + of_telescope + of_laser, before + of_telescope, by_lens + of_laser};
  }
  /// By how much a free walk of an instrument may be moved if light of a line is scattered at its
  /// first vertex, at a place, where its rays fill a level area [m^2]. `direction`: in which the
  /// walk would go on; `p`: phase function's value. 0 where that is not asked for.
  [[nodiscard]] T free_area(std::int32_t instrument, const T& footprint, const Index<T>& line,
                            const Index<T>& place, const Mask<T>& scatters,
                            const Vec3<T>& direction, const T& p) const {
    if (!samples_.frees() || !frees(instrument)) return T(0);
    return footprint * averaged_over_drawn(world_, instrument, line, place, scatters, direction, p);
  }
  [[nodiscard]] T free_area(const Walks<T>& walks, std::int32_t instrument,
                            const Index<T>& walk) const {
    if (!samples_.frees() || !frees(instrument)) return T(0);
    return walks.first_vertex(walk).free_area();
  }
  /// Whether an instrument's walks may be free: the depth of their first vertex has to be drawn
  /// whatever the ray.
  [[nodiscard]] bool frees(std::int32_t instrument) const {
    return world_.cone(instrument).by_depth;
  }
  /// Whether walks of the laser are of its own light.
  [[nodiscard]] Mask<T> is_lit(const Index<T>& laser) const {
    return world_.laser_cone.exact ? Mask<T>(true) : laser_.is_own(laser);
  }
  [[nodiscard]] std::int32_t instrument() const { return of_telescope(receiver_.telescope); }
  /// Of the bed, where places are asked for.
  [[nodiscard]] Mask<T> on_bed(const Index<T>& place) const {
    return sea_.bed_angles > 0 ? surface::on_bed<T>(sea_, place) : Mask<T>(false);
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
  /// The densities behind a vertex of the laser's walk, in a path whose walks may be moved so.
  [[nodiscard]] T behind_laser_vertex(const Pairing<T>& pairing, const Vertex& v,
                                      const Usable<T>& in_path, const PathFreedom<T>& freedom,
                                      const RotationAxis<T>& axis) const {
    return v.reverse_chance * laser_.behind(v, pairing.laser, pairing.i, in_path, freedom, axis);
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
  void complete_by_meeting(const Met<T>& met, const T& depth, const Index<T>& layer);
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
    return {Index<T>(static_cast<std::int32_t>(receiver_.telescope)),
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
  lanes::Queue<T, FreePairing<T>> free_telescope_, free_laser_;
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
  free_telescope_.flush([this](const auto& e, const auto& m) { serve_free_telescope(e, m); });
  free_laser_.flush([this](const auto& e, const auto& m) { serve_free_laser(e, m); });
  scores_.flush(tally_);
}

}  // namespace photic::estimator

#include "estimator/bidirectional/connect_environments.hpp"  // IWYU pragma: export
#include "estimator/bidirectional/connect_free.hpp"          // IWYU pragma: export
#include "estimator/bidirectional/connect_meeting.hpp"       // IWYU pragma: export
#include "estimator/bidirectional/connect_rays.hpp"          // IWYU pragma: export
#include "estimator/bidirectional/connect_tilted.hpp"        // IWYU pragma: export
#include "estimator/bidirectional/connect_vertices.hpp"      // IWYU pragma: export
