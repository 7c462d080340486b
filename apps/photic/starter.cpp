#include "photic/commands.hpp"
#include "photic/output.hpp"

namespace photic::app {

int run(const NewCommand& command) {
  const std::string text = scene::starter_scene(command.kind);
  if (command.output.empty()) {
    print_out(text);
    return done;
  }
  const bool written = write_new_file(command.output, text);
  print_out(command.output + (written ? ": written" : ": is there already") +
            "; check it with: " + command.call.command({"check", command.output}) + '\n');
  return done;
}

}  // namespace photic::app
