// The command line's offer, as text: help on the terminal, and all that is made of it.
#pragma once

#include <string>
#include <vector>

namespace photic::app {

/// An option, a flag, or (positional) an argument without a name of its own.
struct OptionManual {
  std::string names;                 ///< "-o,--output"; of a positional "SCENE"
  std::string value;                 ///< "FILE"; empty: a flag
  std::string meaning;               ///< a sentence
  std::vector<std::string> choices;  ///< all values that it can have; empty: others, too
  bool positional = false;
  bool required = false;
  bool repeated = false;  ///< takes several values
  bool again = false;     ///< may be given several times, with a value each
};

/// "-o" and "--output" of "-o,--output".
std::vector<std::string> names_of(const OptionManual& option);

struct Example {
  std::string command, meaning;
};

struct CommandManual {
  std::string name;     ///< "run"; of the whole program "photic"
  std::string meaning;  ///< a sentence
  std::vector<OptionManual> options;
  std::vector<Example> examples;
  std::vector<CommandManual> commands;
};

struct ExitCode {
  int code;
  const char* meaning;
};
const std::vector<ExitCode>& exit_codes();

/// A variable of the environment that the program heeds.
struct Variable {
  const char* name;
  const char* meaning;
};
const std::vector<Variable>& variables();

/// All of a command, in lines of at most `width` columns.
std::string help(const CommandManual& command, int width);

/// The commands of the program in a line each, and how to begin.
std::string short_help(const CommandManual& program, int width);

}  // namespace photic::app
