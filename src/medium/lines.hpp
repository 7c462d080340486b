// The wavelengths that light of a scene can have.
#pragma once

#include <string>
#include <vector>

#include "medium/medium.hpp"
#include "optics/emission.hpp"
#include "optics/library.hpp"
#include "scene/scene.hpp"

namespace photic::medium {

/// The index that bends rays. Throws InputError where it has no data.
double refractive_index(const scene::Sea& sea, double wavelength_nm);

/// Light of a process and wavelength in a sea. Throws InputError where its indices have no data.
Line make_line(const scene::Sea& sea, Process process, double wavelength_nm);

/// Whether a channel counts the light of a line.
bool counts(const scene::Channel& channel, const Line& line);

/// What a layer emits by one process when light of one wavelength is absorbed in it.
struct ProcessEmission {
  Process process = Process::raman;
  optics::Emission emission;
};

/// Of all inelastic processes, whoever counts their light; the same processes in every layer.
/// `a_exciting_per_m`: the layer's absorption that excites chlorophyll's fluorescence.
std::vector<ProcessEmission> emissions(const scene::Scene& scene, const optics::Library& library,
                                       const scene::Layer& layer, double a_exciting_per_m);

/// A line of inelastic light, and what each layer emits into it.
struct EmittedLine {
  Process process = Process::raman;
  double wavelength_nm = 0;
  std::vector<double> coefficient_per_m;  ///< by layer
  std::vector<std::string> sources;       ///< of the coefficients that are not 0
};

/// The lines that a channel of the scene counts. By layer: the absorption [1/m] of the laser's
/// light that excites chlorophyll's fluorescence.
std::vector<EmittedLine> emitted_lines(const scene::Scene& scene, const optics::Library& library,
                                       const std::vector<double>& a_exciting_per_m);

/// What a layer emits into all lines [1/m]. Throws InputError if it absorbs less of the laser's
/// light.
double emitted_per_m(const std::vector<EmittedLine>& lines, const scene::Scene& scene,
                     std::size_t layer, double a_per_m);

}  // namespace photic::medium
