// The program's output besides results (io/), and the places of results.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace photic::app {

struct Call;
struct RunCommand;

/// A command line that cannot be followed; the text says what to write instead.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes the text to standard error; a failure cannot be reported anywhere.
void print_error(std::string_view text);

/// The same of what is not wrong, but should be seen; coloured on a terminal.
void print_warning(std::string_view text);

/// Writes problems to standard error, coloured on a terminal: where, and why.
void print_problems(const std::vector<Diagnostic>& problems);

/// A table of echoes or a summary to standard output, its flags and warnings coloured on a
/// terminal. Throws as print_out.
void print_table(const std::string& text);

/// Writes the text to standard output. Throws EnvironmentError (a full disk behind a redirection).
void print_out(std::string_view text);

/// The format that a file's name states, in small letters or capitals: .nc, .csv or .txt.
enum class Format { netcdf, csv, text };
std::optional<Format> format_of(const std::string& file);

/// Returns whether an output is a folder: by its name, or because one is there.
bool is_folder(const std::string& output);

/// The output of a run: the one given, or the scene's name with .nc, in the folder that is given,
/// which is made if it is not there, or in the current one; where no scene is given, the name of
/// the earlier result. Throws UsageError unless it has a Format and is another file than the scene,
/// EnvironmentError for a folder that cannot be made.
std::string result_path(const RunCommand& command);

/// Checks an output that is .nc or .csv, is no result of a run, and must replace none. Throws
/// UsageError.
void check_optics_output(const std::string& output, const std::string& scene);

/// Throws UsageError if the output is one of the files that it is made of.
void spare(const std::vector<std::string>& inputs, const std::string& output);

/// The command that goes on from a result file and writes the longer one.
std::string go_on_command(const Call& call, const std::string& earlier, const std::string& output);

/// "Plot it:  photic plot my.nc -o my.png": nothing for what no plot can be made of.
std::string plot_hint(const Call& call, const std::string& file);

/// Writes a file that must not exist yet; false if it does, with this very text. Throws UsageError
/// if it holds anything else, with what to do about it, EnvironmentError on failure.
bool write_new_file(const std::string& path, std::string_view text, std::string_view advice);

}  // namespace photic::app
