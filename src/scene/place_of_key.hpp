// The right place of a key that was written into another section.
#pragma once

#include <optional>
#include <string>

namespace photic::scene {

/// "it belongs in [gates]" for a key of one or two sections, but for those of experts; "write
/// [[sea.layer]]" for a section that stands elsewhere. Nothing else is said; case does not matter.
/// `at_top`: the key stands outside all sections.
std::optional<std::string> place_of_key(const std::string& key, bool at_top);

}  // namespace photic::scene
