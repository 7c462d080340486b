// The optics of spheres of a wide range of sizes, large ones among them, in a few seconds: Mie
// theory at a few thousand sizes and a few hundred angles (docs/theory.md, "Aerosols").
#pragma once

#include <memory>
#include <stop_token>

#include "core/kept.hpp"
#include "optics/spheres.hpp"

namespace photic::optics {

/// Means over all spheres.
struct SampledSpheres {
  double extinction_m2 = 0, scattering_m2 = 0, absorption_m2 = 0;  ///< cross-sections of one
  double mean_cosine = 0;                                          ///< g of what is scattered
  PhaseShape phase;     ///< none where it was not asked for
  double integral = 1;  ///< of p between its angles over the sphere, before it was scaled to 1
};

/// At steps of 0.25 in the size parameter (or the 4000th part of all sizes) and 2 % in radius.
/// Cross-sections and g are within 1e-3 of optics_of_spheres; p is within 1.5 % where spheres
/// absorb (k above 1e-3). Resonances of spheres that do not are met by chance: there p is within 2
/// % up to 90 degrees and some 6 % beyond. The same bits on any number of threads. Throws
/// ContractViolation and Stopped as optics_of_spheres does.
SampledSpheres sampled_spheres(const Spheres& spheres, const std::stop_token& stop = {});

/// The same without the phase function, in a fraction of the time.
SampledSpheres sampled_sections(const Spheres& spheres, const std::stop_token& stop = {});

/// Keeps each kind of spheres, as SpheresCache does.
class SampledSpheresCache {
 public:
  std::shared_ptr<const SampledSpheres> operator()(const Spheres& spheres,
                                                   const std::stop_token& stop = {}) const;
  std::shared_ptr<const SampledSpheres> sections(const Spheres& spheres,
                                                 const std::stop_token& stop = {}) const;

 private:
  Kept<Spheres, std::shared_ptr<const SampledSpheres>> known_, sections_;
};

}  // namespace photic::optics
