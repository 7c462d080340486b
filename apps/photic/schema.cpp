#include "photic/commands.hpp"
#include "photic/output.hpp"

namespace photic::app {

int run(const SchemaCommand& /*command*/) {
  print_out(scene::scene_schema(PHOTIC_VERSION) + '\n');
  return done;
}

}  // namespace photic::app
