#include "photic/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "photic/output.hpp"
#include "photic/subcommands.hpp"
#include "photic/terminal.hpp"
#include "scene/suggest.hpp"

namespace photic::app {
namespace {

constexpr int no_terminal = 80;  // columns of help in a file

OptionManual manual_of(const CLI::Option& option, const Notes& notes) {
  OptionManual out;
  out.positional = option.get_positional();
  out.names = out.positional ? option.get_name(true) : option.get_name(false, true);
  if (option.get_type_size() != 0) out.value = option.get_type_name();
  // CLI11 appends what validators say of themselves.
  out.value.resize(std::min(out.value.size(), out.value.find(':')));
  out.meaning = option.get_description();
  out.required = option.get_required();
  const bool several = option.get_expected_max() > 1;
  out.repeated = several && (out.positional || option.get_allow_extra_args());
  out.again = several && !out.repeated;
  if (const auto choices = notes.choices.find(&option); choices != notes.choices.end())
    out.choices = choices->second;
  return out;
}

CommandManual manual_of(const CLI::App& app, const Notes& notes) {
  CommandManual out{app.get_name(), app.get_description(), {}, {}, {}};
  for (const CLI::Option* option : app.get_options({}))
    out.options.push_back(manual_of(*option, notes));
  if (const auto found = notes.examples.find(out.name); found != notes.examples.end())
    out.examples = found->second;
  for (const CLI::App* sub : app.get_subcommands({}))
    if (!sub->get_group().empty()) out.commands.push_back(manual_of(*sub, notes));
  return out;
}

/// Either a scene or water without one, or an oil or air.
void expect_scene_or_water(const CLI::App& optics) {
  const bool scene = optics.count("scene") > 0, water = optics.count("--water") > 0;
  const bool air = optics.count("--air") > 0;
  for (const char* of_air : {"--visibility", "--aerosol"})
    if (!air && optics.count(of_air) > 0) throw CLI::RequiresError(of_air, "--air");
  if (air || optics.count("--oil") > 0) {
    const char* alone = air ? "--air" : "--oil";
    const bool scenes = air && optics.get_option("--air")->as<std::string>().ends_with(".toml");
    for (const char* other : {"scene", "--water", "--oil", "--laser", "--set"})
      if (optics.count(other) > 0 && std::string(other) != alone &&
          !(scenes && std::string(other) == "--set"))
        throw CLI::ExcludesError(fmt::format("{} and {} exclude each other", alone, other),
                                 CLI::ExitCodes::ExcludesError);
    return;
  }
  if (!scene && !water) throw CLI::RequiredError("scene, --water, --oil or --air");
  if (scene && water)
    throw CLI::ExcludesError("scene and --water exclude each other: write --set for a scene",
                             CLI::ExitCodes::ExcludesError);
}

std::vector<std::string> names_of_commands(const CommandManual& program) {
  std::vector<std::string> out;
  for (const CommandManual& command : program.commands) out.push_back(command.name);
  return out;
}

/// A word that is no command, and why: files have commands of their own.
std::string command_for(const std::string& word, const std::vector<std::string>& known) {
  if (word.ends_with(".toml")) return fmt::format("did you mean: photic run {}?", word);
  if (word.ends_with(".nc")) return fmt::format("did you mean: photic plot {}?", word);
  return scene::suggestion_for(word, known, "there are");
}

/// CLI11 would only say that a subcommand is required.
void expect_known_command(const CommandManual& program, const std::string& word) {
  const auto known = names_of_commands(program);
  if (std::ranges::find(known, word) != known.end()) return;
  throw CLI::ExtrasError("there is no subcommand '" + word + "' (" + command_for(word, known) + ")",
                         CLI::ExitCodes::ExtrasError);
}

/// "did you mean '--photons'?" for what looks like an option and is none of the command's.
std::string option_for(const CLI::App& app, const std::vector<std::string>& left) {
  std::vector<std::string> known;
  for (const CLI::App* sub : app.get_subcommands())
    for (const CLI::Option* option : sub->get_options({}))
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  for (const std::string& word : left)
    if (word.starts_with("--"))
      return word + ": " +
             scene::suggestion_for(word.substr(0, word.find('=')), known, "there are");
  return "";
}

/// Checks what a subcommand needs, and CLI11 cannot know.
void expect_complete(const CLI::App& app, const Commands& commands) {
  for (const CLI::App* sub : app.get_subcommands())
    for (const CLI::Option* option : sub->get_options({}))
      if (option->check_lname("output") && option->count() > 0 && option->as<std::string>().empty())
        throw CLI::ValidationError("--output", "a name is empty");
  if (app.got_subcommand("run") && commands.run.scene.empty() && commands.run.earlier.empty())
    throw CLI::RequiredError("scene");
  if (app.got_subcommand("new") && commands.starter.kind.empty() && !commands.starter.list)
    throw CLI::RequiredError("kind");
  if (app.got_subcommand("optics")) expect_scene_or_water(*app.get_subcommand("optics"));
}

Command chosen(const CLI::App& app, Commands& all, const Call& call) {
  for (auto* overrides : {&all.run.overrides, &all.bench.overrides, &all.optics.overrides})
    overrides->insert(overrides->end(), all.values.begin(), all.values.end());
  std::erase(all.optics.water, "");  // the value that CLI11 gives for --water without keys
  all.run.call = all.plot.call = all.optics.call = all.starter.call = call;
  if (app.got_subcommand("run")) return all.run;
  if (app.got_subcommand("plot")) return all.plot;
  if (app.got_subcommand("analyse")) return all.analyse;
  if (app.got_subcommand("bench")) return all.bench;
  if (app.got_subcommand("check")) return all.check;
  if (app.got_subcommand("show")) return all.show;
  if (app.got_subcommand("optics")) return all.optics;
  if (app.got_subcommand("new")) return all.starter;
  if (app.got_subcommand("help")) return all.help;
  return SchemaCommand{};
}

}  // namespace

Parsed parse_command_line(int argc, const char* const* argv) {
  CLI::App app("Photic simulates what a lidar over or in the sea will see.", "photic");
  app.require_subcommand(1);
  bool version = false;
  app.add_flag("--version", version, "Print version, compiler, instruction sets and data folder");
  Commands commands;
  Notes notes;
  add_subcommands(app, commands, notes);
  app.formatter(std::make_shared<CLI::FormatterLambda>(
      [&notes](const CLI::App* asked, const std::string&, CLI::AppFormatMode) {
        return help(manual_of(*asked, notes), columns(Stream::out, no_terminal));
      }));
  for (CLI::App* sub : app.get_subcommands({})) sub->formatter(app.get_formatter());

  const Call call = call_of(argc, argv);
  const CommandManual manual = manual_of(app, notes);
  if (call.words.empty()) return {HelpCommand{"", manual}, done};
  if (call.words.front() == "--version") return {VersionCommand{}, done};
  // Commands for shells and for packages, which no help lists.
  if (call.words == std::vector<std::string>{"manual"}) return {ManualCommand{manual}, done};
  if (call.words.size() > 2 && call.words[0] == "complete" && call.words[1] == "--")
    return {CompleteCommand{{call.words.begin() + 2, call.words.end()}, manual}, done};
  try {
    if (!call.words.front().starts_with("-")) expect_known_command(manual, call.words.front());
    app.parse(argc, argv);
    expect_complete(app, commands);
    commands.help.program = manual;
    if (!commands.help.command.empty()) expect_known_command(manual, commands.help.command);
  } catch (const CLI::ParseError& end) {
    const bool asked = app.exit(end) == 0;
    if (const std::string hint = option_for(app, app.remaining(true)); !asked && !hint.empty())
      print_error(hint + '\n');
    return {std::nullopt, asked ? done : bad_input};
  }
  return {chosen(app, commands, call), done};
}

}  // namespace photic::app
