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
#include "estimator/bidirectional/pairings.hpp"
#include "estimator/bidirectional/walk.hpp"
#include "estimator/event.hpp"
#include "geometry/sightline.hpp"
#include "lanes/each_score.hpp"
#include "lanes/give_out.hpp"
#include "lanes/lane_columns.hpp"
#include "lanes/queue.hpp"
#include "tally/batch_tally.hpp"
#include "transport/connect_ray.hpp"
#include "transport/connect_waves.hpp"
#include "transport/flight.hpp"

namespace photic::estimator {

template <class T>
struct FreeStart;
template <class T>
struct EntryEdge;

using tally::Technique;

template <class T>
class Connections {
 public:
  Connections(const World<T>& world, const Receiver<T>& receiver, const Samples<T>& samples,
              const Walks<T>& from_laser, const Walks<T>& from_telescope, tally::BatchTally& tally)
      : world_(world),
        sea_(world.slabs),
        telescope_(world.instruments.telescopes[receiver.telescope]),
        group_(world.instruments.groups[receiver.group]),
        receiver_(receiver),
        samples_(samples),
        laser_(from_laser),
        back_(from_telescope),
        tally_(tally),
        scores_(receiver.telescope, world.instruments.path_to_origin[receiver.telescope],
                !world.instruments.groups[receiver.group].narrower.empty()),
        ratios_(static_cast<std::size_t>(world.slabs.environments.stride)) {}

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
  /// Scores the pairings that still wait for others to fill a pack.
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

  // The work on the pairings of a mask once they fill a pack.
  void serve_to_telescope(const Pairing<T>& pairing, const Mask<T>& mask);
  void serve_to_laser(const Pairing<T>& pairing, const Mask<T>& mask);
  void serve_between(const Pairing<T>& pairing, const Mask<T>& mask);
  void serve_translated(const RayPairing<T>& pairing, const Mask<T>& mask);
  void serve_met_on_bed(const RayPairing<T>& pairing, const Mask<T>& mask);
  void serve_rotated(const PlacedPairing<T>& pairing, const Mask<T>& mask);
  void serve_free_telescope(FreePairing<T> pairing, Mask<T> mask);
  void serve_free_laser(FreePairing<T> pairing, Mask<T> mask);

  [[nodiscard]] Mask<T> comes_by_surface(const Vertex& first, const T& leaves_z) const;
  [[nodiscard]] FreeStart<T> free_telescope_start(std::size_t back) const;
  [[nodiscard]] FreeStart<T> free_laser_start(const Index<T>& laser) const;
  template <class Push>
  void free_meetings(const RayPairing<T>& pairing, const Mask<T>& mask, const Mask<T>& meet,
                     const DepthLine& out_line, const DepthLine& back_line,
                     const FreeStart<T>& start, const T& sign, const MeetingGrid<T>& grid,
                     const T& offset, Push push);
  [[nodiscard]] Vec3<T> apart(const RayPair<T>& pair, const T& depth) const;
  [[nodiscard]] T collision_gain(const Vertex& first) const;
  void meet_free(const FreePairing<T>& pairing, const Mask<T>& mask, const Met<T>& met);
  void free_telescope_by(const FreePairing<T>& pairing, const RayPair<T>& pair, const Vertex& first,
                         const Vec3<T>& moved, const geometry::Sightline<T>& way,
                         const EdgeToTelescope<T>& edge);
  void free_laser_by(const FreePairing<T>& pairing, const RayPair<T>& pair, const Vertex& first,
                     const Vec3<T>& moved, const geometry::Sightline<T>& way,
                     const WayToLaser<T>& to_laser);
  [[nodiscard]] Mask<T> may_be_free(const Walks<T>& walks, std::int32_t instrument,
                                    const Index<T>& walk) const;
  static void put_first(const T& footprint, const T& freed, NearFirst<T>& near, FreeArea<T>& free);

  [[nodiscard]] EdgeToTelescope<T> edge_to_telescope(const Mask<T>& mask, const Vec3<T>& from,
                                                     const Index<T>& place,
                                                     const instrument::PlanePoint<T>& lens,
                                                     const Index<T>& line,
                                                     const geometry::Sightline<T>& way) const;
  [[nodiscard]] EdgeToTelescope<T> edge_to_telescope(const Mask<T>& mask, const EntryEdge<T>& entry,
                                                     const Index<T>& line,
                                                     const medium::Level<T>& from,
                                                     const instrument::PlanePoint<T>& lens) const;
  void score_to_telescope(const Pairing<T>& pairing, const Vertex& v,
                          const geometry::Sightline<T>& way, const EdgeToTelescope<T>& edge);
  void score_by_facet(Pairing<T> pairing, const Vertex& v, instrument::PlanePoint<T> lens,
                      Mask<T> mask);
  void score_to_laser(const Pairing<T>& pairing, const Vertex& w, const geometry::Sightline<T>& way,
                      const WayToLaser<T>& to_laser);
  void along(const Pairing<T>& pairing, const Mask<T>& mask, const Index<T>& line,
             const ConnectionEnd& from, const ConnectionEnd& to, const Vertex& v, const Vertex& w,
             const T& length, const Usable<T>& usable);
  WayToLaser<T> way_to_laser(const Mask<T>& mask, const Vec3<T>& from, const Index<T>& place,
                             const geometry::Sightline<T>& way) const;
  WayToLaser<T> way_to_laser(const Mask<T>& mask, const Vec3<T>& from, const Index<T>& place,
                             const geometry::Sightline<T>& way, const EntryEdge<T>& entry) const;
  RayPair<T> pair_of(const RayPairing<T>& pairing) const;
  Met<T> met(const RayPair<T>& pair) const;
  void translate(Met<T>& met, const Vec3<T>& translation) const;
  /// The entry of a telescope's walk, where that is now.
  [[nodiscard]] SurfaceEntry<T> entry_of(const Index<T>& back, const Met<T>& met) const {
    auto entry = back_.entry(back);
    entry.at = entry.at + Vec3<T>{met.moved.x, met.moved.y, T(0)};
    return entry;
  }
  void meet_translated(const RayPair<T>& pair, const Mask<T>& mask, const T& depth,
                       const Index<T>& place);
  void meet_tilted(const RayPair<T>& pair, Mask<T> mask, instrument::PlanePoint<T> lens,
                   Index<T> telescope, T depth, Index<T> place);
  [[nodiscard]] Mask<T> can_meet(const RayPair<T>& pair, const Ray& moved, const T& depth) const;
  void lengthen_to_entry(const RayPairing<T>& pairing, const Mask<T>& first, Met<T>& met) const;
  void lengthen(const RayPairing<T>& pairing, const BirthRecord<T>& birth, T length, Ray& back,
                Met<T>& met) const;
  [[nodiscard]] FirstLeg<T> first_leg(const BirthRecord<T>& birth, const Index<T>& back) const;
  void rotate_pivot(const RayPairing<T>& pairing, const Rotation<T>& rotation, Ray& back,
                    Met<T>& met) const;
  static void change_first(const Mask<T>& only, const T& per_p, const T& chance, Ray& ray,
                           NearFirst<T>& near, FreeArea<T>& free);
  [[nodiscard]] MeetingPoint<T> meeting_point(const Met<T>& met, const Mask<T>& first,
                                              const Mask<T>& last, const T& depth,
                                              const Index<T>& place, const T& p) const;
  [[nodiscard]] PathFreedom<T> freedom_at(const RayPairing<T>& pairing, const Met<T>& met,
                                          const MeetingPoint<T>& at, const T& last,
                                          const Index<T>& place) const;
  void meet_at(const RayPairing<T>& pairing, const Mask<T>& mask, const Met<T>& met, const T& depth,
               const Index<T>& place);
  void meet_under_waves(const RayPairing<T>& pairing, const Mask<T>& mask, Met<T> met,
                        const T& depth, const Index<T>& place, const T& contribution);
  void meet_there(const RayPairing<T>& pairing, const Mask<T>& mask, const Met<T>& met,
                  const T& depth, const Index<T>& place, const T& contribution);

  [[nodiscard]] Usable<T> usable(const Index<T>& order) const {
    return {order, world_.walks.max_vertices};
  }
  /// The freedom of walks to be moved in paths of an order, whose last vertex is at a depth: by the
  /// lens, whose rays have an area, and by free areas of both walks. Before the last vertex only
  /// walks that all points of the lens can begin are translated.
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
  /// first vertex, at a place, where its rays fill a level area [m^2]. `arriving_z`: of the
  /// direction in which it comes there; `direction`: in which it would go on; `p`: phase function's
  /// value. 0 where that is not asked for.
  [[nodiscard]] T free_area(std::int32_t instrument, const T& footprint, const Index<T>& line,
                            const Index<T>& place, const Mask<T>& scatters, const T& arriving_z,
                            const Vec3<T>& direction, const T& p) const {
    if (!samples_.frees() || !frees(instrument)) return T(0);
    return footprint *
           averaged_over_drawn(world_, instrument, line, place, scatters, arriving_z, direction, p);
  }
  [[nodiscard]] T free_area(const Walks<T>& walks, std::int32_t instrument,
                            const Index<T>& walk) const {
    if (!samples_.frees() || !frees(instrument)) return T(0);
    return walks.free_area(walk).area();
  }
  /// Returns whether an instrument's walks may be free: the depth of their first vertex has to be
  /// drawn whatever the ray.
  [[nodiscard]] bool frees(std::int32_t instrument) const {
    return world_.walks.cone(instrument).by_depth;
  }
  /// Returns whether walks of the laser are of its own light.
  [[nodiscard]] Mask<T> is_lit(const Index<T>& laser) const {
    return world_.walks.laser_cone.exact ? Mask<T>(true) : laser_.is_own(laser);
  }
  /// Returns whether vertices can be connected to an instrument in a region: waves of one direction
  /// lead no ray of it to a given point.
  [[nodiscard]] bool connects(const geometry::Region<T>& region) const {
    return sea_.surface.one_direction_each || sea_.surface.leads_anywhere || !region.outside;
  }
  [[nodiscard]] std::int32_t instrument() const { return of_telescope(receiver_.telescope); }
  /// The places on the bed, where places are asked for.
  [[nodiscard]] Mask<T> on_bed(const Index<T>& place) const {
    return sea_.bed_angles > 0 ? surface::on_bed<T>(sea_, place) : Mask<T>(false);
  }
  /// `birth`: of a walk that detects a line.
  [[nodiscard]] AtLens<T> at_lens(const BirthRecord<T>& birth, const Index<T>& line) const {
    return {birth.lens, birth.outward,
            receiver_.region.outside
                ? T(1)
                : geometry::group_index_in<T>(sea_, line, receiver_.region.layer)};
  }
  /// Returns whether light of the laser's line can leave a layer as light of a line.
  [[nodiscard]] Mask<T> emits(const Index<T>& line, const Index<T>& layer) const {
    return (line == Index<T>(0)) | (gather<T>(sea_.conversion, sea_.at(line, layer)) > T(0));
  }
  /// Returns whether rays m of a telescope's walk meet the laser's where light is converted.
  [[nodiscard]] Mask<T> converts(std::size_t back, const Index<T>& m) const {
    if (!any(back_.line(Index<T>(back)) > Index<T>(0))) return Mask<T>(false);
    const std::int32_t last = back_.pivot_vertex(back);  // it converts there
    return last < 0 ? Mask<T>(true) : m <= Index<T>(last);
  }
  /// Returns whether a path's light was scattered once and comes by one facet to a telescope in the
  /// water: score_by_facet() has that.
  [[nodiscard]] Mask<T> is_scored_by_facet(const Pairing<T>& pairing) const {
    return (pairing.i + pairing.m == Index<T>(0)) & (back_.facets(pairing.back) == Index<T>(1));
  }
  /// Returns whether there is a bed that reflects light within the gates.
  [[nodiscard]] bool comes_to_bed() const {
    return sea_.bed_angles > 0 && all(world_.walks.deepest >= T(sea_.top[sea_.layers]));
  }
  /// The densities behind a vertex of the laser's walk, in a path whose walks may be moved so.
  [[nodiscard]] T behind_laser_vertex(const Pairing<T>& pairing, const Vertex& v,
                                      const Usable<T>& in_path, const PathFreedom<T>& freedom,
                                      const RotationAxis<T>& axis) const {
    return v.reverse_chance * laser_.behind(v, pairing.laser, pairing.i, in_path, freedom, axis);
  }
  [[nodiscard]] DepthLine depth_line_of(const Ray& ray) const {
    return depth_line(sea_, ray, world_.walks.deepest);
  }
  /// The line of a telescope's ray m that may be translated: a first one may then begin elsewhere.
  [[nodiscard]] DepthLine translatable(DepthLine line, const Index<T>& m) const {
    if (!is_aslant(telescope_)) return line;
    const T most = select(m == Index<T>(0), T(2) * telescope_.lens_rise, T(0));
    const T from = line.from - most, to = line.to + most;
    line.from = select(from > T(0), from, T(0));
    line.to = select(to < world_.walks.deepest, to, world_.walks.deepest);
    return line;
  }
  /// The narrowest telescope that sees light seen by the one with the widest view.
  [[nodiscard]] Index<T> seen_by(const instrument::Sight<T>& sight) const {
    return group_.narrowest(sight);
  }
  /// The light of a telescope's walk, by its own ray.
  [[nodiscard]] Index<T> seen_by(const Index<T>& back) const {
    return scores_.nested() ? back_.telescope(back)
                            : Index<T>(static_cast<std::int32_t>(receiver_.telescope));
  }
  /// Returns whether paths of an order can still be scored.
  [[nodiscard]] Mask<T> in_order(const Index<T>& order) const {
    return order <= Index<T>(world_.part.last_order > 0 ? world_.part.last_order
                                                        : std::numeric_limits<std::int32_t>::max());
  }
  /// The depth where the light of a telescope's walk was last scattered.
  [[nodiscard]] T last_depth(const Index<T>& back) const {
    return geometry::depth_of(back_.vertex(back, Index<T>(0)).position);
  }
  /// The axis about which a telescope's walk may be rotated in paths that convert at a place, or
  /// that have their last vertex there. Directions are those of the edges there.
  [[nodiscard]] RotationAxis<T> axis_at(const Vec3<T>& place, const Vec3<T>& telescope_edge,
                                        const Vec3<T>& laser_edge) const {
    const Mask<T> scatters = world_.walks.uses.rotated_scattered
                                 ? leads_aside(telescope_edge, laser_edge)
                                 : Mask<T>(false);
    return {Mask<T>((receiver_.line > Index<T>(0)) | scatters), place.x, place.y};
  }
  /// The same in paths whose pivot lies on the telescope's walk, where ray m and all that lies
  /// between are rotated, too. `reflected`: facets have sent that ray back.
  [[nodiscard]] RotationAxis<T> rotated_with(RotationAxis<T> axis, const Pairing<T>& pairing,
                                             const Mask<T>& reflected) const {
    if (sea_.surface.one_direction_each) return axis;
    const Index<T> last = select(reflected, pairing.m, pairing.m - Index<T>(1));
    axis.exists = axis.exists & back_.rotates(pairing.back, last);
    return axis;
  }
  /// Returns whether a path's pivot is where light comes upon its telescope's walk of so many
  /// vertices, as light of a line: an emitted line's light is converted there, the laser's
  /// scattered for the last time if the walk has no vertex before.
  [[nodiscard]] static Mask<T> is_pivot(const Index<T>& line, const Index<T>& m) {
    return (line > Index<T>(0)) | (m == Index<T>(0));
  }
  // The ratios of whole paths, put together of two walks, in environments.
  void complete_to_telescope(const Pairing<T>& pairing, const Vertex& v,
                             const geometry::Sightline<T>& way,
                             const geometry::Segment<T>& in_water);
  void complete_by_facet(const Pairing<T>& pairing, const Vertex& v,
                         const transport::WavesConnection<T>& way);
  void complete_to_laser(const Pairing<T>& pairing, const Vertex& w,
                         const geometry::Sightline<T>& way, const geometry::Segment<T>& in_water);
  void complete_between(const Pairing<T>& pairing, const Vertex& v, const Vertex& w,
                        const geometry::Segment<T>& edge);
  void complete_entry(const Index<T>& line, const geometry::Sightline<T>& way);
  void complete_by_meeting(const RayPairing<T>& pairing, const Met<T>& met, const T& depth,
                           const Index<T>& layer);
  void score_in_environments(Pairing<T> pairing, Technique technique, Mask<T> mask,
                             FoundPath<T> path);

  /// complete() completes the path in environments.
  template <class Complete>
  void score(const Pairing<T>& pairing, Technique technique, const Mask<T>& mask,
             const FoundPath<T>& path, Complete complete) {
    if (world_.has_environments) [[unlikely]] {
      complete();
      return score_in_environments(pairing, technique, mask, path);
    }
    scores_.push(mask, scores_of(pairing, technique, path), tally_);
  }
  [[nodiscard]] lanes::LaneScores<T> scores_of(const Pairing<T>& pairing, Technique technique,
                                               const FoundPath<T>& path) const {
    Index<T> touched(static_cast<std::int32_t>(touched_at_birth(sea_)));
    if (sea_.bed_angles > 0)
      touched =
          select(path.met_on_bed, Index<T>(static_cast<std::int32_t>(transport::Touched::bed)),
                 laser_.touched(pairing.laser, path.of_laser) |
                     back_.touched(pairing.back, path.of_telescope));
    return {path.telescope,
            world_.instruments.path_to_origin[receiver_.telescope],
            transport::component_of<T>(sea_, back_.line(pairing.back), touched),
            path.order,
            transport::signed_depth(sea_, path.last),
            path.length,
            path.value,
            technique};
  }

  const World<T>& world_;
  const geometry::Slabs& sea_;
  const instrument::Telescope<T>& telescope_;  ///< with the widest view
  const ViewGroup<T>& group_;
  const Receiver<T>& receiver_;
  const Samples<T>& samples_;
  const Walks<T>& laser_;
  const Walks<T>& back_;
  tally::BatchTally& tally_;
  VertexQueue to_telescope_, to_laser_, between_;
  RayQueue translated_, met_on_bed_;
  lanes::Queue<T, PlacedPairing<T>> rotated_;
  lanes::Queue<T, FreePairing<T>> free_telescope_, free_laser_;
  std::vector<std::int32_t> walk_of_, ray_of_;  ///< the laser's rays that may meet a telescope's
  lanes::LaneColumns<T, DepthLine, max_vertices + 1 + lanes_of<T>>
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
