// The path of the running program.
#pragma once

#include <filesystem>

namespace photic::app {

/// The prefix that the program is installed under: the folder above its own ("/usr" of
/// /usr/bin/photic). Empty if nobody knows.
std::filesystem::path program_prefix();

}  // namespace photic::app
