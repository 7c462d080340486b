// Commands as a shell takes them.
#pragma once

#include <string>
#include <vector>

namespace photic::app {

/// A word that a shell takes as it is: in quotes where it must be ("'my scene.toml'").
std::string quoted(const std::string& word);

/// A file's name that no program takes for an option: "./-my.nc".
std::string as_file(const std::string& name);

/// The call of the program.
struct Call {
  std::string program = "photic";  ///< as typed, to start it again from the same place
  std::string line;                ///< "photic run 'my scene.toml'", for the history of a result
  std::vector<std::string> words;  ///< after the program's name

  /// "build/photic plot 'my result.nc'": a command of this program that works as printed.
  [[nodiscard]] std::string command(const std::vector<std::string>& arguments) const;
};

Call call_of(int argc, const char* const* argv);

}  // namespace photic::app
