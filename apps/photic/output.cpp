#include "photic/output.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "core/error.hpp"
#include "photic/checkpoint.hpp"
#include "photic/commands.hpp"
#include "photic/occupant.hpp"
#include "photic/terminal.hpp"

namespace photic::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what) {
  throw EnvironmentError(fmt::format("{}: {}", what, std::strerror(errno)));
}

}  // namespace

void print_error(std::string_view text) {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

void print_warning(std::string_view text) {
  print_error(painted(text, Colour::yellow, Stream::error));
}

void print_problems(const std::vector<Diagnostic>& problems) {
  std::string text;
  for (const Diagnostic& problem : problems) {
    Diagnostic place = problem;
    place.reason = place.suggestion = "";
    const std::string whole = problem.text(), where = place.text();
    const std::size_t end = whole.starts_with(where) ? where.size() : 0;
    text += painted(whole.substr(0, end), Colour::bold, Stream::error) + whole.substr(end) + '\n';
  }
  print_error(text);
}

namespace {

/// A line of a table: '*' marks what has not converged; a warning begins with "warning:" and may
/// take several lines, which are set back.
std::string coloured(const std::string& line, bool& in_warning) {
  in_warning = line.starts_with("warning: ") || (in_warning && line.starts_with("  "));
  if (in_warning) return painted(line, Colour::yellow, Stream::out);
  if (line.starts_with("converged") || line.starts_with("stopped by"))
    return painted(line, Colour::bold, Stream::out);
  std::string out;
  for (const char c : line)
    out += c == '*' ? painted("*", Colour::yellow, Stream::out) : std::string(1, c);
  return out;
}

}  // namespace

void print_table(const std::string& text) {
  std::string out;
  bool in_warning = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) out += coloured(line, in_warning) + '\n';
  print_out(out);
}

void print_out(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (std::fflush(stdout) != 0 || !written) fail("cannot write to standard output");
}

std::optional<Format> format_of(const std::string& file) {
  std::string kind = fs::path(file).extension().string();
  for (char& c : kind) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (kind == ".nc") return Format::netcdf;
  if (kind == ".csv") return Format::csv;
  if (kind == ".txt") return Format::text;
  return std::nullopt;
}

bool is_folder(const std::string& output) {
  std::error_code none;
  return output.ends_with('/') || fs::is_directory(output, none);
}

namespace {

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw EnvironmentError(fmt::format("cannot make the folder {}: {}", folder, error.message()));
}

void spare_scene(const std::string& output, const std::string& scene) {
  std::error_code none;
  if (fs::equivalent(output, scene, none))
    throw UsageError(output + ": the result would replace the scene (choose another name with -o)");
}

}  // namespace

std::string result_path(const RunCommand& command) {
  const std::string& output = command.output;
  const std::string named_after =
      command.scene.empty() ? without_checkpoint(command.earlier) : command.scene;
  std::string name = fs::path(named_after).filename().replace_extension(".nc").string();
  if (output.empty()) return name;
  if (is_folder(output)) {
    make_folder(output);
    return (fs::path(output) / name).string();
  }
  if (!format_of(output))
    throw UsageError(output + ": the result's name ends in none of .nc, .csv and .txt (write -o " +
                     output + ".nc, or -o " + output + "/ for a folder)");
  spare_scene(output, command.scene);
  return output;
}

void check_optics_output(const std::string& output, const std::string& scene) {
  const auto format = format_of(output);
  if (format != Format::netcdf && format != Format::csv)
    throw UsageError(output + ": the result's name ends neither in .nc nor in .csv (write -o " +
                     output + ".nc)");
  spare_scene(output, scene);
  if (holds_echoes(output))
    throw UsageError(output +
                     ": holds echoes of a run, and is left as it is (choose another name with -o)");
}

void spare(const std::vector<std::string>& inputs, const std::string& output) {
  std::error_code none;
  for (const std::string& input : inputs) {
    if (fs::equivalent(output, input, none))
      throw UsageError(output +
                       ": the result would replace a file that it is made of "
                       "(choose another name with -o)");
  }
}

namespace {

/// Returns whether a file is there and has just this text.
bool holds(const std::string& path, std::string_view text) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream there;
  return file.is_open() && file.peek() != std::ifstream::traits_type::eof() &&
         there << file.rdbuf() && there.view() == text;
}

}  // namespace

std::string go_on_command(const Call& call, const std::string& earlier, const std::string& output) {
  return call.command({"run", "--continue", as_file(earlier), "-o", as_file(output)});
}

std::string plot_hint(const Call& call, const std::string& file) {
  if (format_of(file) != Format::netcdf) return "";
  const std::string picture = fs::path(file).replace_extension(".png").string();
  return "Plot it:  " + call.command({"plot", as_file(file), "-o", as_file(picture)}) + '\n';
}

bool write_new_file(const std::string& path, std::string_view text, std::string_view advice) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wx"),
                                                             &std::fclose);
  if (!file && errno == EEXIST) {
    if (holds(path, text)) return false;
    throw UsageError(fmt::format("{}: exists already and was left as it is ({})", path, advice));
  }
  if (!file) fail("cannot write " + path);
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  if (std::fflush(file.get()) != 0 || !written) fail("cannot write " + path);
  return true;
}

}  // namespace photic::app
