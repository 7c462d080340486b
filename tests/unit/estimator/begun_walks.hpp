// Walks that begin through waves as in a run, and the paths that are made of them.
#pragma once

#include "estimator/bidirectional/bidirectional.hpp"
#include "support/random.hpp"
#include "unit/estimator/lidars.hpp"

namespace photic::estimator {

/// Over waves, with instruments whose walks begin as in a run.
struct SeaOfWaves : Sea {
  SeaOfWaves(const scene::Source& source, const scene::Telescope& telescope,
             const medium::Waves& waves, const std::vector<double>& bed_albedo)
      : Sea(source, telescope, sea_of(waves, bed_albedo)) {
    const auto cones = [&](bool frees) {
      return std::vector{world.instruments.laser_region.outside
                             ? cone_under_waves(source, medium, medium.top.back(), frees)
                             : cone_of_own_rays(source, medium),
                         cone_under_waves(telescope, medium, medium.top.back(), frees)};
    };
    free_cones = cones(true);
    own_cones = cones(false);
    averaged = {medium, free_cones, {}};
    world.walks.averaged = averaged.view();
    world.walks.deepest = medium.top.back();
    world.random.key = 5;
    world.random.batch_photons = 1000000;
    begin(true);
  }
  static transport::Sea sea_of(const medium::Waves& waves, const std::vector<double>& bed_albedo) {
    auto sea = transport::make_sea(bed_albedo.empty() ? 40 : 15, bed_albedo);
    sea.waves = waves;
    return sea;
  }
};

/// A walk of the laser and one of the telescope.
struct Begun {
  Birth<double> laser, back;
  BirthRecord<double> record;  ///< of the telescope's
};
/// The n-th of a sea, which detect a line.
inline Begun begin_walks(const World<double>& world, std::int32_t line, std::int32_t n) {
  const Draws<double> laser(world.random, 0, 0, 0), back(world.random, 0, 4, 1);
  const Receiver<double> receiver{0,    0,  0,   world.instruments.telescope_region[0],
                                  line, -1, 1e4, 1e4};
  tally::Ledger ledger;
  FromLaser<double, tally::Ledger> from_laser{{laser, 0}, world, ledger};
  FromTelescope<double, tally::Ledger> from_telescope{{back, 0}, world, receiver};
  const auto met = [](bool, const surface::FacetHit<double>&) {};
  const auto flown = [](bool, const geometry::Segment<double>&) {};
  Begun begun;
  BirthRecord<double> of_laser;
  begun.laser = from_laser.birth(n, true, of_laser, met, flown);
  begun.back = from_telescope.birth(n, true, begun.record, met, flown);
  begun.record.spread = begun.back.spread;
  return begun;
}

/// Where a walk has come through waves: by one facet, or by those that it has drawn.
inline Entry entry_of(const Birth<double>& birth) {
  return {birth.entry.at, birth.spread.solid_angle > 0 ? 0 : birth.photon.weight};
}
/// On a walk's first ray, at a depth.
inline V at_depth(const Birth<double>& birth, double depth) {
  const auto& photon = birth.photon;
  const double length = -(photon.position.z + depth) / photon.direction.z;
  V at = photon.position + length * photon.direction;
  at.z = -depth;
  return at;
}

/// A path that begins with the laser's ray and ends with the telescope's; of one vertex it has the
/// telescope's alone. Others lie about these, each at one of the depths.
inline Path path_of(const World<double>& world, const Begun& begun,
                    const std::vector<double>& depths, test::Random& random) {
  Path path;
  path.lens = begun.record.lens;
  path.telescope_entry = entry_of(begun.back);
  if (world.instruments.laser_region.outside) path.laser_entry = entry_of(begun.laser);
  const V first = at_depth(begun.laser, depths.front()), last = at_depth(begun.back, depths.back());
  for (const double depth : depths) {
    const V middle = 0.5 * (first + last);
    path.vertex.push_back(
        {middle.x + random.between(-2, 2), middle.y + random.between(-2, 2), -depth});
  }
  path.vertex.front() = first;
  path.vertex.back() = last;
  return path;
}

/// The path with the entry of an instrument where slopes lead that a walk's uniforms draw.
inline Path entering_by_slopes(const World<double>& world, std::int32_t instrument,
                               const Birth<double>& birth, Path path) {
  const bool lit = instrument == of_laser;
  const auto level = level_to(world, instrument, lit ? 0 : path.line,
                              lit ? path.x(1) : path.x(path.order()), path.lens, true);
  (lit ? path.laser_entry : path.telescope_entry) = Entry{transport::point_by_slopes(
      level, world.slabs.waves, birth.entry.u_slope, birth.entry.u_azimuth)};
  return path;
}
/// Whether an instrument's own rays come to its entry, or to its end of the path if it is in the
/// water.
inline bool reaches(const World<double>& world, std::int32_t instrument, const Path& path) {
  const auto& laser = world.instruments.laser;
  if (instrument == of_laser && laser.inside)
    return one_minus_cos(normalised(path.x(1) - fictitious_vertex(laser)), laser.axis) <
           laser.one_minus_cos_divergence;
  double density = 0;
  const auto& entry = instrument == of_laser ? path.laser_entry : path.telescope_entry;
  return entry_at(world.instruments, instrument, entry->at, path.lens, density).exists;
}

/// The path as it goes by another point of the lens, all of it beyond the laser's part aside. Its
/// last ray keeps its direction.
inline Path through_lens_at(const World<double>& world, const Begun& begun,
                            const instrument::PlanePoint<double>& lens, Path path, V& aside) {
  const V& outward = begun.record.outward;
  const V from = in_space(world.instruments.telescopes[0], lens);
  aside = from - (from.z / outward.z) * outward - path.telescope_entry->at;
  aside.z = 0;
  path.lens = lens;
  path.telescope_entry->at = path.telescope_entry->at + aside;
  return path;
}

}  // namespace photic::estimator
