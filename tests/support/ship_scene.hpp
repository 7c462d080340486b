// The lidar of the paper's Table 1 as a Scene made by hand, to be changed by tests.
#pragma once

#include "scene/presets.hpp"
#include "scene/scene.hpp"

namespace photic::test {

inline scene::Channel channel_of(scene::Process process) {
  return {scene::word_of(process), process, {}, {}, scene::FilterShape::top_hat, {}};
}

/// A single laser line, a telescope beside it, the elastic channel; gates 0 to 50 m of 0.5 m; the
/// sea has no layer yet.
inline scene::Scene ship_scene() {
  scene::Scene scene;
  scene.source.wavelength_nm = 532;
  scene.source.position_m = {0, 0, 12};
  scene.source.direction = {0, 0, -1};
  scene.source.diameter_m = 0.04;
  scene.source.half_divergence_mrad = 5;
  scene::Telescope telescope;
  telescope.name = "telescope0";
  telescope.position_m = {0, 0, 12};
  telescope.direction = {0, 0, -1};
  telescope.diameter_m = 0.40;
  telescope.focal_length_m = 2;
  telescope.detector_diameter_m = 0.04;
  scene.telescope = {telescope};
  scene.channel = {channel_of(scene::Process::elastic)};
  scene.optics = scene::optics_of(scene::OpticsSet::modern);
  scene.optics.emission = scene::Emission::lines;
  scene.gates.depth_m = {0, 50, 0.5};
  scene.simulation.photons = 1000;
  return scene;
}

inline scene::Channel filter(double centre_nm, double fwhm_nm) {
  return {"filter", {}, centre_nm, fwhm_nm, scene::FilterShape::top_hat, {}};
}

}  // namespace photic::test
