// The right place of a key that was written into another section.
#pragma once

#include <optional>
#include <string>

namespace photic::scene {

/// "it belongs in [gates]" for a key of one or two sections, but for those of experts; "write
/// [[sea.layer]]" for a section that stands elsewhere. Nothing else is said; case does not matter.
/// `section`: the one that the key stands in, as "sea.layer"; empty outside of all.
std::optional<std::string> place_of_key(const std::string& key, const std::string& section);

}  // namespace photic::scene
