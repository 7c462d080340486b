// The optical properties of one layer of water at one wavelength.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optics/library.hpp"
#include "optics/phase_from_table.hpp"
#include "optics/phase_table.hpp"
#include "optics/phytoplankton.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

struct WaterOptics {
  double a_per_m = 0;           ///< all absorption
  double b_per_m = 0;           ///< all scattering
  double a_exciting_per_m = 0;  ///< the share of a that excites chlorophyll fluorescence
  double b_molecular_per_m =
      0;  ///< the share of b by the water itself (0 in an iop layer: it is not known apart)
  std::optional<double> backscatter_fraction;  ///< b_b/b, which tells an iop layer's phase function
  std::vector<std::string> sources;
};

/// A part of the scattering that has one phase function.
struct ScatteringPart {
  double b_per_m = 0;
  optics::PhaseShape phase;
};

class LayerOptics {
 public:
  LayerOptics(const scene::Scene& scene, const optics::Library& library);

  /// All below throw InputError where there are no data for the wavelength.
  WaterOptics operator()(const scene::Layer& layer, double wavelength_nm) const;

  /// What a layer of constituents is made of.
  [[nodiscard]] optics::Sourced water_absorption(double wavelength_nm) const;
  [[nodiscard]] optics::Sourced water_scattering(double wavelength_nm) const;
  [[nodiscard]] optics::Phytoplankton phytoplankton(const scene::Layer& layer,
                                                    double wavelength_nm) const;

  /// Of what the scattering in the layer is made up, water first.
  [[nodiscard]] std::vector<ScatteringPart> scattering(const scene::Layer& layer,
                                                       double wavelength_nm,
                                                       const WaterOptics& water) const;
  /// The phase function of all scattering in the layer.
  [[nodiscard]] optics::PhaseShape phase(const scene::Layer& layer, double wavelength_nm,
                                         const WaterOptics& water) const;
  /// One that is given by name. Throws InputError if its table or its parameters are of no use.
  [[nodiscard]] optics::PhaseShape shape(const scene::PhaseFunction& function,
                                         double wavelength_nm) const;

 private:
  [[nodiscard]] optics::PhaseShape spheres(const optics::SeaParticles& particles,
                                           double wavelength_nm) const;
  [[nodiscard]] WaterOptics of_constituents(const scene::Layer& layer, double wavelength_nm) const;

  const scene::Scene* scene_;
  const optics::Library* library_;
};

/// A user's table of a phase function.
optics::TabulatedPhase phase_of_file(const std::string& path);

}  // namespace photic::medium
