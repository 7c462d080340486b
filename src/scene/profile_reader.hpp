// Constituents that are profiles in a layer of a scene file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/cut.hpp"
#include "scene/findings.hpp"
#include "scene/iop_layers.hpp"
#include "scene/profile_file.hpp"

namespace photic::scene {

/// All such keys.
[[nodiscard]] std::vector<ProfiledKey> profiled_keys();

/// Reads a profile and looks whether it is known all over a layer. Problems are reported at `path`;
/// then there is none.
std::optional<Profile> read_profile(const Node& node, const std::string& path,
                                    const ProfiledKey& key, const Span& layer,
                                    const OtherFiles& files, Findings& findings);

}  // namespace photic::scene
