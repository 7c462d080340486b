#include "photic/context.hpp"

#include "photic/data_folder.hpp"

namespace photic::app {

const session::Context& context() {
  static const session::Context context = session::make_context(find_data_folder());
  return context;
}

}  // namespace photic::app
