// The Python package that belongs to this program, and the Python that it runs in.
#pragma once

#include <string>
#include <vector>

namespace photic::app {

/// The work that a Python is needed for, as in "no Python that can draw plots", and its modules.
struct PythonUse {
  std::string purpose;
  std::vector<std::string> modules;
};

/// Becomes the package's command with these words; its exit code is what the user gets. Throws
/// EnvironmentError where there is no package, or no Python with the modules.
[[noreturn]] void become_package(const PythonUse& use, const std::vector<std::string>& words);

}  // namespace photic::app
