#include "photic/manual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "io/table_parts.hpp"

namespace photic::app {
namespace {

constexpr int widest = 100;      // longer lines are hard to read
constexpr int narrow = 72;       // meanings stand below names
constexpr int name_column = 26;  // of options
constexpr int command_column = 12;
constexpr int example_column = 46;

int usable(int width) { return std::clamp(width, static_cast<int>(io::min_width), widest); }

/// A name and its meaning beside it, or below where the name or the terminal leaves no room.
std::string entry(const std::string& name, const std::string& meaning, int column, int width) {
  const bool below = width < narrow && column > command_column;
  const int indent = below ? 6 : column + 2;
  std::string out = "  " + name;
  bool first = !below && static_cast<int>(name.size()) <= column - 2;
  if (!first) out += '\n';
  for (const std::string& line : io::wrapped(meaning, static_cast<std::size_t>(width - indent))) {
    out += first ? std::string(static_cast<std::size_t>(indent) - 2 - name.size(), ' ')
                 : std::string(static_cast<std::size_t>(indent), ' ');
    out += line + '\n';
    first = false;
  }
  return out;
}

std::string name_of(const OptionManual& option) {
  if (option.positional) return option.value + (option.repeated ? " ..." : "");
  std::string out = option.names;
  std::replace(out.begin(), out.end(), ',', ' ');
  if (out.starts_with("--")) out.insert(0, "   ");  // below those with a letter
  return option.value.empty() ? out : out + ' ' + option.value + (option.repeated ? " ..." : "");
}

std::string usage(const CommandManual& command) {
  const bool program = command.name == "photic";
  std::string out = program ? "photic COMMAND" : "photic " + command.name;
  for (const OptionManual& option : command.options) {
    if (!option.positional) continue;
    const std::string name = option.value + (option.repeated ? "..." : "");
    out += option.required ? ' ' + name : " [" + name + ']';
  }
  return out + " [OPTIONS]\n";
}

std::string options(const CommandManual& command, bool positional, int width) {
  std::string out;
  for (const OptionManual& option : command.options)
    if (option.positional == positional)
      out += entry(name_of(option), option.meaning, name_column, width);
  if (out.empty()) return out;
  return (positional ? "\nArguments\n" : "\nOptions\n") + out;
}

std::string commands(const CommandManual& program, int width) {
  std::string out;
  for (const CommandManual& command : program.commands)
    out += entry(command.name, command.meaning, command_column, width);
  return out.empty() ? out : "\nCommands\n" + out;
}

std::string examples(const CommandManual& command, int width) {
  std::string out;
  for (const auto& [example, meaning] : command.examples)
    out += entry(example, meaning, example_column, width);
  return out.empty() ? out : "\nExamples\n" + out;
}

}  // namespace

std::vector<std::string> names_of(const OptionManual& option) {
  std::vector<std::string> names;
  std::istringstream list(option.names);
  for (std::string name; std::getline(list, name, ',');) names.push_back(name);
  return names;
}

const std::vector<ExitCode>& exit_codes() {
  static const std::vector<ExitCode> all{{0, "done"},
                                         {1, "failed: disk, memory, a program that is missing"},
                                         {2, "bad input: a scene, a result, a command line"},
                                         {130, "ended by Ctrl-C, with a partial result"},
                                         {143, "ended by SIGTERM, with a partial result"}};
  return all;
}

const std::vector<Variable>& variables() {
  static const std::vector<Variable> all{
      {"PHOTIC_DATA", "a folder of data tables in place of Photic's own"},
      {"PHOTIC_PYTHON", "the Python that draws and analyses, in place of the system's"},
      {"NO_COLOR", "if it is set, nothing is coloured"}};
  return all;
}

std::string help(const CommandManual& command, int terminal_width) {
  const int width = usable(terminal_width);
  std::string out = io::paragraph(command.meaning, static_cast<std::size_t>(width), 0) +
                    "\nUsage: " + usage(command);
  out += options(command, true, width) + commands(command, width) + options(command, false, width) +
         examples(command, width);
  if (command.commands.empty()) return out;
  out += "\nExit codes\n";
  for (const auto& [code, meaning] : exit_codes())
    out += entry(fmt::format("{}", code), meaning, command_column, width);
  out += "\nEnvironment\n";
  for (const auto& [name, meaning] : variables()) out += entry(name, meaning, name_column, width);
  return out;
}

std::string short_help(const CommandManual& program, int terminal_width) {
  const int width = usable(terminal_width);
  std::string out = io::paragraph(program.meaning, static_cast<std::size_t>(width), 0) +
                    "\nUsage: " + usage(program);
  out += commands(program, width) + examples(program, width) + '\n';
  return out + io::paragraph("photic help COMMAND describes a command in full.",
                             static_cast<std::size_t>(width), 0);
}

}  // namespace photic::app
