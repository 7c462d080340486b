// A sea made by hand, three layers and three lines, and photons in it.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/axis.hpp"
#include "geometry/free_paths.hpp"
#include "geometry/region.hpp"
#include "medium/medium.hpp"
#include "optics/fournier_forand.hpp"
#include "optics/phase_functions.hpp"
#include "transport/photon.hpp"

namespace photic::transport {

/// A medium made by hand. Free paths are drawn from scattering alone, or a fifth of c where there
/// is less.
struct Sea : medium::Medium {
  geometry::FreePaths paths;

  void finish() {
    Medium::finish();
    std::vector<double> share = albedo;
    for (double& one : share) one = std::max(0.2, one);
    paths = {*this, share};
  }
  [[nodiscard]] geometry::Slabs view() const { return paths.slabs(*this); }
};

/// Layers 0-5, 5-12 and 12-bottom m. Line 0 converts into line 1 in the first layer, into both
/// others in the second, and into none in the third. Layers scatter as Fournier-Forand,
/// Henyey-Greenstein (g = 0.8) and molecules. The bed is black, or has albedos [line][angle].
inline Sea make_sea(double bottom_m, const std::vector<double>& bed_albedo = {}) {
  using medium::Process;
  Sea sea;
  sea.line = {{Process::elastic, 532, 1.3415, 1.3638},
              {Process::raman, 649, 1.3377, 1.3542},
              {Process::chlorophyll, 685, 1.3368, 1.3525}};
  sea.top = {0, 5, 12, bottom_m};
  sea.c = {0.2, 0.5, 0.1, 0.5, 0.8, 0.4, 0.7, 0.9, 0.6};
  sea.albedo = {0.6, 0.8, 0.7, 0.3, 0.5, 0.2, 0.2, 0.4, 0.1};
  sea.conversion = {0, 0, 0, 1e-3, 2e-3, 0, 0, 5e-3, 0};
  sea.absorption = {0.399, 0.193, 0.3, 0.7, 0.5, 0.8, 0.8, 0.6, 0.9};
  const std::int32_t peaked = sea.add_phase(
      std::make_shared<const optics::PhaseTable>(optics::fournier_forand(1.10, 3.5835)));
  const std::int32_t smooth =
      sea.add_phase(std::make_shared<const optics::PhaseTable>(optics::henyey_greenstein(0.8)));
  const std::int32_t molecules =
      sea.add_phase(std::make_shared<const optics::PhaseTable>(optics::rayleigh(0.039)));
  for (int line = 0; line < 3; ++line)
    sea.elastic_phase.insert(sea.elastic_phase.end(), {peaked, smooth, molecules});
  sea.conversion_phase = {
      0, sea.add_phase(std::make_shared<const optics::PhaseTable>(optics::raman_phase(0.17))),
      sea.add_phase(std::make_shared<const optics::PhaseTable>(optics::isotropic()))};
  sea.bed_albedo = bed_albedo;
  sea.finish();
  return sea;
}

/// Where something at a position stands.
inline geometry::Region<double> region_at(const Sea& sea, const Vec3<double>& position) {
  return {!geometry::stands_in_water(position), sea.layer_at(std::max(0.0, -position.z))};
}
inline geometry::Route route_of(bool mirrored) {
  return mirrored ? geometry::Route::mirrored : geometry::Route::direct;
}

/// A photon on its way down.
inline Photon<double> photon_at(const Sea& sea, const Vec3<double>& position,
                                std::int32_t line = 0) {
  Photon<double> photon;
  photon.position = position;
  photon.direction = {0, 0, -1};
  photon.line = line;
  photon.layer = sea.layer_at(-position.z);
  return photon;
}

}  // namespace photic::transport
