// Layers of a scene file that stand for several: those with constituents that change with depth,
// and tables of optical properties. They become homogeneous layers before anything is read.
#pragma once

#include <vector>

#include "scene/findings.hpp"
#include "scene/iop_layers.hpp"
#include "scene/node.hpp"

namespace photic::scene {

/// For each layer of a document the lower ends of the layers that it has become; none of a layer
/// that has stayed as it is.
using Cuts = std::vector<std::vector<double>>;

/// A document whose layers are as the file has them, and what they become.
struct Layered {
  Node document;
  OtherFiles files;
  Cuts cuts;
};

/// Expands the layers of a scene, and makes the paths of its sensitivities lead where they did. An
/// environment's layers are cut as those of its scene are (`scene_cuts`).
Cuts expand_layers(Node& document, const OtherFiles& files, const Cuts* scene_cuts,
                   Findings& findings);

}  // namespace photic::scene
