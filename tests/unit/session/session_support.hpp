// The data tables that tests of sessions share.
#pragma once

#include "session/context.hpp"

namespace photic::test {

inline const session::Context& context() {
  static const session::Context context = session::make_context(PHOTIC_SOURCE_DIR "/data");
  return context;
}

}  // namespace photic::test
