// The optical properties of one layer of water at one wavelength.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "optics/library.hpp"
#include "optics/minerals.hpp"
#include "optics/phase_from_table.hpp"
#include "optics/phase_table.hpp"
#include "optics/phytoplankton.hpp"
#include "optics/phytoplankton_table.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// The values of one model or table for one constituent of the water; several may speak of the
/// same.
struct Contribution {
  std::string name;  ///< "water", "phytoplankton", "CDOM", "minerals"; "" in an iop layer and in
                     ///< one of Jerlov's types: it is all of them
  std::optional<double> a_per_m, b_per_m;  ///< none: nothing is said of it
  std::string source;
};

struct WaterOptics {
  double a_per_m = 0;           ///< all absorption
  double b_per_m = 0;           ///< all scattering
  double a_exciting_per_m = 0;  ///< the part of a that excites chlorophyll fluorescence
  double a_cdom_per_m = 0;      ///< the share of a that excites CDOM fluorescence
  double b_molecular_per_m =
      0;  ///< the share of b by the water itself (0 in an iop layer: it is not known apart)
  double b_phytoplankton_per_m = 0;  ///< phytoplankton's part of b; of one of Jerlov's types,
                                     ///< all particles
  double b_minerals_per_m = 0;       ///< minerals' part of b
  std::optional<double> backscatter_fraction;  ///< b_b/b, which sets an iop layer's phase function
  std::vector<Contribution> contributions;     ///< which a and b are the sums of

  [[nodiscard]] double albedo() const { return b_per_m / (a_per_m + b_per_m); }
};

/// The scatterers that have a phase function each.
enum class Scatterer { all, water, phytoplankton, minerals };

/// A part of the scattering.
struct ScatteringPart {
  Scatterer of = Scatterer::all;
  double b_per_m = 0;
  optics::PhaseShape phase;
};

class LayerOptics {
 public:
  LayerOptics(const scene::Scene& scene, const optics::Library& library, std::stop_token stop = {});

  /// All below throw InputError where there are no data for the wavelength, and Stopped.
  WaterOptics operator()(const scene::Layer& layer, double wavelength_nm) const;

  /// The parts of a layer of constituents.
  [[nodiscard]] optics::Sourced water_absorption(const scene::Layer& layer,
                                                 double wavelength_nm) const;
  [[nodiscard]] optics::Sourced water_scattering(const scene::Layer& layer,
                                                 double wavelength_nm) const;
  [[nodiscard]] optics::Phytoplankton phytoplankton(const scene::Layer& layer,
                                                    double wavelength_nm) const;
  [[nodiscard]] optics::Minerals minerals(const scene::Layer& layer, double wavelength_nm) const;

  /// The parts of the scattering in the layer, water first.
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
  /// A layer's own, or else the sea's.
  [[nodiscard]] double salinity_psu(const scene::Layer& layer) const;
  [[nodiscard]] double temperature_c(const scene::Layer& layer) const;
  [[nodiscard]] optics::Spheres spheres(const optics::SeaParticles& particles,
                                        double wavelength_nm) const;
  [[nodiscard]] optics::PhaseShape mixed(const scene::PhaseFunction& mixture,
                                         double wavelength_nm) const;
  /// The phase function of particles, by the model that the scene names for them.
  [[nodiscard]] optics::PhaseShape phase_of_particles(scene::ParticlePhase model,
                                                      const optics::SeaParticles& particles,
                                                      double ff_index, double ff_slope,
                                                      double wavelength_nm) const;
  [[nodiscard]] WaterOptics of_constituents(const scene::Layer& layer, double wavelength_nm) const;
  [[nodiscard]] WaterOptics of_jerlov_type(const scene::Layer& layer, double wavelength_nm) const;

  const scene::Scene* scene_;
  const optics::Library* library_;
  std::stop_token stop_;
  mutable std::optional<optics::PhytoplanktonTable> phytoplankton_table_;  ///< once it is needed
};

}  // namespace photic::medium
