// The optics of layers, of a scene's water or of air, as a table: the output of `photic optics`
// (docs/guide.md).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "medium/sources.hpp"
#include "optics/library.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// The substance between the edges of layers: water, from the surface down, or air, from the lowest
/// level up.
enum class Layered { water, air };

/// Values of a layer k at a wavelength w stand at k * wavelengths + w, those of a phase function at
/// an angle i at (k * wavelengths + w) * angles + i.
struct OpticalTable {
  /// The absorption, scattering and backscattering of one constituent. Empty where no layer's
  /// optics give it, NaN in a layer whose constituents are not known, 0 in one that has none of it.
  struct Part {
    std::string name;
    std::vector<double> a_per_m, b_per_m, bb_per_m;
  };
  /// The emission of the layers by one process [photons per metre and photon of the exciting
  /// light].
  struct Emission {
    std::string process;
    std::vector<double> wavelength_nm;  ///< of its lines, ascending; none where nothing is emitted
    std::vector<double> line_per_m;     ///< [layer][line]
    std::vector<double> coefficient_per_m;  ///< all lines, by layer
    std::vector<std::string> sources;
  };

  Layered of = Layered::water;
  std::vector<std::string> layer_name;
  bool in_columns = false;  ///< side by side: `layer_name` has the column, too
  /// The edges of each layer: depths of the upper and of the lower one, which may be infinite;
  /// altitudes of the lower and of the upper one.
  std::vector<double> first_m, last_m;
  std::vector<double> wavelength_nm;
  std::vector<double> angle_deg;
  std::vector<double> a_per_m, b_per_m, backscatter_fraction, mean_cosine;
  std::vector<double> a_exciting_per_m;  ///< of water: the part of a that excites chlorophyll
  std::vector<double> refractive_index;  ///< of air
  std::vector<double> phase_function_per_sr;
  std::vector<Part> parts;
  std::vector<Source> sources;
  double excitation_nm = 0;
  std::vector<Emission> emission;  ///< of water

  [[nodiscard]] std::size_t layers() const { return layer_name.size(); }
  [[nodiscard]] std::size_t wavelengths() const { return wavelength_nm.size(); }
  [[nodiscard]] std::size_t angles() const { return angle_deg.size(); }
  [[nodiscard]] std::vector<double> c_per_m() const;
  [[nodiscard]] std::vector<double> bb_per_m() const;  ///< backscattering
  [[nodiscard]] std::vector<double> albedo() const;    ///< b / c
};

/// 1 - cos, with its digits near the forward direction.
double x_of_angle(double angle_deg);

/// Scattering angles that phase functions are given at: 0, ten in each decade from 0.01 to 10, then
/// every 5 degrees. Photic's phase functions are flat within 0.01 degree (optics/phase_table.hpp).
std::vector<double> table_angles_deg();

/// The wavelengths that light of the scene has: the laser's, and of each process's light that its
/// channels count the mean; ascending.
std::vector<double> wavelengths_of_light(const scene::Scene& scene, const optics::Library& library);

/// The table for ascending wavelengths; what is emitted is excited by the scene's laser. Throws
/// InputError where there are no data, at one of the wavelengths or at the laser's.
OpticalTable optical_table(const scene::Scene& scene, const optics::Library& library,
                           const std::vector<double>& wavelength_nm);

}  // namespace photic::medium
