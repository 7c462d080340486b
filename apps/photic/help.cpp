#include <algorithm>

#include "photic/commands.hpp"
#include "photic/output.hpp"
#include "photic/terminal.hpp"

namespace photic::app {

int run(const HelpCommand& command) {
  constexpr int no_terminal = 80;
  const int width = columns(Stream::out, no_terminal);
  const auto& all = command.program.commands;
  const auto asked = std::ranges::find(all, command.command, &CommandManual::name);
  print_out(asked == all.end() ? short_help(command.program, width) : help(*asked, width));
  return done;
}

}  // namespace photic::app
