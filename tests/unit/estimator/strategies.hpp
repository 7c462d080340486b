// What every strategy must give for a path, from the sum over all of them as the head of
// estimator/bidirectional/strategy_sums.hpp states it.
#pragma once

#include "unit/estimator/entries.hpp"
#include "unit/estimator/paths.hpp"
#include "unit/transport/straight_ways.hpp"

namespace photic::estimator {

struct Edge {
  V leaving, arriving;  ///< directions of the light at its ends in the water
  double tau = 0, walk_tau = 0;
  double path = 0;    ///< group path [m]
  double spread = 0;  ///< d^2; at an instrument, its solid angle over that per area [m^2]
  double freed = 1;   ///< share of that which free walks have, too
  bool mirrored = false;
  bool by_facets = false;
  double walk_tau_before = 0, walk_tau_behind = 0;  ///< the facets
};

struct StrategiesOfPath {
  const World<double>& world;
  const medium::Medium& medium;
  const Samples<double>& samples;
  const Path& path;
  double translation_area = 0;
  std::vector<Edge> edge;  ///< 0 … k
  double common = 1;       ///< n h / g of a strategy times what it gives if it is the only one
  std::int32_t most;       ///< vertices of a walk: it does not set out from the last one

  StrategiesOfPath(const World<double>& world_, const medium::Medium& medium_,
                   const Samples<double>& samples_, const Path& path_, std::int32_t most_)
      : world(world_), medium(medium_), samples(samples_), path(path_), most(most_) {
    add_first();
    for (std::int32_t e = 1; e < path.order(); ++e) add_inner(e);
    add_last();
    for (const Edge& e : edge) common *= std::exp(e.walk_tau - e.tau);
    for (std::int32_t i = 1; i <= path.order(); ++i)
      common *= is_on_bed(i) ? bed_albedo(i) : coefficient(i) / walk_c(i);
  }

  [[nodiscard]] double group_path() const {
    double sum = 0;
    for (const Edge& e : edge) sum += e.path;
    return sum;
  }

  /// n h / g of connecting edge e; 0 if that does not draw the path.
  [[nodiscard]] double connecting(std::int32_t e) const {
    const Edge& edge = at(e);
    if (e > most || path.order() - e > most) return 0;
    if (edge.by_facets || (edge.mirrored && e > 0 && e < path.order())) return 0;
    return edge.spread * std::exp(edge.walk_tau) * chance_of_connecting(e) *
           chance_of_facets(e + 1) /
           ((e > 0 ? phase(e, e) : 1) * (e < path.order() ? phase(e + 1, e) : 1));
  }
  /// The same of translating to meet at vertex i.
  [[nodiscard]] double translated(std::int32_t i) const {
    const double last = -path.x(path.order()).z;
    const bool translates =
        i == path.order() || all_points_reach(world.instruments.telescopes[0], last);
    return translates ? samples.translated(path.order()) * translation_area * moved_to(i) : 0;
  }
  /// The same of a telescope's walk that is moved there, and connected to the telescope anew.
  [[nodiscard]] double free_telescope(std::int32_t i) const {
    if (i == path.order() || !world.walks.telescope_cones[0].by_depth) return 0;
    const Edge& e = edge.back();
    return samples.pairs * samples.free_telescope.density(path.order()) *
           (e.freed * e.spread / samples.to_instrument / std::abs(e.leaving.z)) *
           world.walks.telescope_cones[0].free_share * mean_over_telescope() * moved_to(i);
  }
  /// The same of a laser's walk.
  [[nodiscard]] double free_laser(std::int32_t i) const {
    if (i == 1 || !world.walks.laser_cone.by_depth) return 0;
    const Edge& e = edge.front();
    return samples.pairs * samples.free_laser.density(path.order()) *
           (e.freed * e.spread / samples.to_instrument / std::abs(e.arriving.z)) *
           world.walks.laser_cone.free_share * mean_over_laser() * moved_to(i);
  }
  /// Whether rays that meet at vertex i may have the same group path where they meet at other
  /// points of a grid: where light goes on down or up about as steep as it came.
  [[nodiscard]] bool as_long_elsewhere(std::int32_t i) const {
    const auto per_depth = [&](double z, std::int32_t line) {
      return medium.line[static_cast<std::size_t>(line)].group_index / z;
    };
    return std::abs(per_depth(at(i - 1).arriving.z, i <= path.converted ? 0 : path.line_of(i)) -
                    per_depth(at(i).leaving.z, path.line_of(i))) < 0.03;
  }
  /// Whether telescopes' walks may be rotated about the pivot.
  [[nodiscard]] bool rotates() const {
    if (path.line > 0) return true;
    const V& to_telescope = at(path.order()).leaving;
    const V& to_laser = at(path.order() - 1).arriving;
    return world.walks.uses.rotated_scattered &&
           std::hypot(to_laser.x, to_laser.y) > 3 * std::hypot(to_telescope.x, to_telescope.y);
  }
  /// The same of rotating about the pivot so that rays meet at vertex i.
  [[nodiscard]] double rotated(std::int32_t i) const {
    if (i >= path.pivot() || !rotates() || meets_facets_with_sides(i)) return 0;
    const V radius = path.x(i) - path.x(path.pivot());
    const V around{-radius.y, radius.x, 0};
    return samples.rotated * 2 * pi *
           std::abs(dot(around, cross(at(i - 1).arriving, at(i).leaving))) * drawn_but(i);
  }
  /// Whether facets send light back, from vertex i to the pivot, that see it turned by a rotation.
  [[nodiscard]] bool meets_facets_with_sides(std::int32_t i) const {
    if (world.slabs.surface.isotropic) return false;
    for (std::int32_t e = i; e < path.pivot(); ++e)
      if (path.facets(e)) return true;
    return false;
  }
  /// The density with which the direction is drawn in which a telescope's walk leaves the pivot,
  /// but for what no rotation changes [1/sr].
  [[nodiscard]] double drawn_at_pivot() const {
    const double share = world.walks.inverse_conversion.scattered;
    const std::int32_t k = path.order();
    return path.line > 0  ? 1
           : is_on_bed(k) ? phase(k, k - 1)
                          : (1 - share) * phase(k, k - 1) + share * lobe(k);
  }
  /// The density with which a telescope's walk in the water comes as far as its first vertex, but
  /// for what no translation changes.
  [[nodiscard]] double drawn_to_last_vertex() const { return std::exp(-edge.back().walk_tau); }
  /// What each strategy gives.
  [[nodiscard]] double value() const {
    double sum = 0;
    for (std::int32_t e = 0; e <= path.order(); ++e) sum += connecting(e);
    for (std::int32_t i = 1; i <= path.order(); ++i)
      sum += translated(i) + rotated(i) + free_telescope(i) + free_laser(i);
    return common / sum;
  }

 private:
  /// Where walks can be moved sideways to meet at vertex i: 1 over what is not drawn of it.
  [[nodiscard]] double moved_to(std::int32_t i) const {
    double steep = -at(i - 1).arriving.z * at(i).leaving.z;
    if (i == path.converted) steep = std::abs(steep);  // walks meet there either way
    if (steep <= 0) return 0;
    // On the bed pi exp(tau + tau'), as often as a point of the grid lies that far below.
    return is_on_bed(i) ? samples.grid.below_bed() * pi * met_but(i) : steep * drawn_but(i);
  }
  /// The density of the direction in which a telescope's walk leaves the last vertex, as a mean
  /// over those in which it may come there, over that with which it is drawn.
  [[nodiscard]] double mean_over_telescope() const {
    const std::int32_t k = path.order();
    if (k == path.converted || is_on_bed(k)) return 1;
    const double mean = mean_phase(of_telescope(0), k, -at(k - 1).arriving), p = phase(k, k - 1);
    if (path.line_of(k) > 0) return mean / p;
    const double share = world.walks.inverse_conversion.scattered;
    return ((1 - share) * mean + share * lobe(k)) / ((1 - share) * p + share * lobe(k));
  }
  [[nodiscard]] double mean_over_laser() const {
    if (path.converted == 1) return 1;
    if (is_on_bed(1)) return world.slabs.bed_angles > 1 ? 0 : 1;  // albedo by angle
    return mean_phase(of_laser, 1, at(1).leaving) / phase(1, 1);
  }
  [[nodiscard]] double mean_phase(std::int32_t instrument, std::int32_t i, const V& leaving) const {
    const auto l = static_cast<std::size_t>(path.line_of(i));
    const auto here =
        l * static_cast<std::size_t>(medium.layers()) + static_cast<std::size_t>(layer(i));
    V axis = world.walks.cone(instrument).axis;
    const Edge& from = instrument == of_laser ? edge.front() : edge.back();
    if (from.mirrored) axis.z = -axis.z;  // the surface has sent the walk about this one
    return world.walks.averaged.value(instrument, one_minus_cos(axis, leaving),
                                      medium.elastic_phase[here]);
  }
  /// Where rays can meet at vertex i: 1 over what is not drawn of it.
  [[nodiscard]] double drawn_but(std::int32_t i) const {
    return is_on_bed(i) ? 0 : met_but(i) / (walk_c(i) * phase(i, i));
  }
  [[nodiscard]] double met_but(std::int32_t i) const {
    if (i > most || path.order() - i + 1 > most) return 0;
    const Edge &out = at(i - 1), &back = at(i);
    return std::exp((out.by_facets ? out.walk_tau_behind : out.walk_tau) +
                    (back.by_facets ? back.walk_tau_before : back.walk_tau)) *
           chance_of_meeting(i) * chance_of_facets(i);
  }
  /// Of a telescope's walk, to draw the facets of edges from one on, over that of the laser's.
  [[nodiscard]] double chance_of_facets(std::int32_t from) const {
    double chance = 1;
    for (std::int32_t e = from; e < path.order(); ++e)
      if (path.facets(e)) chance *= path.facets(e)->chance;
    return chance;
  }
  [[nodiscard]] const Edge& at(std::int32_t e) const { return edge[static_cast<std::size_t>(e)]; }
  [[nodiscard]] std::int32_t layer(std::int32_t i) const { return medium.layer_at(-path.x(i).z); }
  /// A value [line][layer] at a vertex.
  [[nodiscard]] double of(const std::vector<double>& table, std::int32_t line,
                          std::int32_t i) const {
    return table[static_cast<std::size_t>(line * medium.layers() + layer(i))];
  }
  [[nodiscard]] double coefficient(std::int32_t i) const {
    if (i == path.converted) return of(medium.conversion, path.line, i) * of(medium.c, 0, i);
    return of(medium.albedo, path.line_of(i), i) * of(medium.c, path.line_of(i), i);
  }
  /// Of the line in which a telescope's walk comes to vertex i.
  [[nodiscard]] double walk_c(std::int32_t i) const {
    return of(transport::walk_coefficients(medium), path.line_of(i), i);
  }
  /// Of the laser's line over that of the detected one, at the conversion.
  [[nodiscard]] double ratio() const {
    return of(transport::walk_coefficients(medium), 0, path.converted) / walk_c(path.converted);
  }
  [[nodiscard]] bool is_on_bed(std::int32_t i) const { return on_bed(world.slabs, path.x(i)); }
  /// A table at even steps of sqrt(1 - cos), for the light that comes from the laser.
  [[nodiscard]] double bed_albedo(std::int32_t i) const {
    const double last = static_cast<double>(world.slabs.bed_angles) - 1;
    const double at = last * std::sqrt(1 + this->at(i - 1).arriving.z);
    const double below = std::floor(at);
    const double* row = &medium.bed_albedo[static_cast<std::size_t>(path.line_of(i)) *
                                           static_cast<std::size_t>(last + 1)];
    const auto k = static_cast<std::size_t>(below);
    return row[k] + (at - below) * (row[k + 1] - row[k]);
  }
  /// Density at vertex i of the directions of edge e; they differ on the bed alone.
  [[nodiscard]] double phase(std::int32_t i, std::int32_t e) const {
    if (is_on_bed(i)) return std::abs(e < i ? at(e).arriving.z : at(e).leaving.z) / pi;
    const double x = one_minus_cos(at(i - 1).arriving, at(i).leaving);
    const auto l = static_cast<std::size_t>(path.line_of(i));
    const auto here =
        l * static_cast<std::size_t>(medium.layers()) + static_cast<std::size_t>(layer(i));
    return world.slabs.phases.value<double>(
        x, i == path.converted ? medium.conversion_phase[l] : medium.elastic_phase[here]);
  }
  /// That a telescope's walk converts the detected light back into the laser's at vertex i.
  [[nodiscard]] double inverse_conversion(std::int32_t i) const {
    return is_on_bed(i) ? 0
                        : world.walks.inverse_conversion.chance(world.slabs, path.line, layer(i),
                                                                path.order() - i);
  }
  /// That it does not so at vertices `from` … k.
  [[nodiscard]] double stays_converted(std::int32_t from) const {
    double chance = 1;
    for (std::int32_t i = from; i <= path.order(); ++i) chance *= 1 - inverse_conversion(i);
    return chance;
  }
  /// That it does at the conversion and finds the path's direction, over the phase function.
  [[nodiscard]] double converts_back() const {
    const auto& r = world.walks.inverse_conversion;
    return inverse_conversion(path.converted) *
           ((1 - r.directed) / (4 * pi) + r.directed * lobe(path.converted)) /
           phase(path.converted, path.converted);
  }
  /// Of the direction in which a telescope's walk leaves vertex i.
  [[nodiscard]] double lobe(std::int32_t i) const {
    return world.slabs.phases.value<double>(
        one_minus_cos(world.walks.inverse_conversion.beam, -at(i - 1).arriving),
        world.walks.inverse_conversion.lobe);
  }
  /// That it finds the path's directions where it scatters the laser's light from vertex `from` on,
  /// over the phase functions.
  [[nodiscard]] double scatters(std::int32_t from) const {
    const double share = world.walks.inverse_conversion.scattered;
    double chance = 1;
    for (std::int32_t i = from; i <= path.order(); ++i)
      if (path.line_of(i) == 0 && !is_on_bed(i))
        chance *= 1 - share + share * lobe(i) / phase(i, i);
    return chance;
  }
  [[nodiscard]] double chance_of_connecting(std::int32_t e) const {
    if (path.converted == 0) return scatters(e + 2);
    if (e > path.converted) return 0;
    if (e == path.converted) return ratio() * stays_converted(path.converted + 2);
    return stays_converted(path.converted + 1) * (e < path.converted - 1 ? converts_back() : 1) *
           scatters(e + 2);
  }
  [[nodiscard]] double chance_of_meeting(std::int32_t i) const {
    if (path.converted == 0) return scatters(i + 1);
    if (i > path.converted) return 0;
    return stays_converted(path.converted + 1) * (i < path.converted ? converts_back() : 1) *
           scatters(i + 1);
  }

  void add_water(Edge& e, std::int32_t line, const std::vector<V>& points) const {
    for (std::size_t i = 1; i < points.size(); ++i) {
      e.tau += transport::optical_depth_between(medium, line, points[i - 1], points[i]);
      e.walk_tau += transport::integral_between(medium, transport::walk_coefficients(medium), line,
                                                points[i - 1], points[i]);
      e.path += transport::group_path_between(medium, line, points[i - 1], points[i]);
    }
  }
  /// The edge of an instrument at a point, seen from vertex x.
  [[nodiscard]] Edge instrument_edge(const V& x, std::int32_t line,
                                     const geometry::Sightline<double>& way, const V& instrument,
                                     bool mirrored, double solid_angle) const {
    Edge e;
    e.mirrored = mirrored;
    e.spread = samples.to_instrument * solid_angle * way.area_per_solid_angle / way.index_squared;
    const V surface = x + (-x.z / way.direction.z) * way.direction;
    e.path = instrument.z < 0 ? 0 : length(instrument - surface);
    if (instrument.z >= 0) {
      add_water(e, line, {x, surface});
    } else if (mirrored) {
      add_water(e, line, {x, surface, instrument});
    } else {
      add_water(e, line, {x, instrument});
    }
    return e;
  }
  void add_inner(std::int32_t e) {
    const V& from = path.x(e);
    const V& to = path.x(e + 1);
    const bool mirrored = path.is_mirrored(e);
    if (path.facets(e)) return add_by_facets(e, *path.facets(e));
    const V way = direction_to(from, to, mirrored);
    Edge inner{way, {way.x, way.y, mirrored ? -way.z : way.z}};
    inner.mirrored = mirrored;
    inner.spread = samples.between * dot(to - from, to - from);
    if (mirrored) {
      add_water(inner, path.line_of(e), {from, from + (-from.z / way.z) * way, to});
      common *= optics::refract(world.slabs.index[path.line_of(e)], 1.0, way.z).reflectance;
    } else {
      add_water(inner, path.line_of(e), {from, to});
    }
    edge.push_back(inner);
  }
  void add_by_facets(std::int32_t e, const WayByFacets& facets) {
    const V &from = path.x(e), &to = path.x(e + 1);
    Edge edge{normalised(facets.at - from), normalised(to - facets.at)};
    edge.by_facets = true;
    add_water(edge, path.line_of(e), {from, facets.at});
    edge.walk_tau_before = edge.walk_tau;
    add_water(edge, path.line_of(e), {facets.at, to});
    edge.walk_tau_behind = edge.walk_tau - edge.walk_tau_before;
    common *= facets.share;
    this->edge.push_back(edge);
  }
  /// Directions outside are drawn with 1 over this density: they, or those in the water, evenly in
  /// a cone.
  [[nodiscard]] double drawn_solid_angle(const EntryCone<double>& cone, std::int32_t line,
                                         const geometry::Sightline<double>& way) const {
    const double n = world.slabs.index[line];
    if (!cone.begins_outside || cone.even_outside)
      return cone.solid_angle_at(one_minus_cos(-way.arriving, cone.outside));
    return cone.solid_angle_at(one_minus_cos(-way.direction, cone.axis)) * n * n *
           std::abs(way.direction.z / way.arriving.z);
  }
  /// Depths of first vertices are drawn as those of light along the cone's axis.
  static void draw_by_depth(const EntryCone<double>& cone, double steep, bool bed, Edge& e) {
    if (!cone.by_depth) return;
    const double ratio = std::abs(steep / cone.axis.z);
    e.walk_tau = e.walk_tau * ratio - (bed ? 0 : std::log(ratio));
  }
  /// An instrument's edge by a point of a rough surface.
  void add_by_entry(const V& vertex, std::int32_t line, const Entry& entry, const WayByEntry& way,
                    const EntryCone<double>& cone, bool bed) {
    Edge e{-way.direction, way.direction};
    e.spread = samples.to_instrument * way.area;
    e.freed = way.freed;
    e.path = way.length_air;
    add_water(e, line, {entry.at, vertex});
    draw_by_depth(cone, way.direction.z, bed, e);
    common *= way.value;
    edge.push_back(e);
  }
  void add_first() {
    const auto& laser = world.instruments.laser;
    if (path.laser_entry)
      return add_by_entry(path.x(1), 0, *path.laser_entry, way_of_laser(world, path),
                          world.walks.laser_cone, is_on_bed(1));
    const auto way = way_to_laser(world, path);
    const V vertex = fictitious_vertex(laser);
    const double hidden = laser.vertex_distance / -dot(way.arriving, laser.axis);
    const double solid_angle = drawn_solid_angle(world.walks.laser_cone, 0, way);
    edge.push_back(instrument_edge(path.x(1), 0, way, vertex - hidden * way.arriving,
                                   path.is_mirrored(0), can_be_met(laser) ? solid_angle : 0));
    edge.back().arriving = -way.direction;
    draw_by_depth(world.walks.laser_cone, way.direction.z, is_on_bed(1), edge.back());
    const double x = one_minus_cos(-way.arriving, laser.axis);
    if (!laser.collimated) common *= solid_angle / (2 * pi * laser.even_within(x));
    common *= way.throughput;
  }
  void add_last() {
    const auto& telescope = world.instruments.telescopes[0];
    if (path.telescope_entry) {
      const auto by = way_of_telescope(world, path);
      translation_area = by.translation_area;
      return add_by_entry(path.x(path.order()), path.line, *path.telescope_entry, by,
                          world.walks.telescope_cones[0], is_on_bed(path.order()));
    }
    const auto way = way_to_lens(world, path);
    const double cosine = -dot(way.arriving, telescope.axis);
    const double solid_angle = drawn_solid_angle(world.walks.telescope_cones[0], path.line, way);
    edge.push_back(instrument_edge(path.x(path.order()), path.line, way,
                                   in_space(telescope, path.lens), path.is_mirrored(path.order()),
                                   solid_angle));
    edge.back().leaving = way.direction;
    draw_by_depth(world.walks.telescope_cones[0], way.direction.z, is_on_bed(path.order()),
                  edge.back());
    common *= way.throughput * telescope.area() * cosine * solid_angle / way.index_squared;
    translation_area = instrument::translation_area(telescope, way.arriving);
  }
};

}  // namespace photic::estimator
