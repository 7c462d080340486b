// What the program writes besides results (io/) and where results go.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace photic::app {

struct RunCommand;

/// A command line that cannot be followed; the text says what to write instead.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes the text to standard error; nobody is left to tell if that fails.
void print_error(std::string_view text);

/// Writes the text to standard output. Throws EnvironmentError (a full disk behind a redirection).
void print_out(std::string_view text);

/// The output of a run: the one given, or the scene's name with .nc in the current folder; where no
/// scene is given, the name of the earlier result. Throws UsageError unless it ends in .nc or .csv
/// and is another file than the scene.
std::string result_path(const RunCommand& command);

/// Throws UsageError unless the name of a command's output ends in .nc or .csv and is another file
/// than its scene.
void check_output(const std::string& output, const std::string& scene);

/// The same for what is no result of a run, and must replace none.
void check_optics_output(const std::string& output, const std::string& scene);

/// Throws UsageError if the output is one of the files that it is made of.
void spare(const std::vector<std::string>& inputs, const std::string& output);

/// What goes on from a result file and writes the longer one.
std::string go_on_command(const std::string& earlier, const std::string& output);

/// Writes a file that must not exist yet; false if it does, with this very text. Throws UsageError
/// if it holds anything else, EnvironmentError on failure.
bool write_new_file(const std::string& path, std::string_view text);

}  // namespace photic::app
