// The air above the sea: its optics in layers, at the wavelengths that light of a scene can have.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "medium/medium.hpp"
#include "medium/sources.hpp"
#include "optics/air.hpp"
#include "optics/library.hpp"
#include "optics/phase_table_cache.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// Optical depths of the laser's light, from the sea straight up to the top of the air.
struct AirDepths {
  double molecules = 0, ozone = 0, gases = 0, aerosols = 0;
  double aerosols_550 = 0;  ///< the aerosols' at 550 nm
};

/// The scatterers of each layer, for lines that are scattered alike.
struct AirPhases {
  std::vector<double> b;                                      ///< all scattering [1/m], [layer]
  std::vector<std::vector<optics::AirScatterer>> scatterers;  ///< [layer]
};

/// Lines of a process up to so far apart share the air's phase functions, those at their mean
/// wavelength: each line's own for 60 layers of haze would be hundreds of megabytes of tables.
inline constexpr double air_phases_apart_nm = 25;

/// The air above the sea in layers, from the sea up. Values of line l in layer k stand at
/// l * layers() + k.
struct Air {
  std::vector<double> height_m;  ///< edges, ascending, the first 0: layers + 1
  std::vector<double> a, b;      ///< absorption, scattering [1/m], [line][layer]
  std::vector<double> refractive_index, group_index;  ///< [line][layer]
  std::vector<AirPhases> phases;                      ///< the laser's first
  std::vector<std::size_t> phases_of;                 ///< place in `phases`, [line]
  std::shared_ptr<const optics::PhaseTableCache> tables;
  std::vector<Source> sources;
  Absorbers absorbers;              ///< of the source's light
  std::optional<AirDepths> depths;  ///< none in layers given outright

  [[nodiscard]] std::size_t layers() const { return height_m.size() - 1; }
  /// The phase function of all scattering in a layer, by place in `phases`.
  [[nodiscard]] std::shared_ptr<const optics::PhaseTable> phase(std::size_t place,
                                                                std::size_t layer) const;
  /// The optical depth for a line's light, from the sea straight up to the top.
  [[nodiscard]] double optical_depth(std::size_t line) const;
};

/// Layers of a profile are halved until what they take for granted, that light is attenuated alike
/// all over them, is wrong by no more than this of the optical depth up to their middle, in the
/// laser's light; of layers thicker than 1, by this share of their depth.
inline constexpr double air_depth_tolerance = 1e-3;

/// Builds the air of a scene, and of its environments in the same layers.
class AirBuilder {
 public:
  /// Throws EnvironmentError for data that are missing or damaged.
  AirBuilder(const scene::Scene& scene, const optics::Library& library,
             const std::vector<Line>& lines, std::stop_token stop = {});

  /// Returns the air of the scene, or of the scene in an environment; there must be an
  /// [atmosphere]. Throws InputError for what check_medium (medium/check.hpp) finds.
  [[nodiscard]] Air operator()(const scene::Scene& scene) const;
  /// Its layers at a wavelength. In layers that are given outright the aerosols stand for all there
  /// is. Throws the same.
  [[nodiscard]] optics::AirOptics at(const scene::Scene& scene, double wavelength_nm,
                                     optics::Phases phases) const;

 private:
  [[nodiscard]] optics::AirProfile in_layers(const scene::Atmosphere& air) const;
  [[nodiscard]] optics::AirOptics of_layers(const scene::Scene& scene, double wavelength_nm) const;

  const optics::Library& library_;
  const std::vector<Line>& lines_;
  std::stop_token stop_;
  std::vector<std::vector<double>> halved_km_;  ///< edges that a profile's layers are halved by
};

/// None without an [atmosphere]. Throws as AirBuilder does.
std::optional<Air> build_air(const scene::Scene& scene, const optics::Library& library,
                             const std::vector<Line>& lines, const std::stop_token& stop = {});

/// The lines of `photic show` about the air.
std::vector<std::string> reported_air(const scene::Scene& scene, const Air& air);

}  // namespace photic::medium
