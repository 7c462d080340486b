// The lines that a session has for its user, and the commands that they name: the command line's,
// or Python's.
#pragma once

#include <functional>
#include <string>

namespace photic::session {

struct FrontEnd {
  /// Takes one line for the user, without its end. Called from any thread of the session.
  std::function<void(const std::string& line)> report;
  /// The command that goes on from a result file and writes the longer one.
  std::function<std::string(const std::string& earlier, const std::string& output)> go_on;
};

}  // namespace photic::session
