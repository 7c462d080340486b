#include "photic/subcommands.hpp"

#include <fmt/format.h>

#include <functional>
#include <limits>
#include <stdexcept>

#include "session/quantities.hpp"

namespace photic::app {
namespace {

void add_overrides(CLI::App& app, std::vector<scene::Override>& overrides) {
  app.add_option(
         "--set", overrides,
         "Replace a value of the scene (sea.layer.0.chlorophyll_mg_m3=0.5); may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
}

/// Adds an option whose text is checked when it is read: a std::invalid_argument is reported with
/// the flag.
void add_checked(CLI::App& app, const std::string& flag, const std::string& type,
                 const std::string& description,
                 const std::function<void(const std::string& text)>& take) {
  app.add_option_function<std::string>(
         flag,
         [flag, take](const std::string& text) {
           try {
             take(text);
           } catch (const std::invalid_argument& problem) {
             throw CLI::ValidationError(flag, problem.what());
           }
         },
         description)
      ->type_name(type);
}

/// An option that replaces one value of the scene: the effective scene shows what ran.
void add_scene_value(CLI::App& app, std::vector<scene::Override>& overrides,
                     const std::string& flag, const std::string& type, const std::string& path,
                     const std::string& description, std::string (*value)(const std::string&)) {
  add_checked(app, flag, type, description, [&overrides, path, value](const std::string& text) {
    overrides.push_back(path + "=" + value(text));
  });
}

/// An option that takes one of some words.
void add_choice(CLI::App& app, const std::string& flag, std::string& variable,
                const std::string& type, const std::vector<std::string>& choices,
                const std::string& description, Notes& notes) {
  CLI::Option* option = app.add_option(flag, variable, description)->type_name(type);
  option->check(CLI::IsMember(choices));
  notes.choices[option] = choices;
}

void add_seed(CLI::App& app, std::vector<scene::Override>& overrides) {
  add_scene_value(app, overrides, "--seed", "S", "simulation.seed", "Seed of the random numbers",
                  session::seed_value);
}

void add_threads(CLI::App& app, int& threads, const std::string& description) {
  app.add_option("--threads", threads, description)->type_name("T")->check(CLI::Range(1, 4096));
}

CLI::Option* add_scene(CLI::App& app, std::string& scene, const std::string& description) {
  return app.add_option("scene", scene, description)->type_name("SCENE");
}

void add_json(CLI::App& app, bool& json) { app.add_flag("--json", json, "Print as JSON"); }

/// When a run stops, all of them values of the scene.
void add_ends(CLI::App& sub, std::vector<scene::Override>& values) {
  add_scene_value(sub, values, "--photons", "N", "simulation.photons",
                  "Stop after N photons (1e7 is accepted)", session::photons_value);
  add_scene_value(sub, values, "--target", "SHARE", "simulation.target_relative_error",
                  "Stop when every gate is converged below this relative error (1%)",
                  session::share_value);
  add_scene_value(sub, values, "--max-time", "TIME", "simulation.max_time_s",
                  "Stop after this time (60s, 10min, 2h)", session::seconds_value);
}

void add_run(CLI::App& app, RunCommand& run, std::vector<scene::Override>& values, Notes& notes) {
  CLI::App& sub = *app.add_subcommand("run", "Simulate a scene and write its echoes");
  add_scene(sub, run.scene, "The scene file [with --continue: that of the earlier result]");
  sub.add_option("-o,--output", run.output,
                 "The result: .nc (netCDF), .csv, .txt (the table as printed), or a folder "
                 "[default: the scene's name, .nc, in the current folder]")
      ->type_name("FILE");
  sub.add_option("--continue", run.earlier,
                 "Continue this result or checkpoint of the same scene; photons are the total")
      ->type_name("RESULT.nc");
  add_ends(sub, values);
  add_seed(sub, values);
  add_overrides(sub, run.overrides);
  add_choice(sub, "--table", run.table, "HOW", {"short", "full", "none"},
             "The echoes on the terminal: short (26 gates at most), full (all gates, all "
             "environments) or none [default: short]",
             notes);
  sub.add_flag("-q,--quiet", run.quiet, "Print nothing but remarks, warnings and errors");
  sub.add_flag("--json", run.json, "Print the table of echoes as JSON");
  add_threads(sub, run.threads,
              "Number of threads [default: all cores]; the result does not depend on it");
  add_choice(sub, "--engine", run.engine, "ENGINE", {"scalar", "lanes"},
             "What traces the photons: lanes (many at a time in float) or scalar (in double, the "
             "reference) [default: lanes, or that of the continued result]",
             notes);
  add_choice(sub, "--isa", run.isa, "ISA", {"avx512", "avx2", "baseline"},
             "Instruction set of the lanes: avx512, avx2 or baseline [default: the best that the "
             "processor has]",
             notes);
  add_checked(sub, "--checkpoint", "TIME",
              "Write the result so far this often [default: every 30s, after the first minute]",
              [&run](const std::string& text) { run.checkpoint_s = session::seconds(text); });
  sub.add_flag(
      "--force", run.force,
      "Replace whatever is where the result goes: results of other scenes, of more photons "
      "than this run's, other files");
  notes.examples["run"] = {
      {"photic run my.toml", "the echoes as a table, and my.nc"},
      {"photic run my.toml --target 1% --max-time 10min", "until the errors are small"},
      {"photic run --continue my.nc --photons 1e9 -o my.nc", "more photons for my.nc"},
      {"photic run my.toml -o uv.nc --set source.wavelength_nm=355", "another laser"}};
}

/// Adds `photic plot`. The Python package checks its values.
void add_plot(CLI::App& app, PlotCommand& plot, Notes& notes) {
  CLI::App& sub =
      *app.add_subcommand("plot", "Draw results, or what photic optics wrote, as a picture");
  sub.add_option("results", plot.results, "Results; several are drawn on the same axes")
      ->type_name("RESULT.nc")
      ->required();
  sub.add_option("-o,--output", plot.output,
                 "The picture: .png, .pdf or .svg [default: the first result's name, .png]")
      ->type_name("FILE");
  sub.add_option("--title", plot.title, "A title [default: the scene's]")->type_name("TEXT");
  sub.add_option("--telescope", plot.telescopes, "Only this one; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  sub.add_option("--channel", plot.channels, "Only this one; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  sub.add_option("--width-mm", plot.width_mm, "Width of the picture, for a journal's column")
      ->type_name("MM");
  notes.examples["plot"] = {
      {"photic plot my.nc", "my.png"},
      {"photic plot clear.nc green.nc -o both.pdf", "two results on the same axes"},
      {"photic plot my.nc -o my.svg --width-mm 84", "for one column of a journal"}};
}

/// Adds an option that is passed on, which the Python package checks.
void add_passed_on(CLI::App& sub, std::vector<std::string>& words, const std::string& flag,
                   const std::string& type, const std::string& description) {
  sub.add_option_function<std::string>(
         flag,
         [&words, flag](const std::string& text) {
           words.push_back(fmt::format("{}={}", flag, text));
         },
         description)
      ->type_name(type);
}

/// The same of one that may be given several times.
void add_passed_on_again(CLI::App& sub, std::vector<std::string>& words, const std::string& flag,
                         const std::string& description) {
  sub.add_option_function<std::vector<std::string>>(
         flag,
         [&words, flag](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) words.push_back(fmt::format("{}={}", flag, text));
         },
         description)
      ->type_name("NAME")
      ->allow_extra_args(false);
}

void add_functions(CLI::App& sub, AnalyseCommand& analyse, Notes& notes) {
  CLI::Option* function = sub.add_option(
      "function", analyse.function,
      "range-corrected, k-lidar, z90, ratio, oil-thickness or linear-fit of a result; overlap or "
      "lidar-equation of its scene");
  function->type_name("FUNCTION")->required();
  notes.choices[function] = {"range-corrected", "k-lidar",    "z90",     "ratio",
                             "oil-thickness",   "linear-fit", "overlap", "lidar-equation"};
}

/// The keywords of the functions.
void add_keywords(CLI::App& sub, std::vector<std::string>& words) {
  add_passed_on_again(sub, words, "--telescope", "Only this one; may be repeated");
  add_passed_on_again(sub, words, "--channel",
                      "k-lidar, z90, linear-fit, oil-thickness: the channel; range-corrected, "
                      "overlap, lidar-equation: only this one, may be repeated");
  add_passed_on_again(sub, words, "--environment",
                      "k-lidar, z90, ratio: in this water in place of the scene's; linear-fit: "
                      "through this one [default: all that set the number]; may be repeated");
  add_passed_on(sub, words, "--of", "CHANNEL",
                "ratio, linear-fit: the channel above [default: chlorophyll]");
  add_passed_on(sub, words, "--over", "CHANNEL",
                "ratio, linear-fit: the channel below [default: raman]");
  add_passed_on(sub, words, "--reference", "NAME",
                "ratio, linear-fit: divide by the ratio in this environment");
  add_passed_on(sub, words, "--share", "SHARE",
                "z90, linear-fit: the share of the light above the depth [default: 0.9]");
  sub.add_option_function<std::vector<std::string>>(
         "--depths",
         [&words](const std::vector<std::string>& ends) {
           words.emplace_back("--depths");
           words.insert(words.end(), ends.begin(), ends.end());
         },
         "k-lidar: the first and the last depth of the fit, in m [default: all of the water]")
      ->type_name("FIRST LAST")
      ->expected(2)
      ->allow_extra_args(false);
  add_passed_on(sub, words, "--against", "PATH",
                "linear-fit: the number that environments set [default: that which they set, if it "
                "is one alone]");
  add_passed_on(sub, words, "--clean", "NAME|RESULT.nc",
                "oil-thickness: the sea without the film, an environment or another result");
  add_passed_on(sub, words, "--formula", "FORMULA",
                "oil-thickness: interfaces or paper [default: interfaces]");
}

/// Adds `photic analyse`. The Python package checks its values.
void add_analyse(CLI::App& app, AnalyseCommand& analyse, Notes& notes) {
  CLI::App& sub = *app.add_subcommand("analyse", "Derive numbers from a result, with their errors");
  sub.add_option("file", analyse.file, "The result; for overlap and lidar-equation a scene, too")
      ->type_name("RESULT.nc|SCENE")
      ->required();
  add_functions(sub, analyse, notes);
  add_keywords(sub, analyse.options);
  sub.add_option("-o,--output", analyse.output,
                 "Write them, too: .nc, .csv, or a picture: .png, .pdf or .svg")
      ->type_name("FILE");
  add_json(sub, analyse.json);
  sub.add_flag("--force", analyse.force, "Replace whatever is where the output goes");
  notes.examples["analyse"] = {
      {"photic analyse my.nc k-lidar --channel elastic", "attenuation by depth, and fitted"},
      {"photic analyse my.nc ratio -o ratio.png", "chlorophyll over raman, as a picture, too"},
      {"photic analyse my.nc z90 --channel raman", "the depth of 90 % of the light"},
      {"photic analyse my.toml overlap", "of a scene, before any run"}};
}

void add_bench(CLI::App& app, BenchCommand& bench, std::vector<scene::Override>& values,
               Notes& notes) {
  CLI::App& sub = *app.add_subcommand("bench", "Measure which estimator suits a scene best");
  add_scene(sub, bench.scene, "The scene file")->required();
  add_checked(sub, "--time", "TIME", "Time for all of it [default: 60s]",
              [&bench](const std::string& text) { bench.time_s = session::bench_seconds(text); });
  add_threads(sub, bench.threads, "Number of threads [default: all cores]");
  add_seed(sub, values);
  add_overrides(sub, bench.overrides);
  add_json(sub, bench.json);
  notes.examples["bench"] = {{"photic bench my.toml --time 5min", "surer than in one minute"}};
}

void add_check(CLI::App& app, CheckCommand& check, Notes& notes) {
  CLI::App& sub = *app.add_subcommand("check", "List every problem of a scene");
  add_scene(sub, check.scene, "The scene file")->required();
  add_overrides(sub, check.overrides);
  add_json(sub, check.json);
  notes.examples["check"] = {{"photic check my.toml", "every problem in it, by line"}};
}

void add_show(CLI::App& app, ShowCommand& show, Notes& notes) {
  CLI::App& sub = *app.add_subcommand(
      "show", "Print the scene of a file or a result, every default written out");
  sub.add_option("file", show.file, "A scene file, or a result (.nc)")
      ->required()
      ->type_name("SCENE|RESULT.nc");
  add_overrides(sub, show.overrides);
  add_json(sub, show.json);
  notes.examples["show"] = {{"photic show my.nc", "the scene that a result came from"}};
}

/// "" if it is key=value.
std::string not_a_pair(const std::string& text) {
  const auto equals = text.find('=');
  if (equals != std::string::npos && equals > 0) return "";
  return fmt::format("'{}' is not KEY=VALUE (write chlorophyll_mg_m3=0.5)", text);
}

/// Adds the subjects that may be shown instead of a scene's water.
void add_optics_subjects(CLI::App& sub, OpticsCommand& optics) {
  sub.add_option("--water", optics.water,
                 "Instead of a scene: one layer with these keys (chlorophyll_mg_m3=0.5 "
                 "cdom_a440_per_m=0.02); none: pure water")
      ->type_name("KEY=VALUE")
      ->expected(0, std::numeric_limits<int>::max())
      ->check(CLI::Validator(not_a_pair, ""));
  sub.add_option("--oil", optics.oil,
                 "Instead of a scene: an oil, by its class (light-refined …) or a CSV file of its "
                 "spectra")
      ->type_name("CLASS|FILE");
  sub.add_option(
         "--air", optics.air,
         "Instead of a scene's water: the air, by an atmosphere (us-standard …), a CSV file "
         "of levels, a tape6 or tape7 of MODTRAN, or that of a scene (my.toml)")
      ->type_name("NAME|FILE");
  sub.add_option("--visibility", optics.visibility_km,
                 "With --air: the visibility in km, which sets its aerosols")
      ->type_name("KM");
  sub.add_option("--aerosol", optics.aerosol,
                 "With --air: the aerosols of the lowest 2 km: rural, maritime, urban … [default: "
                 "rural]")
      ->type_name("MODEL");
}

void add_optics(CLI::App& app, OpticsCommand& optics, std::vector<scene::Override>& values,
                Notes& notes) {
  CLI::App& sub = *app.add_subcommand(
      "optics", "List the optical properties of a scene's layers, of water, an oil or air");
  add_scene(sub, optics.scene, "The scene file");
  add_optics_subjects(sub, optics);
  add_checked(
      sub, "--wavelengths", "NM",
      "355,532,685 or 400:700:10 [default: the laser's and those that the channels count; of air "
      "and oil 300:700:50, of a tape7 all]",
      [&optics](const std::string& text) { optics.wavelength_nm = session::wavelengths_nm(text); });
  add_scene_value(sub, values, "--laser", "NM", "source.wavelength_nm",
                  "Wavelength of the light that excites Raman and fluorescence light [default: the "
                  "scene's; 532 with --water]",
                  session::wavelength_value);
  sub.add_option("-o,--output", optics.output, "Write them to a file, .nc or .csv")
      ->type_name("FILE");
  add_overrides(sub, optics.overrides);
  add_json(sub, optics.json);
  notes.examples["optics"] = {
      {"photic optics my.toml", "what its water does to light, and the sources of the numbers"},
      {"photic optics --water chlorophyll_mg_m3=0.5 -o water.nc", "as a file, for other water"}};
}

void add_new(CLI::App& app, NewCommand& starter, Notes& notes) {
  CLI::App& sub = *app.add_subcommand("new", "Write a commented scene to start from");
  sub.add_option("kind", starter.kind, "Which one: --list shows all")->type_name("KIND");
  sub.add_flag("--list", starter.list, "List what there is, a line each");
  sub.add_option("-o,--output", starter.output,
                 "The file to write [default: standard output]; never an existing one")
      ->type_name("FILE");
  notes.examples["new"] = {{"photic new ship -o my.toml", "a ship lidar over clear ocean water"}};
}

}  // namespace

void add_subcommands(CLI::App& program, Commands& commands, Notes& notes) {
  add_run(program, commands.run, commands.values, notes);
  add_plot(program, commands.plot, notes);
  add_analyse(program, commands.analyse, notes);
  add_new(program, commands.starter, notes);
  add_check(program, commands.check, notes);
  add_show(program, commands.show, notes);
  add_optics(program, commands.optics, commands.values, notes);
  add_bench(program, commands.bench, commands.values, notes);
  program.add_subcommand("schema", "Print the JSON Schema of scene files, for editors");
  program.add_subcommand("help", "Describe the program, or a command in full")
      ->add_option("command", commands.help.command, "The command to describe")
      ->type_name("COMMAND");
  notes.examples["photic"] = {{"photic new ship -o my.toml", "a commented scene to start from"},
                              {"photic check my.toml", "every problem in it"},
                              {"photic run my.toml", "simulate it; the result is my.nc"},
                              {"photic plot my.nc -o my.png", "its echoes as a picture"}};
}

}  // namespace photic::app
