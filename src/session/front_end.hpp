// The lines that a session has for its user, and the commands that they name: the command line's,
// or Python's.
#pragma once

#include <functional>
#include <string>

namespace photic::session {

/// The names of a run's settings in messages: the flags of the command line, if they are not
/// another front end's.
struct Words {
  std::string output = "-o", force = "--force", earlier = "--continue", photons = "--photons",
              engine = "--engine", isa = "--isa";
  std::string before_value = " ";

  [[nodiscard]] std::string set(const std::string& name, const std::string& value) const {
    return name + before_value + value;
  }
};

struct FrontEnd {
  /// Takes one line for the user, without its end. Called from any thread of the session.
  std::function<void(const std::string& line)> report;
  /// The command that goes on from a result file and writes the longer one.
  std::function<std::string(const std::string& earlier, const std::string& output)> go_on;
  Words words = {};
};

}  // namespace photic::session
