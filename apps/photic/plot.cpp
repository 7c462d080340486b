#include <fmt/format.h>

#include <filesystem>

#include "photic/commands.hpp"
#include "photic/python_package.hpp"

namespace photic::app {
namespace {

namespace fs = std::filesystem;

std::string picture_of(const PlotCommand& command) {
  if (!command.output.empty()) return command.output;
  return fs::path(command.results.front()).filename().replace_extension(".png").string();
}

std::vector<std::string> words_of(const PlotCommand& command) {
  std::vector<std::string> words{"plot", "-o", as_file(picture_of(command))};
  const auto add = [&words](const char* flag, const std::string& value) {
    if (!value.empty()) words.push_back(fmt::format("{}={}", flag, value));
  };
  add("--title", command.title);
  add("--width-mm", command.width_mm);
  for (const std::string& telescope : command.telescopes) add("--telescope", telescope);
  for (const std::string& channel : command.channels) add("--channel", channel);
  words.emplace_back("--");
  words.insert(words.end(), command.results.begin(), command.results.end());
  return words;
}

}  // namespace

int run(const PlotCommand& command) {
  become_package({"draw plots", {"numpy", "xarray", "netCDF4", "matplotlib"}}, words_of(command));
}

}  // namespace photic::app
