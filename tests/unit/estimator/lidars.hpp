// Lidars with wide views over and in a sea of three layers, in which walks are written by hand.
#pragma once

#include "estimator/world.hpp"
#include "unit/estimator/scores.hpp"
#include "unit/transport/sea.hpp"

namespace photic::estimator {

struct Sea {
  World<double> world;
  transport::Sea medium;
  std::vector<EntryCone<double>> free_cones, own_cones;  ///< of the laser and the telescope
  AveragedPhaseTables averaged;

  Sea(const scene::Source& source, const scene::Telescope& telescope,
      const transport::Sea& with = transport::make_sea(40))
      : medium(with) {
    world.slabs = medium.view();
    world.instruments.laser = instrument::make_laser<double>(source);
    world.instruments.laser_region = transport::region_at(medium, source.position_m);
    world.instruments.telescopes = {instrument::make_telescope<double>(telescope)};
    world.instruments.telescope_region = {transport::region_at(medium, telescope.position_m)};
    world.walks.inverse_conversion = {
        0.3, 0.5,
        geometry::axis_in_water(source.position_m, world.instruments.laser.axis,
                                medium.line[0].refractive_index)
            .direction,
        1, 0.2};
    const std::vector<InnerCone> inner{{0.2, 0.3}, {0.5, 0.4}};
    free_cones = {entry_cone(source, medium, 40), entry_cone(telescope, medium, 40, inner)};
    own_cones = {cone_of_own_rays(source, medium), cone_of_own_rays(telescope, medium, inner)};
    begin(true);
    averaged = {medium, free_cones, {}};
    world.walks.averaged = averaged.view();
    world.instruments.path_to_origin = {path_to_origin(
        geometry::ahead_of(source.position_m, normalised(source.direction)), telescope, false)};
    world.instruments.groups = {{0,
                                 world.instruments.telescopes[0],
                                 world.instruments.telescope_region[0],
                                 world.instruments.path_to_origin[0],
                                 {}}};
    world.walks.deepest = 40;
    world.walks.max_vertices = max_vertices;
    world.walks.uses.to_laser = instrument::can_be_met(world.instruments.laser);
    world.walks.uses.rotated_scattered =
        world.walks.inverse_conversion.beam.x == 0 && world.walks.inverse_conversion.beam.y == 0;
  }
  /// Walks begin so that they may be free, or with the instruments' own rays.
  void begin(bool free) {
    const auto& cones = free ? free_cones : own_cones;
    world.walks.laser_cone = cones[0];
    world.walks.telescope_cones = {cones[1]};
  }
  Sea(const Sea&) = delete;  // the world looks into the medium
  Sea& operator=(const Sea&) = delete;
};

/// Also of walks that may be rotated: as many as of those that may be translated.
inline const Samples<double> translating{1, 0.3, 2, 0, grid, {0.6}, {1.5}},
    rotating{1, 0.3, 2, 2, grid, {0.6}, {1.5}};

inline scene::Source laser_at(const V& position, const V& direction) {
  scene::Source source;
  source.position_m = position;
  source.direction = direction;
  source.diameter_m = 0.02;
  source.half_divergence_mrad = 1200;
  return source;
}

/// It sees 65 degrees about its axis.
inline scene::Telescope telescope_at(const V& position, const V& direction) {
  scene::Telescope t;
  t.position_m = position;
  t.direction = direction;
  t.diameter_m = 0.3;
  t.obstruction_diameter_m = 0.1;
  t.focal_length_m = 0.5;
  t.detector_diameter_m = 2.2;
  return t;
}

}  // namespace photic::estimator
