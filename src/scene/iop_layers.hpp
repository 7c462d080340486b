// A table of inherent optical properties in a file, as layers of a scene.
#pragma once

#include <optional>
#include <string>

#include "scene/findings.hpp"
#include "scene/netcdf_files.hpp"
#include "scene/node.hpp"

namespace photic::scene {

/// The value of `iop_table` (a rule as those of rules.hpp).
struct IopTableKey {};
Node schema_of(const IopTableKey& rule);

/// The means to read other files.
struct OtherFiles {
  std::optional<std::string> folder;  ///< that of relative ones; none: none may be named
  const NetcdfFiles& netcdf;
};

/// Puts layers with the optical properties of `sea.iop_table` in its place. Each row of the table
/// holds from its depth down to the next one.
void expand_iop_table(Node& document, const OtherFiles& files, Findings& findings);

}  // namespace photic::scene
