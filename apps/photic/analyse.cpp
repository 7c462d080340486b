#include <fmt/format.h>

#include <filesystem>

#include "photic/commands.hpp"
#include "photic/python_package.hpp"

namespace photic::app {
namespace {

namespace fs = std::filesystem;

bool draws(const std::string& output) {
  const std::string ending = fs::path(output).extension().string();
  return !ending.empty() && ending != ".nc" && ending != ".csv";
}

std::vector<std::string> words_of(const AnalyseCommand& command) {
  std::vector<std::string> words{"analyse"};
  words.insert(words.end(), command.options.begin(), command.options.end());
  if (!command.output.empty()) {
    words.emplace_back("-o");
    words.push_back(as_file(command.output));
  }
  if (command.json) words.emplace_back("--json");
  if (command.force) words.emplace_back("--force");
  words.insert(words.end(), {"--", command.file, command.function});
  return words;
}

}  // namespace

int run(const AnalyseCommand& command) {
  PythonUse use{"analyse results", {"numpy", "xarray", "netCDF4"}};
  if (draws(command.output)) use.modules.emplace_back("matplotlib");
  become_package(use, words_of(command));
}

}  // namespace photic::app
