// Texts whose tables lie so deep in each other that a parser, or whatever goes through a tree,
// would run out of stack.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "scene/stray.hpp"

namespace photic::scene {

/// So many tables may lie in each other; scenes need ten.
inline constexpr std::size_t max_depth = 256;

/// The place where keys with dots, headers and inline tables of a text lead deeper than that. In
/// what is no TOML it may find none where toml++ reports an error.
std::optional<LineColumn> find_deep_key(const std::string& toml);

}  // namespace photic::scene
