#include "session/context.hpp"

#include <algorithm>
#include <thread>

namespace photic::session {

Context make_context(const std::string& data_folder, int threads) {
  const auto cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return {std::make_shared<const optics::Library>(data_folder),
          std::make_shared<run::Permits>(threads > 0 ? threads : cores)};
}

}  // namespace photic::session
