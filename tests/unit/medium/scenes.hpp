// Scenes for the tests of the medium, and the medium made of them.
#pragma once

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "medium/build.hpp"
#include "support/ship_scene.hpp"
#include "support/tables.hpp"

namespace photic::medium {

inline const optics::Library& library() { return *test::tables(); }

inline Medium medium_of(const scene::Scene& scene) { return build_medium(scene, library()); }

/// Why a scene's medium is not made.
inline std::string refusal(const scene::Scene& scene) {
  try {
    medium_of(scene);
  } catch (const InputError& e) {
    return e.what();
  }
  return "nothing was refused";
}

inline scene::PhaseFunction henyey_greenstein(double g) {
  scene::PhaseFunction function;
  function.model = scene::PhaseModel::henyey_greenstein;
  function.g = g;
  return function;
}

/// Optical properties from 500 to 700 nm, given outright.
inline scene::Layer iop_layer(const std::string& name = "top") {
  scene::Layer layer;
  layer.name = name;
  layer.iop = {{500, 0.05, 0.20, 0.01}, {600, 0.15, 0.10, 0.03}, {700, 0.65, 0.08, 0.03}};
  layer.phase_function = henyey_greenstein(0.924);
  return layer;
}

/// A scene of these layers and channels.
inline scene::Scene scene_of(std::vector<scene::Layer> layers,
                             std::vector<scene::Channel> channels) {
  scene::Scene scene = test::ship_scene();
  scene.sea.layer = std::move(layers);
  scene.channel = std::move(channels);
  return scene;
}

inline const std::vector<scene::Channel> all_channels{test::channel_of(Process::elastic),
                                                      test::channel_of(Process::raman),
                                                      test::channel_of(Process::chlorophyll)};

}  // namespace photic::medium
