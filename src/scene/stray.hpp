// Characters that are not ASCII and stand where TOML has none: typographic quotes, no-break spaces.
#pragma once

#include <optional>
#include <string>

namespace photic::scene {

struct LineColumn {
  int line = 1;
  int column = 1;
};

/// The first byte outside quotes and comments that is not ASCII, a byte order mark in front aside.
std::optional<LineColumn> find_stray_character(const std::string& toml);

}  // namespace photic::scene
