// What tests of sessions share: the data tables, and scenes.
#pragma once

#include "session/context.hpp"

namespace photic::test {

inline const session::Context& context() {
  static const session::Context context = session::make_context(PHOTIC_SOURCE_DIR "/data");
  return context;
}

}  // namespace photic::test
