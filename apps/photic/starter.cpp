#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "io/table_parts.hpp"
#include "photic/commands.hpp"
#include "photic/output.hpp"
#include "photic/program.hpp"
#include "photic/terminal.hpp"
#include "session/result_file.hpp"

namespace photic::app {
namespace {

namespace fs = std::filesystem;

/// The line by which editors find the schema of scenes; none where there is no schema beside this
/// program: that of an installation, or of the build.
std::string schema_line() {
  std::error_code none;
  // Under a prefix, or in a build folder, where the program is in apps/photic.
  for (const char* place : {"share/photic/scenes", "../scenes"}) {
    const fs::path schema = (program_prefix() / place / "scene.schema.json").lexically_normal();
    if (fs::is_regular_file(schema, none)) return fmt::format("#:schema {}\n", schema.string());
  }
  return "";
}

/// The commands in a scene's comments name its file, "photic run my.toml" for "photic run
/// ship.toml"; but no name that would not stay in its line.
void call_by_name(std::string& text, const std::string& kind, const fs::path& file) {
  const auto breaks_lines = [](unsigned char c) { return std::iscntrl(c) != 0; };
  if (std::ranges::any_of(file.string(), breaks_lines)) return;
  for (const char* ending : {".toml", ".nc"}) {
    const std::string before = kind + ending;
    const std::string name = quoted(as_file(fs::path(file).replace_extension(ending).string()));
    for (auto at = text.find(before); at != std::string::npos;
         at = text.find(before, at + name.size()))
      text.replace(at, before.size(), name);
  }
}

std::string outcome(const std::string& file, bool written) {
  return file + (written ? ": written" : ": exists already");
}

/// The files that a scene reads go into its folder. Throws as write_new_file.
void write_files_of(const std::string& kind, const fs::path& folder) {
  for (const scene::StarterFile& file : scene::starter_files(kind)) {
    const std::string path = (folder / file.name).string();
    const bool written = write_new_file(path, file.text, "choose another folder with -o");
    print_out(outcome(path, written) + '\n');
  }
}

/// Names the files of a scene that went to standard output.
void report_files_of(const std::string& kind) {
  for (const scene::StarterFile& file : scene::starter_files(kind))
    print_warning(
        fmt::format("the scene reads {0}: photic new {1} -o FILE writes both\n", file.name, kind));
}

std::string list_of_kinds() {
  constexpr int no_terminal = 200;  // a line each
  const auto width = static_cast<std::size_t>(columns(Stream::out, no_terminal));
  std::string out;
  for (const auto& [kind, summary] : scene::starter_kinds())
    out += io::paragraph(fmt::format("{}: {}", kind, summary), width);
  return out;
}

}  // namespace

int run(const NewCommand& command) {
  if (command.list) {
    print_out(list_of_kinds());
    return done;
  }
  std::string text = schema_line() + scene::starter_scene(command.kind);
  if (command.output.empty()) {
    print_out(text);
    report_files_of(command.kind);
    return done;
  }
  const std::string output = session::is_folder(command.output)
                                 ? (fs::path(command.output) / (command.kind + ".toml")).string()
                                 : command.output;
  call_by_name(text, command.kind, fs::path(output).filename());
  write_files_of(command.kind, fs::path(output).parent_path());
  const bool written = write_new_file(output, text, "choose another name with -o");
  print_out(outcome(output, written) +
            "; check it with: " + command.call.command({"check", as_file(output)}) + '\n');
  return done;
}

}  // namespace photic::app
