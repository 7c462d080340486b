// Command line -> Command.
#pragma once

#include <optional>

#include "photic/commands.hpp"

namespace photic::app {

/// A command to follow, or the exit code when there is none (help was printed, or an error).
struct Parsed {
  std::optional<Command> command;
  int exit_code = done;
};

Parsed parse_command_line(int argc, const char* const* argv);

}  // namespace photic::app
