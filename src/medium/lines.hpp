// The wavelengths that light of a scene can have.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "medium/bands.hpp"
#include "medium/filters.hpp"
#include "medium/layer_optics.hpp"
#include "medium/medium.hpp"
#include "optics/emission.hpp"
#include "optics/library.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// The index that bends rays. Throws InputError where it has no data.
double refractive_index(const scene::Sea& sea, double wavelength_nm);

/// Light of a process and wavelength in a sea, emitted at once. Throws InputError where its indices
/// have no data.
Line make_line(const scene::Sea& sea, Process process, double wavelength_nm);

/// The mean time from excitation to emission.
double lifetime_ns(const scene::Optics& optics, Process process);

/// The share of light of a wavelength and process that each channel counts.
std::vector<double> counted_by(const scene::Scene& scene,
                               const std::vector<std::optional<Filter>>& filters, Process process,
                               double wavelength_nm);

/// A line of inelastic light, and what each layer emits into it.
struct EmittedLine {
  Process process = Process::raman;
  double wavelength_nm = 0;
  std::vector<double> coefficient_per_m;  ///< by layer
  std::vector<double> counted_by;         ///< channels of the scene: the share of it
  double photons = 1;                     ///< in it, relative to other lines of its process
};

/// All that a layer emits by a process, in the lines between two wavelengths.
struct EmissionSource {
  Process process = Process::raman;
  std::size_t layer = 0;
  double first_nm = 0, last_nm = 0;
  double coefficient_per_m = 0;
  std::string source;
};

/// The lines of a process's spectrum that some channel counts. Throws InputError for more than a
/// walk can choose from.
std::vector<BandLine> lines_of(Process process, const optics::EmissionSpectrum& spectrum,
                               const scene::Scene& scene);

struct EmittedLight {
  std::vector<EmittedLine> lines;       ///< those of a process one behind the other
  std::vector<EmissionSource> sources;  ///< of the coefficients that are not 0
};

/// The light that a channel of the scene counts. A spectrum is cut into lines that are at most
/// 5 nm apart, each where the mean of its light is. By layer: its optics at the laser's wavelength.
/// Throws InputError for tables that are of no use, and for more lines than a walk can choose from.
EmittedLight emitted_light(const scene::Scene& scene, const optics::Library& library,
                           const std::vector<WaterOptics>& at_laser);

/// The fluorescence of CDOM according to the scene. Throws InputError for a table that is of no
/// use.
optics::Emission cdom_emission(const scene::Scene& scene, const optics::Library& library);

/// The emission of a layer into all lines [1/m]. Throws InputError if it absorbs less of the
/// laser's light.
double emitted_per_m(const std::vector<EmittedLine>& lines, const scene::Scene& scene,
                     std::size_t layer, double a_per_m);

}  // namespace photic::medium
