// Paths of light with given vertices, and the walks that would have drawn them.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "estimator/bidirectional/connection_end.hpp"
#include "estimator/bidirectional/surface_entry.hpp"
#include "estimator/bidirectional/walk.hpp"
#include "geometry/sightline.hpp"
#include "transport/cross.hpp"
#include "transport/flight.hpp"

namespace photic::estimator {

using V = Vec3<double>;

/// Facets that send light back on an edge.
struct WayByFacets {
  V at;               ///< point of the surface
  double share = 1;   ///< of the light, over the density with which walks of the laser draw them
  double chance = 1;  ///< density with which telescopes' walks do, over that
};

/// Where the light of an instrument in the air comes through waves.
struct Entry {
  V at;                     ///< point of the surface
  double drawn_weight = 0;  ///< of a walk that has drawn its facets there; 0: it goes by one facet
};

/// From the laser's fictitious vertex by x_1 … x_k to a point of telescope 0's lens.
struct Path {
  std::vector<V> vertex;
  instrument::PlanePoint<double> lens;
  std::int32_t line = 0;           ///< in which it is detected
  std::int32_t converted = 0;      ///< the number of the vertex that converts; 0: none
  std::array<bool, 8> mirrored{};  ///< edges by way of the surface
  std::array<std::optional<WayByFacets>, 8> by_facets;  ///< and by way of facets of waves
  std::optional<Entry> laser_entry, telescope_entry;    ///< of instruments above waves

  [[nodiscard]] std::int32_t order() const { return static_cast<std::int32_t>(vertex.size()); }
  /// Vertex i of 1 … k.
  [[nodiscard]] const V& x(std::int32_t i) const { return vertex[static_cast<std::size_t>(i - 1)]; }
  /// The line of edge e of 0 … k.
  [[nodiscard]] std::int32_t line_of(std::int32_t edge) const {
    return edge < converted ? 0 : line;
  }
  /// The vertex about which telescopes' walks may be rotated: where light is converted, else the
  /// last.
  [[nodiscard]] std::int32_t pivot() const { return line > 0 ? converted : order(); }
  [[nodiscard]] bool is_mirrored(std::int32_t edge) const {
    return mirrored[static_cast<std::size_t>(edge)];
  }
  [[nodiscard]] const std::optional<WayByFacets>& facets(std::int32_t edge) const {
    return by_facets[static_cast<std::size_t>(edge)];
  }
};

/// The path with all that is drawn from the telescope beyond the pivot rotated about the vertical
/// through it.
inline Path rotated_path(const Path& path, double angle) {
  Path rotated = path;
  const V& axis = path.x(path.pivot());
  const auto rotate = [&](V& to) {
    const V from = to - axis;
    to.x = axis.x + (std::cos(angle) * from.x - std::sin(angle) * from.y);
    to.y = axis.y + (std::sin(angle) * from.x + std::cos(angle) * from.y);
  };
  for (std::int32_t i = 1; i < path.pivot(); ++i) {
    rotate(rotated.vertex[static_cast<std::size_t>(i - 1)]);
    if (auto& facets = rotated.by_facets[static_cast<std::size_t>(i)]) rotate(facets->at);
  }
  return rotated;
}

/// The direction from one place to another, by way of the surface if it is mirrored.
inline V direction_to(const V& from, const V& to, bool mirrored) {
  return normalised(V{to.x, to.y, mirrored ? -to.z : to.z} - from);
}

inline geometry::Sightline<double> way_to(const World<double>& world, const V& from,
                                          std::int32_t line, const V& to, bool mirrored) {
  const auto route = mirrored ? geometry::Route::mirrored : geometry::Route::direct;
  return geometry::sightline(world.slabs, from, line, to, {to.z >= 0, {}}, route, true);
}
inline geometry::Sightline<double> way_to_laser(const World<double>& world, const Path& path) {
  return way_to(world, path.x(1), 0, fictitious_vertex(world.instruments.laser),
                path.is_mirrored(0));
}
inline geometry::Sightline<double> way_to_lens(const World<double>& world, const Path& path) {
  return way_to(world, path.x(path.order()), path.line,
                in_space(world.instruments.telescopes[0], path.lens),
                path.is_mirrored(path.order()));
}

/// The path translated sideways, with the point of the lens' plane by which its last ray then
/// comes.
inline Path translated_path(const World<double>& world, const Path& path, const V& translation) {
  const auto& telescope = world.instruments.telescopes[0];
  const V outward = -way_to_lens(world, path).arriving;
  const V on_ray = in_space(telescope, path.lens) + translation;
  const V at = on_ray + dot(telescope.position - on_ray, telescope.axis) /
                            dot(outward, telescope.axis) * outward;
  Path other = path;
  for (V& x : other.vertex) x = x + translation;
  for (auto& facets : other.by_facets)
    if (facets) facets->at = facets->at + translation;
  other.lens = {dot(at - telescope.position, telescope.across),
                dot(at - telescope.position, telescope.up)};
  return other;
}

inline bool on_bed(const geometry::Slabs& sea, const V& place) {
  return sea.bed_angles > 0 && place.z == -sea.top[sea.layers];
}

/// Writes a walk along given places as a WalkTracer would have drawn it.
class Writer {
 public:
  Writer(const World<double>& world, const Samples<double>& samples, const Birth<double>& birth,
         BirthRecord<double> record, bool from_telescope)
      : walks(1, from_telescope, birth.spread.through_surface, world.slabs),
        world_(world),
        samples_(samples),
        instrument_(from_telescope ? of_telescope(0) : of_laser),
        photon_(birth.photon),
        spread_(birth.spread),
        ray_{walk_point(photon_)} {
    record.spread = birth.spread;
    record.own = true;
    walks.birth(true, 0, record, ray_);
    if (walks.has_facets()) walks.enter(true, 0, birth.entry);
  }

  void collide_at(const V& place, bool mirrored, const std::optional<WayByFacets>& facets = {}) {
    Leg<double> leg;
    SentBack<double> sent_back;
    if (facets) {
      come_back(*facets, place, leg, sent_back);
    } else if (mirrored) {
      const double rise = -photon_.position.z / photon_.direction.z;
      fly_to(photon_.position + rise * photon_.direction, leg);
      transport::reflect_down(world_.slabs, photon_);
      leg.reflected = true;
    }
    fly_to(place, leg);
    const bool bed = on_bed(world_.slabs, place);
    if (bed)
      photon_.layer = world_.slabs.layers;
    else
      photon_.weight *= world_.slabs.collision_gain[here()];
    const auto& cone = world_.walks.cone(instrument_);
    const std::int32_t before = walks.vertices(0);
    const auto spread = before == 0 && cone.enters_by_slopes ? spread_with_slopes() : spread_;
    if (before == 0) photon_.weight *= cone.over_reach(leg.walk_tau, photon_.direction.z, bed);
    const Arrival<double> arrival{ray_,
                                  leg,
                                  before == 0,
                                  before > 1,
                                  reach_of(world_.slabs, cone, before == 0, photon_, leg),
                                  walks.has_facets() ? &sent_back : nullptr,
                                  walks.rotates(0, before)};
    vertex_ = vertex_on(world_.slabs, arrival, spread, photon_, walks.axis(0), samples_);
    walks.add(true, 0, before, vertex_);
    if (before < 2) {
      first_.arrive(vertex_, arrival, spread, samples_);
      walks.keep(true, 0, first_, true);
    }
    if (bed) walks.come_to_bed(true, 0, walks.vertices(0) - 1);
  }

  /// Comes to facets on its way, and leaves them for a place.
  void come_back(const WayByFacets& facets, const V& place, Leg<double>& leg,
                 SentBack<double>& sent_back) {
    fly_to(facets.at, leg);
    photon_.direction = normalised(place - facets.at);
    photon_.weight *= facets.share;
    (walks.from_telescope() ? sent_back.chance : sent_back.reverse_chance) = facets.chance;
    sent_back.walk_tau = leg.walk_tau;
    leg.reflected = true;
    walks.send_back(true, 0, walks.rays(0) - 1, behind_facets(ray_, photon_, sent_back));
  }
  void come_back(const WayByFacets& facets, const V& place) {
    Leg<double> leg;
    SentBack<double> sent_back;
    come_back(facets, place, leg, sent_back);
  }

  /// Goes on towards the next place. Only a telescope's walk `converts`.
  void leave_for(const V& next, bool mirrored, bool converts,
                 const std::optional<WayByFacets>& facets = {}) {
    const V old = photon_.direction;
    photon_.direction = facets ? normalised(facets->at - photon_.position)
                               : direction_to(photon_.position, next, mirrored);
    Departure<double> departure;
    const double p = transport::scattered_density(
        world_.slabs, photon_.layer,
        converts ? world_.slabs.conversion_phase[photon_.line] : world_.slabs.elastic_phase[here()],
        old, photon_.direction);
    const double chance = world_.walks.inverse_conversion.chance(
        world_.slabs, photon_.line, photon_.layer, walks.vertices(0) - 1);
    departure.p = p;
    departure.chance = 1 - chance;
    departure.c_ratio = photon_.line > 0 ? 0 : 1;
    if (converts) {
      departure.chance =
          chance * world_.walks.inverse_conversion.over_phase(world_.slabs, photon_.direction, p);
      departure.c_ratio = walk_c_ratio<double>(world_.slabs, photon_.line, photon_.layer);
      photon_.weight *= conversion_per_emitted_c<double>(world_.slabs, photon_.line, photon_.layer);
      photon_.line = 0;
    } else {
      const double laser_side = walks.from_telescope() ? photon_.direction.z : -old.z;
      photon_.weight *=
          transport::scattered_share(world_.slabs, photon_.line, photon_.layer, laser_side);
      const auto drawn = [&](const V& direction) {
        return world_.walks.inverse_conversion.scattered_over_phase(world_.slabs, photon_.layer,
                                                                    direction, p);
      };
      if (!walks.from_telescope()) departure.reverse_chance = drawn(-old);
      if (walks.from_telescope() && photon_.line == 0) departure.chance *= drawn(photon_.direction);
    }
    photon_.layer = world_.slabs.layer_of<double>(photon_.layer);
    const std::int32_t left = walks.vertices(0);
    ray_ = next_ray(world_.slabs, photon_, vertex_, departure, left > 2);
    walks.add(true, 0, left, ray_);
    if (left < 3) {
      first_.depart(ray_,
                    averaged_over_drawn(world_, instrument_, vertex_.line, vertex_.layer, !converts,
                                        vertex_.direction.z, photon_.direction, p),
                    left == 1);
      walks.keep(true, 0, first_, true);
    }
    if (walks.from_telescope())
      walks.pivot(world_.slabs, true, 0, walks.vertices(0) - 1, vertex_, ray_,
                  world_.walks.uses.rotated_scattered);
  }

  Walks<double> walks;

 private:
  [[nodiscard]] std::int32_t here() const { return world_.slabs.at(photon_.line, photon_.layer); }

  /// The first vertex may also be connected by entries that slopes draw.
  [[nodiscard]] Spread<double> spread_with_slopes() const {
    return spread_by_entries(slopes_over_rays(world_, instrument_, photon_.line, photon_.position,
                                              walks.entry(0), walks.birth_record(0).lens, true),
                             spread_);
  }
  void fly_to(const V& place, Leg<double>& leg) {
    const auto before = photon_;
    const double distance = length(place - before.position);
    photon_.position = place;
    photon_.layer = world_.slabs.layer_at(before.layer, -place.z);
    const auto from = geometry::level_of(world_.slabs, before);
    photon_.path += geometry::group_path(
        world_.slabs, geometry::Segment<double>{
                          photon_.line, from, geometry::level_of(world_.slabs, photon_), distance});
    photon_.weight *= std::exp(-world_.slabs.continuous_slant_optical_depth(
        photon_.line, from, world_.slabs.continuous_column(photon_.line, from),
        geometry::level_of(world_.slabs, photon_), distance));
    add_flight(world_.slabs, before, photon_, distance, leg);
  }

  const World<double>& world_;
  const Samples<double>& samples_;
  std::int32_t instrument_;
  transport::Photon<double> photon_;
  Spread<double> spread_;
  Ray<double> ray_;
  Vertex<double> vertex_;
  FirstVertex<double> first_;
};

/// The ray in which a walk of a path leaves its instrument. `way`: to it from the first vertex.
inline EntryRay<double> entry_ray_of(const World<double>& world, std::int32_t instrument,
                                     std::int32_t line, const geometry::Sightline<double>& way) {
  const auto& cone = world.walks.cone(instrument);
  const double n = world.slabs.index[line];
  if (cone.even_outside)
    return entry_ray_outside(cone, n, -way.arriving, -way.arriving - cone.outside);
  const V direction = cone.begins_outside ? -way.direction : -way.arriving;
  return entry_ray(cone, n, double(world.slabs.index[0]), direction, direction - cone.axis);
}

/// A walk of the laser that has begun, with the first vertices of a path, and on its way to the
/// next if it `leaves`.
inline Walks<double> laser_walk(const World<double>& world, const Samples<double>& samples,
                                const Birth<double>& birth, const Path& path, std::int32_t vertices,
                                bool leaves) {
  Writer writer(world, samples, birth, {}, false);
  for (std::int32_t i = 1; i <= vertices; ++i) {
    writer.collide_at(path.x(i), path.is_mirrored(i - 1), path.facets(i - 1));
    if (i < vertices || leaves)
      writer.leave_for(path.x(i + 1), path.is_mirrored(i), false, path.facets(i));
  }
  if (leaves && path.facets(vertices))
    writer.come_back(*path.facets(vertices), path.x(vertices + 1));
  return std::move(writer.walks);
}
/// One that comes to the path's first vertex.
inline Walks<double> laser_walk(const World<double>& world, const Samples<double>& samples,
                                const Path& path, std::int32_t vertices, bool leaves) {
  const auto& laser = world.instruments.laser;
  const auto way = way_to_laser(world, path);
  auto birth = birth_at_laser(world.slabs, laser, world.instruments.laser_region,
                              world.walks.laser_cone, entry_ray_of(world, of_laser, 0, way));
  if (laser.collimated) {
    birth =
        birth_at_collimated_laser(world.slabs, laser, world.instruments.laser_region,
                                  world.walks.laser_cone, double(world.slabs.index[0]), 0.0, 0.0);
    birth.photon.position = {path.x(1).x, path.x(1).y, birth.photon.position.z};
  }
  return laser_walk(world, samples, birth, path, vertices, leaves);
}

/// A walk of the telescope that has begun, with the last vertices of a path, and on its way to the
/// next if it `leaves`.
inline Walks<double> telescope_walk(const World<double>& world, const Samples<double>& samples,
                                    const Birth<double>& birth, const BirthRecord<double>& record,
                                    const Path& path, std::int32_t vertices, bool leaves) {
  Writer writer(world, samples, birth, record, true);
  const std::int32_t k = path.order();
  for (std::int32_t i = k; i > k - vertices; --i) {
    writer.collide_at(path.x(i), path.is_mirrored(i), path.facets(i));
    if (i > k - vertices + 1 || leaves)
      writer.leave_for(path.x(i - 1), path.is_mirrored(i - 1), i == path.converted,
                       path.facets(i - 1));
  }
  if (leaves && path.facets(k - vertices))
    writer.come_back(*path.facets(k - vertices), path.x(k - vertices));
  return std::move(writer.walks);
}
/// One that comes from the path's last vertex, and meets others at a grid's depths from
/// `grid_offset` on.
inline Walks<double> telescope_walk(const World<double>& world, const Samples<double>& samples,
                                    const Path& path, std::int32_t vertices, bool leaves,
                                    double grid_offset = 0) {
  const auto& telescope = world.instruments.telescopes[0];
  const auto way = way_to_lens(world, path);
  BirthRecord<double> record;
  record.lens = path.lens;
  record.outward = -way.arriving;
  record.translation_area = translation_area(telescope, record.outward);
  record.grid_offset = grid_offset;
  record.line = path.line;
  return telescope_walk(
      world, samples,
      birth_at_telescope(world.slabs, telescope, world.instruments.telescope_region[0],
                         world.walks.telescope_cones[0],
                         entry_ray_of(world, of_telescope(0), path.line, way), path.line,
                         path.lens),
      record, path, vertices, leaves);
}

}  // namespace photic::estimator
