#include "photic/output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "core/error.hpp"
#include "photic/commands.hpp"
#include "photic/terminal.hpp"
#include "session/occupant.hpp"
#include "session/result_file.hpp"

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

void check_optics_output(const std::string& output, const std::string& scene) {
  const auto format = session::format_of(output);
  if (format != session::Format::netcdf && format != session::Format::csv)
    throw UsageError(output + ": the result's name ends neither in .nc nor in .csv (write -o " +
                     output + ".nc)");
  session::spare_scene(output, scene);
  if (session::holds_echoes(output))
    throw UsageError(output +
                     ": holds echoes of a run, and is left as it is (choose another name with -o)");
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
  if (session::format_of(file) != session::Format::netcdf) return "";
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
