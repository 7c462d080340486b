// The walks of the bidirectional estimator, kept until they are connected.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "estimator/bidirectional/birth.hpp"
#include "estimator/bidirectional/facet_records.hpp"
#include "estimator/bidirectional/first_vertex.hpp"
#include "estimator/bidirectional/meet.hpp"
#include "estimator/bidirectional/vertex.hpp"
#include "estimator/bidirectional/walk_ratios.hpp"
#include "estimator/bidirectional/walk_records.hpp"
#include "estimator/world.hpp"
#include "lanes/records.hpp"
#include "transport/touched.hpp"

namespace photic::estimator {

/// The rays and vertices of walks from one instrument: ray m leads to vertex m, and ray 0 from the
/// instrument.
template <class T>
class Walks {
 public:
  using Ray = estimator::Ray<T>;
  using Vertex = estimator::Vertex<T>;

  /// `through_surface`: the instrument is in the air, over a flat surface.
  Walks(std::size_t walks, bool from_telescope, bool through_surface, const medium::MediumView& sea)
      : from_telescope_(from_telescope),
        through_surface_(through_surface),
        facets_have_sides_(!sea.surface.isotropic),
        record_(walks),
        ray_(walks * stride),
        vertex_(walks * stride),
        pivot_(walks),
        near_first_(walks),
        free_area_(walks),
        rotated_first_(walks),
        rays_(walks),
        vertices_(walks),
        pivot_vertex_(walks),
        connected_(walks),
        own_(walks),
        telescope_(walks),
        line_(walks),
        first_on_bed_(sea.bed_angles > 0 ? walks : 0) {
    if (sea.environments.count > 0) ratios_.emplace(sea, walks * stride);
    if (!sea.surface.one_direction_each)
      facets_ = std::make_unique<FacetRecords<T>>(walks, walks * stride,
                                                  from_telescope && facets_have_sides_);
  }

  // Written by walkers, in the lanes of a mask.
  void birth(const Mask<T>& mask, const Index<T>& walk, const BirthRecord<T>& record,
             const Ray& first) {
    record_.put(mask, walk, record);
    scatter(mask, walk, record.connected, connected_.data());
    scatter(mask, walk, select(record.own, Index<T>(1), Index<T>(0)), own_.data());
    scatter(mask, walk, record.telescope, telescope_.data());
    scatter(mask, walk, record.line, line_.data());
    scatter(mask, walk, Index<T>(0), vertices_.data());
    scatter(mask, walk, Index<T>(-1), pivot_vertex_.data());
    begin_beyond(mask, walk);
    if (!first_on_bed_.empty()) scatter(mask, walk, Index<T>(max_vertices), first_on_bed_.data());
    if (facets_) scatter(mask, walk, record.facets, facets_->sent_down.data());
    add(mask, walk, Index<T>(0), first);
  }
  /// Notes that the walks of a mask come through waves.
  void enter(const Mask<T>& mask, const Index<T>& walk, const SurfaceEntry<T>& entry) {
    facets_->entry.put(mask, walk, entry);
  }
  /// Notes that the walks of a mask do not set out.
  void leave_out(const Mask<T>& mask, const Index<T>& walk) {
    scatter(mask, walk, Index<T>(0), rays_.data());
    scatter(mask, walk, Index<T>(0), vertices_.data());
  }
  void add(const Mask<T>& mask, const Index<T>& walk, const Index<T>& m, const Ray& ray) {
    ray_.put(mask, slot(walk, m), ray);
    scatter(mask, walk, m + Index<T>(1), rays_.data());
    if (facets_) scatter(mask, slot(walk, m), Index<T>(0), facets_->sent_back.data());
  }
  /// Facets of waves have sent ray m back, which goes on so.
  void send_back(const Mask<T>& mask, const Index<T>& walk, const Index<T>& m, const Ray& behind) {
    facets_->behind.put(mask, slot(walk, m), behind);
    scatter(mask, slot(walk, m), Index<T>(1), facets_->sent_back.data());
    if (keeps_beyond()) scatter(mask & rotates(walk, m), walk, m, facets_->beyond.data());
  }
  void add(const Mask<T>& mask, const Index<T>& walk, const Index<T>& i, const Vertex& vertex) {
    vertex_.put(mask, slot(walk, i), vertex);
    scatter(mask, walk, i + Index<T>(1), vertices_.data());
  }
  /// `frees`: there are free walks.
  void keep(const Mask<T>& mask, const Index<T>& walk, const FirstVertex<T>& first, bool frees) {
    near_first_.put(mask, walk, first.near);
    if (frees) free_area_.put(mask, walk, first.free);
    if (!from_telescope_) rotated_first_.put(mask, walk, first.rotated);
  }
  /// Vertex i, where walks of a mask stand, is on the bed.
  void come_to_bed(const Mask<T>& mask, const Index<T>& walk, const Index<T>& i) {
    if (!any(mask)) return;
    const Index<T> first = gather_index<T>(first_on_bed_.data(), walk);
    scatter(mask & (i < first), walk, i, first_on_bed_.data());
  }
  /// Notes all that telescopes' walks, which leave vertex i by a ray, need to be rotated about it,
  /// if they may be. `of_elastic_light`: also where they scatter the laser's light first. Returns
  /// which may.
  Mask<T> pivot(const medium::MediumView& sea, const Mask<T>& mask, const Index<T>& walk,
                const Index<T>& i, const Vertex& vertex, const Ray& ray, bool of_elastic_light) {
    const Mask<T> first = i == Index<T>(0);
    const Mask<T> converts = mask & (vertex.line > ray.line);
    const Mask<T> scatters = mask & first & (vertex.line == Index<T>(0)) &
                             Mask<T>(of_elastic_light) &
                             leads_aside(vertex.direction, ray.direction);
    const Mask<T> pivots = converts | scatters;
    begin_beyond((mask & first) | converts, walk);
    if (any(pivots)) {
      scatter(pivots, walk, i, pivot_vertex_.data());
      pivot_.put(pivots, walk, pivot_at(sea, vertex, ray));
    }
    return pivots;
  }

  /// The walks' weights in environments; none without these.
  [[nodiscard]] WalkRatios<T>* ratios() { return ratios_ ? &*ratios_ : nullptr; }
  /// Product and depth of a walk up to where ray m leaves a vertex, or comes into the water, for
  /// environments from `first` on; `whole_leg`: and of what the surface does to it from there on.
  [[nodiscard]] std::array<T, 2> ratio(const medium::MediumView& sea, std::int32_t walk,
                                       std::int32_t m, bool is_free, bool whole_leg,
                                       std::int32_t first) const {
    const auto slot = [&](std::int32_t ray) {
      return static_cast<std::size_t>(walk) * stride + static_cast<std::size_t>(ray);
    };
    const auto of_ray = [&](std::int32_t ray) { return ratios_->at(slot(ray), first); };
    const auto of_walk = [&] {
      if (m < 2) return of_ray(is_free ? 0 : m);
      if (is_free) return of_ray(m);
      return joined(sea.environments, first, of_ray(1), of_ray(m));
    };
    const bool meets = sea.other_entry() && (m == 0 ? !is_free : whole_leg);
    if (!meets) return of_walk();
    return joined(sea.environments, first, of_walk(), ratios_->at_surface(slot(m), first));
  }
  /// The slot of ray or vertex i of a walk.
  static Index<T> slot(const Index<T>& walk, const Index<T>& i) {
    return walk * Index<T>(stride) + i;
  }
  /// So many bytes does a walk take in environments.
  static std::size_t size(const medium::MediumView& sea) {
    return stride * WalkRatios<T>::size(sea);
  }

  [[nodiscard]] bool from_telescope() const { return from_telescope_; }
  [[nodiscard]] bool through_surface() const { return through_surface_; }
  /// Returns whether facets of the surface send light on.
  [[nodiscard]] bool has_facets() const { return facets_ != nullptr; }

  // Values of one walk.
  [[nodiscard]] std::int32_t rays(std::size_t walk) const { return rays_[walk]; }
  [[nodiscard]] std::int32_t vertices(std::size_t walk) const { return vertices_[walk]; }
  /// The vertex about which a telescope's walk may be rotated, or -1.
  [[nodiscard]] std::int32_t pivot_vertex(std::size_t walk) const { return pivot_vertex_[walk]; }
  [[nodiscard]] bool connected(std::size_t walk) const { return connected_[walk] != 0; }
  /// Returns whether its ray is one of its instrument's own.
  [[nodiscard]] bool is_own(std::size_t walk) const { return own_[walk] != 0; }

  // Values of one walk, in all lanes.
  [[nodiscard]] BirthRecord<T> birth_record_in_all_lanes(std::size_t walk) const {
    return record_.in_all_lanes(walk);
  }
  [[nodiscard]] Ray ray_in_all_lanes(std::size_t walk, std::int32_t m) const {
    return ray_.in_all_lanes(walk * stride + static_cast<std::size_t>(m));
  }
  /// Returns whether facets have sent ray m back, and that ray behind them.
  [[nodiscard]] bool is_sent_back(std::size_t walk, std::int32_t m) const {
    return facets_->sent_back[walk * stride + static_cast<std::size_t>(m)] != 0;
  }
  [[nodiscard]] Ray behind_facets_in_all_lanes(std::size_t walk, std::int32_t m) const {
    return facets_->behind.in_all_lanes(walk * stride + static_cast<std::size_t>(m));
  }
  [[nodiscard]] Vertex vertex_in_all_lanes(std::size_t walk, std::int32_t i) const {
    return vertex_.in_all_lanes(walk * stride + static_cast<std::size_t>(i));
  }

  // Values of one walk in each lane.
  [[nodiscard]] BirthRecord<T> birth_record(const Index<T>& walk) const {
    BirthRecord<T> record = record_.at(walk);
    record.spread.through_surface = through_surface_;
    return record;
  }
  /// BirthRecord::facets.
  [[nodiscard]] Index<T> facets(const Index<T>& walk) const {
    return facets_ ? gather_index<T>(facets_->sent_down.data(), walk) : Index<T>(0);
  }
  /// Its entry through waves.
  [[nodiscard]] SurfaceEntry<T> entry(const Index<T>& walk) const {
    return facets_->entry.at(walk);
  }
  [[nodiscard]] Ray ray(const Index<T>& walk, const Index<T>& m) const {
    return ray_.at(slot(walk, m));
  }
  [[nodiscard]] Mask<T> is_sent_back(const Index<T>& walk, const Index<T>& m) const {
    return gather_index<T>(facets_->sent_back.data(), slot(walk, m)) == Index<T>(1);
  }
  [[nodiscard]] Ray behind_facets(const Index<T>& walk, const Index<T>& m) const {
    return facets_->behind.at(slot(walk, m));
  }
  /// Returns whether a telescope's walk beyond its pivot can be rotated as far as where ray m ends,
  /// if it has come there, and be the same light: facets that have sent it back see it turned.
  [[nodiscard]] Mask<T> rotates(const Index<T>& walk, const Index<T>& m) const {
    if (!keeps_beyond()) return Mask<T>(true);
    return m < gather_index<T>(facets_->beyond.data(), walk);
  }
  [[nodiscard]] Vertex vertex(const Index<T>& walk, const Index<T>& i) const {
    return vertex_.at(slot(walk, i));
  }
  [[nodiscard]] Mask<T> is_own(const Index<T>& walk) const {
    return gather_index<T>(own_.data(), walk) == Index<T>(1);
  }
  /// The narrowest telescope that sees the ray of a telescope's walk.
  [[nodiscard]] Index<T> telescope(const Index<T>& walk) const {
    return gather_index<T>(telescope_.data(), walk);
  }
  /// The line of the light that a telescope's walk detects.
  [[nodiscard]] Index<T> line(const Index<T>& walk) const {
    return gather_index<T>(line_.data(), walk);
  }
  /// The places that so many of its vertices touch: a transport::Touched.
  [[nodiscard]] Index<T> touched(const Index<T>& walk, const Index<T>& vertices) const {
    if (first_on_bed_.empty()) return Index<T>(0);
    const Index<T> bed(static_cast<std::int32_t>(transport::Touched::bed));
    return select(gather_index<T>(first_on_bed_.data(), walk) < vertices, bed, Index<T>(0));
  }
  /// About which a telescope's walk may be rotated.
  [[nodiscard]] Pivot<T> pivot(const Index<T>& walk) const { return pivot_.at(walk); }
  /// The vertical axis through that.
  [[nodiscard]] RotationAxis<T> axis(const Index<T>& walk) const {
    const Mask<T> exists = gather_index<T>(pivot_vertex_.data(), walk) >= Index<T>(0);
    if (!any(exists)) return {};
    const Pivot<T> at = pivot(walk);
    return {exists, at.x, at.y};
  }
  // Values at its first vertex.
  [[nodiscard]] NearFirst<T> near_first(const Index<T>& walk) const { return near_first_.at(walk); }
  [[nodiscard]] FreeArea<T> free_area(const Index<T>& walk) const { return free_area_.at(walk); }
  /// The first rotated meeting of a laser's walk.
  [[nodiscard]] RotatedMeeting<T> rotated_first(const Index<T>& walk) const {
    return rotated_first_.at(walk);
  }
  /// Its densities that lie behind ray m, or behind vertex i.
  [[nodiscard]] Complete<T> complete_behind_ray(const Index<T>& m, const Usable<T>& usable) const {
    return {m > Index<T>(0), m > Index<T>(1), m > Index<T>(1), from_telescope_, usable};
  }
  [[nodiscard]] Complete<T> complete_behind_vertex(const Index<T>& i,
                                                   const Usable<T>& usable) const {
    return {i > Index<T>(0), i > Index<T>(1), i > Index<T>(0), from_telescope_, usable};
  }

  /// Vertex i as it is in a path of which perhaps not all strategies can be used.
  [[nodiscard]] Vertex in_path(const Index<T>& walk, const Index<T>& i,
                               const Usable<T>& usable) const {
    Vertex v = vertex(walk, i);
    const Mask<T> whole = usable.all();
    if (all(whole)) return v;
    Densities<T> sum;
    for (Index<T> k(1); any(k <= i); k = k + Index<T>(1))
      add_usable(k <= i, vertex(walk, select(k <= i, k, i)), k, usable, sum);
    v.behind = select(whole, v.behind, sum);
    const Mask<T> connecting = usable.connecting(from_telescope_ ? usable.order - i : i);
    v.arriving_edge = select(whole | connecting, v.arriving_edge, T(0));
    return v;
  }
  /// The densities of rotating a telescope's walk about an axis so that it meets this walk of the
  /// laser, or so that it is met itself, at a vertex before vertex i, over reverse_chance. `first`:
  /// at the first vertex.
  [[nodiscard]] T rotated_before(const Index<T>& walk, const Index<T>& i, const Usable<T>& usable,
                                 const RotationAxis<T>& axis, const T& first) const {
    if (!any(axis.exists)) return T(0);
    T sum = rotated_with(first, walk, Index<T>(1), Index<T>(1) <= i);
    for (Index<T> k(2);; k = k + Index<T>(1)) {
      const Mask<T> before = k <= i;
      if (!any(before)) return sum;
      const T density = vertex(walk, select(before, k, Index<T>(0))).added_rotated.about(axis);
      sum = sum + select(before & usable.meeting(number_in_path(k, usable)), density, T(0));
      sum = rotated_with(sum, walk, k, before);
    }
  }
  /// Ray m as one side of a meeting, in a path whose walks may be moved so. `spread`: of the walk's
  /// first ray; `first`: near the walk's first vertex, as it is in the path; `rest`: by how much
  /// all other densities grow by that; `axis`: in the places of this walk; `rotates_anew`: it is
  /// not that of a telescope's walk as it was drawn; `rotated_first`: of a laser's, if that has
  /// changed.
  [[nodiscard]] Side<T> side(const Ray& ray, const Spread<T>& spread, const Index<T>& walk,
                             const Index<T>& m, const Usable<T>& usable,
                             const PathFreedom<T>& freedom, const RotationAxis<T>& axis,
                             const NearFirst<T>& first, const T& rest = T(1),
                             bool rotates_anew = false,
                             const RotatedMeeting<T>* rotated_first = nullptr) const {
    Side<T> side{ray, m == Index<T>(0), spread};
    side.spread.through_surface = through_surface_;
    const T& near_end = from_telescope_ ? freedom.at_last : freedom.at_first;
    auto others = behind(ray, walk, m, usable);
    if (rotates_anew) others.rotated = rotated_before(walk, m - Index<T>(1), usable, axis, T(0));
    side.behind =
        ray.reverse_chance *
        (rest * others.all(freedom.inner) + complete_behind_ray(m, usable).sum(first, near_end) +
         rotated_behind(walk, m - Index<T>(1), usable, axis, rotated_first));
    const T translations = select(m == Index<T>(1), near_end, freedom.inner);
    side.meeting = select(
        usable.meeting(number_in_path(m, usable)),
        translations * if_reversed(ray.translated, ray.leaving_z()) + ray.rotated.about(axis),
        T(0));
    return side;
  }
  /// The densities behind vertex i, over reverse_chance, in such a path.
  [[nodiscard]] T behind(const Vertex& v, const Index<T>& walk, const Index<T>& i,
                         const Usable<T>& usable, const PathFreedom<T>& freedom,
                         const RotationAxis<T>& axis) const {
    return v.behind.all(freedom.inner) +
           complete_behind_vertex(i, usable).sum(
               near_first(walk), from_telescope_ ? freedom.at_last : freedom.at_first) +
           rotated_behind(walk, i, usable, axis);
  }

 private:
  /// From one walk to the next: odd, or the first vertices of all would want the same few places of
  /// a cache.
  static constexpr std::size_t stride = max_vertices + 1;

  [[nodiscard]] Densities<T> behind(const Ray& ray, const Index<T>& walk, const Index<T>& m,
                                    const Usable<T>& usable) const {
    const Mask<T> first = m == Index<T>(0);
    const Mask<T> whole = usable.all() | first;
    if (all(whole)) return ray.behind;
    auto sum = in_path(walk, select(first, m, m - Index<T>(1)), usable).behind;
    const Mask<T> connecting =
        usable.connecting(number_in_path(m, usable) - Index<T>(from_telescope_ ? 0 : 1));
    sum.edges = sum.edges + select(connecting & (m > Index<T>(2)), ray.last_edge, T(0));
    return select(whole, ray.behind, sum);
  }
  [[nodiscard]] bool keeps_beyond() const { return facets_ && !facets_->beyond.empty(); }
  /// No facets have sent back the walks of a mask beyond their pivots so far.
  void begin_beyond(const Mask<T>& mask, const Index<T>& walk) {
    if (keeps_beyond()) scatter(mask, walk, Index<T>(max_vertices), facets_->beyond.data());
  }
  /// The densities of rotating a telescope's walk to meet a laser's at a vertex before vertex i,
  /// over reverse_chance.
  [[nodiscard]] T rotated_behind(const Index<T>& walk, const Index<T>& i, const Usable<T>& usable,
                                 const RotationAxis<T>& axis,
                                 const RotatedMeeting<T>* anew = nullptr) const {
    if (from_telescope_ || !any(axis.exists)) return T(0);
    const Mask<T> beyond_first = (i > Index<T>(0)) & usable.meeting(Index<T>(1));
    const T first = anew == nullptr ? rotated_first(walk).about(axis) : anew->about(axis);
    return rotated_before(walk, i, usable, axis, select(beyond_first, first, T(0)));
  }
  /// A sum over vertices of a laser's walk, with which its ray k is to be rotated, too.
  [[nodiscard]] T rotated_with(const T& sum, const Index<T>& walk, const Index<T>& k,
                               const Mask<T>& mask) const {
    if (from_telescope_ || !facets_have_sides_) return sum;
    return select(mask & is_sent_back(walk, select(mask, k, Index<T>(0))), T(0), sum);
  }
  /// The vertex of the path that ray m leaves, counted from the laser.
  [[nodiscard]] Index<T> number_in_path(const Index<T>& m, const Usable<T>& usable) const {
    return from_telescope_ ? usable.order + Index<T>(1) - m : m;
  }
  void add_usable(const Mask<T>& mask, const Vertex& v, const Index<T>& m, const Usable<T>& usable,
                  Densities<T>& sum) const {
    const Index<T> x = number_in_path(m, usable);
    const Mask<T> connecting = mask & usable.connecting(x - Index<T>(from_telescope_ ? 0 : 1));
    const Mask<T> meeting = mask & usable.meeting(x);
    // The densities at the first vertex are kept apart.
    sum.edges = sum.edges + select(connecting & (m > Index<T>(2)), v.added.edges, T(0));
    sum.translated = sum.translated + select(meeting & (m > Index<T>(1)), v.added.translated, T(0));
    sum.rotated = sum.rotated + select(meeting, v.added.rotated, T(0));
  }

  bool from_telescope_, through_surface_;
  bool facets_have_sides_;  ///< their effect on light changes if that is rotated
  lanes::Records<T, BirthRecord<T>> record_;
  lanes::Records<T, Ray> ray_;
  lanes::Records<T, Vertex> vertex_;
  lanes::Records<T, Pivot<T>> pivot_;
  lanes::Records<T, NearFirst<T>> near_first_;
  lanes::Records<T, FreeArea<T>> free_area_;
  lanes::Records<T, RotatedMeeting<T>> rotated_first_;
  std::unique_ptr<FacetRecords<T>> facets_;  ///< where facets of the surface send light on
  std::vector<std::int32_t> rays_, vertices_, pivot_vertex_, connected_, own_, telescope_,
      line_;                                ///< of each walk
  std::vector<std::int32_t> first_on_bed_;  ///< of each walk, its first vertex there; none: many
  std::optional<WalkRatios<T>> ratios_;
};

}  // namespace photic::estimator
