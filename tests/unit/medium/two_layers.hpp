// A medium made by hand: two layers, the laser's line and a Raman line; to be finished.
#pragma once

#include "medium/medium.hpp"
#include "optics/phase_functions.hpp"

namespace photic::medium {

inline Medium two_layers() {
  Medium m;
  m.line = {{Process::elastic, 532, 1.34, 1.36}, {Process::raman, 649, 1.33, 1.35}};
  m.top = {0, 10, 30};
  m.c = {0.2, 0.5, 0.7, 0.9};
  m.albedo = {0.5, 0.6, 0.3, 0.4};
  m.conversion = {0, 0, 0, 1e-3};
  m.absorption = {0.5, 0.399, 0.7, 0.6};
  const auto phase = m.add_phase(std::make_shared<const optics::PhaseTable>(optics::isotropic()));
  m.elastic_phase = {phase, phase, phase, phase};
  m.conversion_phase = {phase, phase};
  return m;
}

}  // namespace photic::medium
