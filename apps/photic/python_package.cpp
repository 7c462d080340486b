#include "photic/python_package.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "core/error.hpp"
#include "photic/program.hpp"
#include "photic/shell.hpp"

namespace photic::app {
namespace {

namespace fs = std::filesystem;

/// The Python package that belongs to this program: beside it under a prefix, or in the build
/// folder.
fs::path package() {
  const std::vector<fs::path> places{program_prefix() / "lib/python3/dist-packages/photic",
                                     PHOTIC_BUILD_PACKAGE};
  std::error_code none;
  for (const fs::path& place : places)
    if (fs::is_regular_file(place / "__main__.py", none)) return place;
  throw EnvironmentError(
      fmt::format("the Python package photic is neither in {} nor in {}: install Photic "
                  "again (cmake --install, or its Debian package)",
                  places[0].string(), places[1].string()));
}

/// Prints the modules that a Python lacks.
constexpr const char* list_missing =
    "import importlib.util as u, sys; "
    "print('lacks:', *[m for m in sys.argv[1:] if not u.find_spec(m)])";

/// Runs the package without its folder among the places where Python looks for modules: what lies
/// beside it (all of Debian's packages) may be for another Python.
constexpr const char* run_package =
    "import importlib.util as u, sys; "
    "s = u.spec_from_file_location('photic', sys.argv[1] + '/__init__.py', "
    "submodule_search_locations=[sys.argv[1]]); "
    "m = u.module_from_spec(s); sys.modules['photic'] = m; s.loader.exec_module(m); "
    "from photic.__main__ import main; sys.exit(main(sys.argv[2:]))";

struct Python {
  std::string program;
  std::string problem;  ///< empty: it has the modules
};

/// Asks a Python which of the modules it lacks.
Python look_at(const std::string& program, const std::vector<std::string>& modules) {
  const std::string ask =
      fmt::format("{} -c {} {}", quoted(program), quoted(list_missing), fmt::join(modules, " "));
  std::FILE* pipe = popen((ask + " 2>/dev/null </dev/null").c_str(), "r");
  if (pipe == nullptr) return {program, "cannot be started"};
  std::string missing;
  std::array<char, 256> part{};
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), pipe))
    missing.append(part.data(), count);
  const std::string head = "lacks:";
  if (pclose(pipe) != 0 || !missing.starts_with(head))
    return {program, "is not there, or does not start"};
  missing = missing.substr(head.size());
  missing.erase(missing.find_last_not_of("\n ") + 1);
  return {program, missing.empty() ? "" : "lacks" + missing};
}

/// The Python that the user names, else the first that has the modules: Debian's, whose packages
/// Photic's depends on, or the first in the PATH.
std::string python(const PythonUse& use) {
  const char* named = std::getenv("PHOTIC_PYTHON");
  const bool asked = named != nullptr && *named != '\0';
  std::vector<std::string> candidates{"/usr/bin/python3", "python3"};
  if (asked) candidates = {named};
  std::string problems;
  for (const std::string& candidate : candidates) {
    const Python found = look_at(candidate, use.modules);
    if (found.problem.empty()) return found.program;
    problems += (problems.empty() ? "" : "; ") + found.program + ' ' + found.problem;
  }
  throw EnvironmentError(
      fmt::format("no Python that can {}: {} ({})", use.purpose, problems,
                  asked ? "PHOTIC_PYTHON names it"
                        : "on Debian: apt install python3-numpy python3-xarray python3-netcdf4 "
                          "python3-matplotlib; PHOTIC_PYTHON names another Python"));
}

/// Becomes the other program; its exit code is what the user gets.
[[noreturn]] void become(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(arguments.front(), arguments.data());
  throw EnvironmentError(fmt::format("cannot start {}", words.front()));
}

}  // namespace

void become_package(const PythonUse& use, const std::vector<std::string>& words) {
  const fs::path package = app::package();
  std::vector<std::string> all{python(use), "-c", run_package, package.string()};
  all.insert(all.end(), words.begin(), words.end());
  become(std::move(all));
}

}  // namespace photic::app
