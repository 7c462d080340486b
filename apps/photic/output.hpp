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

/// Checks an output that is .nc or .csv, is no result of a run, and must replace none. Throws
/// UsageError.
void check_optics_output(const std::string& output, const std::string& scene);

/// The command that goes on from a result file and writes the longer one.
std::string go_on_command(const Call& call, const std::string& earlier, const std::string& output);

/// "Plot it:  photic plot my.nc -o my.png": nothing for what no plot can be made of.
std::string plot_hint(const Call& call, const std::string& file);

/// Writes a file that must not exist yet; false if it does, with this very text. Throws UsageError
/// if it holds anything else, with what to do about it, EnvironmentError on failure.
bool write_new_file(const std::string& path, std::string_view text, std::string_view advice);

}  // namespace photic::app
