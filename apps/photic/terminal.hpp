// The terminal's properties: its width, and whether text may be coloured.
#pragma once

#include <string>
#include <string_view>

namespace photic::app {

/// The stream of a text: standard output or standard error.
enum class Stream { out, error };

/// Returns whether a person sees it: whether it goes to a terminal.
bool is_terminal(Stream stream);

/// Columns of the terminal, or `otherwise` where it goes to a file or a pipe.
int columns(Stream stream, int otherwise);

enum class Colour { bold, red, yellow, cyan };

/// The text in a colour where it goes to a terminal and NO_COLOR is not set (no-color.org); else as
/// it is.
std::string painted(std::string_view text, Colour colour, Stream stream);

}  // namespace photic::app
