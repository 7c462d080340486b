#include <fmt/format.h>

#include "photic/commands.hpp"
#include "photic/output.hpp"

namespace photic::app {
namespace {

/// Text as roff reads it.
std::string roff_text(const std::string& text) {
  std::string out = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

std::string roff_bold(const std::string& text) { return "\\fB" + roff_text(text) + "\\fR"; }
std::string roff_italic(const std::string& text) { return "\\fI" + roff_text(text) + "\\fR"; }

std::string roff_entry(const std::string& head, const std::string& text) {
  return fmt::format(".TP\n{}\n{}\n", head, roff_text(text));
}

std::string roff_name(const OptionManual& option) {
  std::string out;
  if (!option.positional)
    for (const std::string& name : names_of(option))
      out += (out.empty() ? "" : ", ") + roff_bold(name);
  if (!option.value.empty()) out += (out.empty() ? "" : " ") + roff_italic(option.value);
  return out + (option.repeated ? " ..." : "");
}

std::string roff_options(const CommandManual& command) {
  std::string out;
  for (const bool positional : {true, false})
    for (const OptionManual& option : command.options)
      if (option.positional == positional) out += roff_entry(roff_name(option), option.meaning);
  return out;
}

std::string roff_examples(const CommandManual& command) {
  std::string out;
  for (const auto& [example, meaning] : command.examples)
    out += roff_entry(roff_bold(example), meaning);
  return out;
}

std::string roff_commands(const CommandManual& program) {
  std::string out = ".SH COMMANDS\n";
  for (const CommandManual& command : program.commands) {
    out += fmt::format(".SS photic {}\n{}.\n{}", command.name, roff_text(command.meaning),
                       roff_options(command));
    if (!command.examples.empty()) out += ".PP\nExamples:\n" + roff_examples(command);
  }
  return out;
}

std::string roff_surroundings() {
  std::string out = ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : exit_codes())
    out += roff_entry(roff_bold(std::to_string(code)), meaning);
  out += ".SH ENVIRONMENT\n";
  for (const auto& [name, meaning] : variables()) out += roff_entry(roff_bold(name), meaning);
  return out + ".SH FILES\n" +
         roff_entry(roff_italic("PREFIX/share/photic"),
                    "data tables and example scenes; PREFIX is /usr of /usr/bin/photic") +
         roff_entry(roff_italic("NAME.checkpoint.nc"),
                    "the result so far of a run that writes NAME.nc, for --continue") +
         roff_entry(roff_italic("NAME.previous.nc"), "the older result that a run has replaced");
}

std::string man_page(const CommandManual& program) {
  return fmt::format(
             ".TH PHOTIC 1 \"\" \"photic {}\" \"User Commands\"\n"
             ".SH NAME\nphotic \\- simulator of oceanographic lidar\n"
             ".SH SYNOPSIS\n.B photic\n.I COMMAND\n[options]\n"
             ".SH DESCRIPTION\n{}\n"
             "A scene, in a TOML file, describes the instrument and the water; the result, a "
             "netCDF file, holds echoes by range with their errors.\n"
             ".SH OPTIONS\n",
             PHOTIC_VERSION, roff_text(program.meaning)) +
         roff_options(program) + roff_commands(program) + ".SH EXAMPLES\n" +
         roff_examples(program) + roff_surroundings() +
         ".SH SEE ALSO\n.BR ncdump (1)\n.PP\nThe user guide and the theory: " +
         roff_italic("PREFIX/share/doc/photic/docs") + "\n";
}

}  // namespace

int run(const ManualCommand& command) {
  print_out(man_page(command.program));
  return done;
}

}  // namespace photic::app
