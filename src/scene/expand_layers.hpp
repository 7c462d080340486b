// Layers of a scene file that stand for several: those with constituents that change with depth,
// and tables of optical properties. They become homogeneous layers before anything is read.
#pragma once

#include <vector>

#include "scene/findings.hpp"
#include "scene/iop_layers.hpp"
#include "scene/node.hpp"
#include "scene/override.hpp"

namespace photic::scene {

/// For each layer of a sea, or of a column, the lower ends of the layers that it has become; none
/// of a layer that has stayed as it is.
using Cuts = std::vector<std::vector<double>>;

/// A document whose layers are as the file has them, and what they become.
struct Layered {
  Node document;
  OtherFiles files;
  std::vector<Cuts> cuts;  ///< of the sea's layers, or of each column's
};

/// Expands the layers of a scene, and makes the paths of its sensitivities lead where they did. An
/// environment's layers are cut as those of its scene are (`scene_cuts`).
std::vector<Cuts> expand_layers(Node& document, const OtherFiles& files,
                                const std::vector<Cuts>* scene_cuts, Findings& findings);

/// The number of layers that each layer of a document has become, by the cuts that were made of it.
Multiples multiples_of(Node& document, const std::vector<Cuts>& cuts);

}  // namespace photic::scene
