// The subcommands as CLI11 has them. To be included by subcommands.cpp and command_line.cpp alone:
// CLI11 takes seconds to compile.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "photic/commands.hpp"
#include "photic/manual.hpp"

namespace photic::app {

/// The values that the command line fills in.
struct Commands {
  RunCommand run;
  PlotCommand plot;
  AnalyseCommand analyse;
  BenchCommand bench;
  CheckCommand check;
  ShowCommand show;
  OpticsCommand optics;
  NewCommand starter;
  HelpCommand help;
  /// Options that stand for a value of the scene; after --set, since the option wins.
  std::vector<scene::Override> values;
};

/// Notes for the manual that CLI11 does not keep.
struct Notes {
  std::map<const CLI::Option*, std::vector<std::string>> choices;
  std::map<std::string, std::vector<Example>> examples;  ///< of a subcommand; "photic": of all
};

/// Adds all subcommands to the program.
void add_subcommands(CLI::App& program, Commands& commands, Notes& notes);

}  // namespace photic::app
