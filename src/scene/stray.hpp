// Characters that are not ASCII and stand where TOML has none: typographic quotes, no-break spaces.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace photic::scene {

struct LineColumn {
  int line = 1;
  int column = 1;
};

/// Returns whether a comment or a string begins with a character outside of them.
bool begins_free_text(char c);
/// The end of the comment or string that begins at `start`. Strings on one line end with it, even
/// if their quote is missing.
std::size_t end_of_free_text(std::string_view toml, std::size_t start);
/// The place of a byte of a text.
LineColumn place_of(std::string_view toml, std::size_t position);

/// The first byte outside quotes and comments that is not ASCII, a byte order mark in front aside.
std::optional<LineColumn> find_stray_character(const std::string& toml);

}  // namespace photic::scene
