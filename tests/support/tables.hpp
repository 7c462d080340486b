// The data tables of the source tree, read once by each test program.
#pragma once

#include <memory>

#include "optics/library.hpp"

namespace photic::test {

inline const std::shared_ptr<const optics::Library>& tables() {
  static const auto known = std::make_shared<const optics::Library>(PHOTIC_SOURCE_DIR "/data");
  return known;
}

}  // namespace photic::test
