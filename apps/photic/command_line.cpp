#include "photic/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <limits>
#include <stdexcept>

#include "photic/quantities.hpp"
#include "scene/suggest.hpp"

namespace photic::app {
namespace {

constexpr const char* examples = R"(
Examples:
  photic new ship -o my.toml              a commented scene to start from
  photic check my.toml                    all that is wrong with it
  photic run my.toml                      simulate it; the result is my.nc
  photic run my.toml --target 1% --max-time 10min
  photic run my.toml --continue my.nc --photons 1e9
  photic run my.toml --set sea.layer.0.chlorophyll_mg_m3=0.5 -o green.nc
  photic bench my.toml                    which estimator suits it best
  photic show my.nc                       the scene that a result came from
  photic optics my.toml                   what its water does to light, and whose numbers these are
  photic optics --water chlorophyll_mg_m3=0.5 --wavelengths 400:700:10 -o water.nc

Exit codes: 0 done, 1 failed (disk, memory), 2 bad input, 130 after Ctrl-C, 143 after SIGTERM.)";

/// "photic run 'my scene.toml'": could be pasted into a shell.
std::string as_typed(int argc, const char* const* argv) {
  std::string out = "photic";
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (!word.empty() && word.find_first_of(" \t\n'\"\\$*?[]{}();&|<>#~`!") == std::string::npos) {
      out += ' ' + word;
      continue;
    }
    out += " '";
    for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    out += '\'';
  }
  return out;
}

void add_overrides(CLI::App& app, std::vector<scene::Override>& overrides) {
  app.add_option(
         "--set", overrides,
         "Replace a value of the scene (sea.layer.0.chlorophyll_mg_m3=0.5); may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
}

/// An option whose text is looked at as it is taken: a std::invalid_argument is told with the flag.
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

/// An option that stands for one value of the scene: the effective scene tells what ran.
void add_scene_value(CLI::App& app, std::vector<scene::Override>& overrides,
                     const std::string& flag, const std::string& type, const std::string& path,
                     const std::string& description, std::string (*value)(const std::string&)) {
  add_checked(app, flag, type, description, [&overrides, path, value](const std::string& text) {
    overrides.push_back(path + "=" + value(text));
  });
}

void add_seed(CLI::App& app, std::vector<scene::Override>& overrides) {
  add_scene_value(app, overrides, "--seed", "S", "simulation.seed", "Seed of the random numbers",
                  seed_value);
}

void add_threads(CLI::App& app, int& threads, const std::string& description) {
  app.add_option("--threads", threads, description)->type_name("T")->check(CLI::Range(1, 4096));
}

void add_run(CLI::App& app, RunCommand& run, std::vector<scene::Override>& flags) {
  CLI::App& sub = *app.add_subcommand("run", "Simulate a scene and write its echoes");
  sub.add_option("scene", run.scene, "The scene file [with --continue: that of the earlier result]")
      ->type_name("SCENE");
  sub.add_option("-o,--output", run.output,
                 "The result, .nc or .csv [default: the scene's name, .nc, in the current folder]")
      ->type_name("FILE");
  sub.add_option("--continue", run.earlier,
                 "Go on from this result or checkpoint of the same scene; photons are the total")
      ->type_name("RESULT.nc");
  add_scene_value(sub, flags, "--photons", "N", "simulation.photons",
                  "Stop after N photons (1e7 is accepted)", photons_value);
  add_scene_value(sub, flags, "--target", "SHARE", "simulation.target_relative_error",
                  "Stop when every gate is converged below this relative error (1%)", share_value);
  add_scene_value(sub, flags, "--max-time", "TIME", "simulation.max_time_s",
                  "Stop after this time (60s, 10min, 2h)", seconds_value);
  add_seed(sub, flags);
  add_threads(sub, run.threads,
              "Number of threads [default: all cores]; the result does not depend on it");
  sub.add_option(
         "--engine", run.engine,
         "What walks the photons: lanes (many at a time in float) or scalar (in double, the "
         "reference) [default: lanes, or what --continue goes on from]")
      ->type_name("ENGINE")
      ->check(CLI::IsMember({"scalar", "lanes"}));
  sub.add_option("--isa", run.isa,
                 "Instructions of the lanes: avx512, avx2 or baseline [default: the best that the "
                 "processor has]")
      ->type_name("ISA")
      ->check(CLI::IsMember({"avx512", "avx2", "baseline"}));
  add_checked(sub, "--checkpoint", "TIME",
              "Write the result so far this often [default: every 30s, after the first minute]",
              [&run](const std::string& text) { run.checkpoint_s = seconds(text); });
  add_overrides(sub, run.overrides);
  sub.add_flag(
      "--force", run.force,
      "Replace whatever is where the result goes: results of other scenes, of more photons "
      "than this run's, other files");
  sub.add_flag("--json", run.json, "Print the table of echoes as JSON");
}

void add_bench(CLI::App& app, BenchCommand& bench, std::vector<scene::Override>& flags) {
  CLI::App& sub = *app.add_subcommand("bench", "Measure which estimator suits a scene best");
  sub.add_option("scene", bench.scene, "The scene file")->required()->type_name("SCENE");
  add_checked(sub, "--time", "TIME", "Time for all of it [default: 60s]",
              [&bench](const std::string& text) { bench.time_s = bench_seconds(text); });
  add_threads(sub, bench.threads, "Number of threads [default: all cores]");
  add_seed(sub, flags);
  add_overrides(sub, bench.overrides);
  sub.add_flag("--json", bench.json, "Print as JSON");
}

void add_check(CLI::App& app, CheckCommand& check) {
  CLI::App& sub = *app.add_subcommand("check", "Tell every problem of a scene");
  sub.add_option("scene", check.scene, "The scene file")->required()->type_name("SCENE");
  add_overrides(sub, check.overrides);
  sub.add_flag("--json", check.json, "Print as JSON");
}

void add_show(CLI::App& app, ShowCommand& show) {
  CLI::App& sub = *app.add_subcommand(
      "show", "Print the effective scene, every default written out, of a scene or a result");
  sub.add_option("file", show.file, "A scene file, or a result (.nc)")
      ->required()
      ->type_name("SCENE|RESULT.nc");
  add_overrides(sub, show.overrides);
  sub.add_flag("--json", show.json, "Print as JSON");
}

/// "" if it is key=value.
std::string not_a_pair(const std::string& text) {
  const auto equals = text.find('=');
  if (equals != std::string::npos && equals > 0) return "";
  return fmt::format("'{}' is not KEY=VALUE (write chlorophyll_mg_m3=0.5)", text);
}

void add_optics(CLI::App& app, OpticsCommand& optics, std::vector<scene::Override>& flags) {
  CLI::App& sub = *app.add_subcommand(
      "optics",
      "Tell the optical properties of a scene's layers, or of water of given constituents, of air, "
      "of an oil");
  sub.add_option("scene", optics.scene, "The scene file")->type_name("SCENE");
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
  sub.add_option("--air", optics.air,
                 "Instead of a scene: the air, by an atmosphere (us-standard …), a CSV file of "
                 "levels, or a tape6 or tape7 of MODTRAN")
      ->type_name("NAME|FILE");
  sub.add_option("--visibility", optics.visibility_km,
                 "With --air: its aerosols are those of this visibility in km")
      ->type_name("KM");
  sub.add_option("--aerosol", optics.aerosol,
                 "With --air: of the lowest 2 km: rural, maritime, urban …")
      ->capture_default_str()
      ->type_name("MODEL");
  add_checked(
      sub, "--wavelengths", "NM",
      "355,532,685 or 400:700:10 [default: the laser's and those that the channels count; of air "
      "and oil 300:700:50, of a tape7 all]",
      [&optics](const std::string& text) { optics.wavelength_nm = wavelengths_nm(text); });
  add_scene_value(sub, flags, "--laser", "NM", "source.wavelength_nm",
                  "Wavelength of the light that excites Raman and fluorescence light [default: the "
                  "scene's; 532 with --water]",
                  wavelength_value);
  sub.add_option("-o,--output", optics.output, "Write them to a file, .nc or .csv")
      ->type_name("FILE");
  add_overrides(sub, optics.overrides);
  sub.add_flag("--json", optics.json, "Print as JSON");
}

/// Either a scene or water without one, or an oil or air.
void expect_scene_or_water(const CLI::App& optics) {
  const bool scene = optics.count("scene") > 0, water = optics.count("--water") > 0;
  const bool air = optics.count("--air") > 0;
  for (const char* of_air : {"--visibility", "--aerosol"})
    if (!air && optics.count(of_air) > 0) throw CLI::RequiresError(of_air, "--air");
  if (air || optics.count("--oil") > 0) {
    const char* alone = air ? "--air" : "--oil";
    for (const char* other : {"scene", "--water", "--oil", "--laser", "--set"})
      if (optics.count(other) > 0 && std::string(other) != alone)
        throw CLI::ExcludesError(fmt::format("{} and {} exclude each other", alone, other),
                                 CLI::ExitCodes::ExcludesError);
    return;
  }
  if (!scene && !water) throw CLI::RequiredError("scene, --water, --oil or --air");
  if (scene && water)
    throw CLI::ExcludesError("scene and --water exclude each other: write --set for a scene",
                             CLI::ExitCodes::ExcludesError);
}

void add_new(CLI::App& app, NewCommand& starter) {
  CLI::App& sub = *app.add_subcommand("new", "Write a commented scene to start from");
  sub.add_option("kind", starter.kind, "Which one: ship")->required()->type_name("KIND");
  sub.add_option("-o,--output", starter.output,
                 "Where to [default: standard output]; never an existing file")
      ->type_name("FILE");
}

/// CLI11 would only say that a subcommand is required.
void expect_known_subcommand(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || *argv[1] == '-') return;
  std::vector<std::string> known;
  for (const CLI::App* sub : app.get_subcommands({})) known.push_back(sub->get_name());
  const std::string word = argv[1];
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  const std::string suggestion = scene::suggestion_for(word, known, "there are");
  throw CLI::ExtrasError("there is no subcommand '" + word + "' (" + suggestion + ")",
                         CLI::ExitCodes::ExtrasError);
}

}  // namespace

Parsed parse_command_line(int argc, const char* const* argv) {
  CLI::App app("Photic simulates what a lidar over or in the sea will see.", "photic");
  app.set_version_flag("--version", "photic " PHOTIC_VERSION);
  app.require_subcommand(1);
  app.footer(examples);

  RunCommand run;
  BenchCommand bench;
  CheckCommand check;
  ShowCommand show;
  OpticsCommand optics;
  NewCommand starter;
  std::vector<scene::Override> flags;  // after --set: the flag that names a value wins
  add_run(app, run, flags);
  add_bench(app, bench, flags);
  add_check(app, check);
  add_show(app, show);
  add_optics(app, optics, flags);
  add_new(app, starter);
  app.add_subcommand("schema", "Print the JSON Schema of scene files, for editors");

  try {
    expect_known_subcommand(app, argc, argv);
    app.parse(argc, argv);
    if (app.got_subcommand("run") && run.scene.empty() && run.earlier.empty())
      throw CLI::RequiredError("scene");
    if (app.got_subcommand("optics")) expect_scene_or_water(*app.get_subcommand("optics"));
  } catch (const CLI::ParseError& end) {
    return {std::nullopt, app.exit(end) == 0 ? done : bad_input};
  }
  for (auto* overrides : {&run.overrides, &bench.overrides, &optics.overrides})
    overrides->insert(overrides->end(), flags.begin(), flags.end());
  std::erase(optics.water, "");  // what CLI11 gives for --water without keys
  run.command_line = optics.command_line = as_typed(argc, argv);
  if (app.got_subcommand("run")) return {run, done};
  if (app.got_subcommand("bench")) return {bench, done};
  if (app.got_subcommand("check")) return {check, done};
  if (app.got_subcommand("show")) return {show, done};
  if (app.got_subcommand("optics")) return {optics, done};
  if (app.got_subcommand("new")) return {starter, done};
  return {SchemaCommand{}, done};
}

}  // namespace photic::app
