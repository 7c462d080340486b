#include "photic/program.hpp"

namespace photic::app {

std::filesystem::path program_prefix() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::path() : program.parent_path().parent_path();
}

}  // namespace photic::app
