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
#include "photic/checkpoint.hpp"
#include "photic/commands.hpp"
#include "photic/occupant.hpp"

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

void print_out(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (std::fflush(stdout) != 0 || !written) fail("cannot write to standard output");
}

std::string result_path(const RunCommand& command) {
  const std::string& output = command.output;
  if (output.empty()) {
    const std::string named_after =
        command.scene.empty() ? without_checkpoint(command.earlier) : command.scene;
    return fs::path(named_after).filename().replace_extension(".nc").string();
  }
  check_output(output, command.scene);
  return output;
}

void check_output(const std::string& output, const std::string& scene) {
  const std::string kind = fs::path(output).extension().string();
  if (kind != ".nc" && kind != ".csv") {
    throw UsageError(output + ": the result's name ends neither in .nc nor in .csv (write -o " +
                     output + ".nc)");
  }
  std::error_code none;
  if (fs::equivalent(output, scene, none))
    throw UsageError(output + ": the result would replace the scene (choose another name with -o)");
}

void check_optics_output(const std::string& output, const std::string& scene) {
  check_output(output, scene);
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

/// Whether a file is there and says just this.
bool holds(const std::string& path, std::string_view text) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream there;
  return file.is_open() && file.peek() != std::ifstream::traits_type::eof() &&
         there << file.rdbuf() && there.view() == text;
}

}  // namespace

std::string go_on_command(const std::string& earlier, const std::string& output) {
  return fmt::format("photic run --continue {} -o {}", earlier, output);
}

bool write_new_file(const std::string& path, std::string_view text) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wx"),
                                                             &std::fclose);
  if (!file && errno == EEXIST) {
    if (holds(path, text)) return false;
    throw UsageError(path + ": exists already and was left as it is (choose another name with -o)");
  }
  if (!file) fail("cannot write " + path);
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  if (std::fflush(file.get()) != 0 || !written) fail("cannot write " + path);
  return true;
}

}  // namespace photic::app
