// What the program writes besides results (io/) and where results go.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace photic::app {

/// A command line that cannot be followed; the text says what to write instead.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes the text to standard error; nobody is left to tell if that fails.
void print_error(std::string_view text);

/// Writes the text to standard output. Throws EnvironmentError (a full disk behind a redirection).
void print_out(std::string_view text);

/// The output given, or the scene's name with .nc in the current folder.
/// Throws UsageError unless it ends in .nc or .csv and is another file than the scene.
std::string result_path(const std::string& output, const std::string& scene);

/// Writes a file that must not exist yet. Throws UsageError if it does, EnvironmentError on
/// failure.
void write_new_file(const std::string& path, std::string_view text);

}  // namespace photic::app
