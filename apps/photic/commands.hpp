// The user's request: one plain value for each subcommand, and the function that carries it out.
// Each returns the exit code; problems are thrown and reported in one place (main.cpp).
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "photic/manual.hpp"
#include "photic/shell.hpp"
#include "scene/read.hpp"

namespace photic::app {

inline constexpr int done = 0;
inline constexpr int failed = 1;     ///< the environment: disk, memory
inline constexpr int bad_input = 2;  ///< a scene or a command line that cannot be followed

/// photic run: simulates a scene and writes its echoes.
struct RunCommand {
  std::string scene;    ///< may be empty if there is an earlier result
  std::string earlier;  ///< the result to go on from; empty: none
  std::string output;   ///< .nc, .csv, .txt or a folder; empty: the scene's name in the current one
  std::optional<double> checkpoint_s;  ///< time between checkpoints; none: the usual
  std::vector<scene::Override> overrides;
  int threads = 0;              ///< 0: all cores
  std::string engine;           ///< empty: that of the result it goes on from, or scalar
  std::string isa;              ///< of the lane engine; empty: the best there is
  std::string table = "short";  ///< short | full | none
  bool json = false;
  bool quiet = false;  ///< prints warnings and errors alone
  bool force = false;  ///< replaces whatever is where the result goes
  Call call;           ///< for the history of the result
};

/// photic plot: draws results by the Python package.
struct PlotCommand {
  std::vector<std::string> results;
  std::string output;  ///< .png, .pdf or .svg; empty: the first result's name, .png
  std::string title;
  std::vector<std::string> telescopes, channels;
  std::string width_mm;
  Call call;
};

/// photic analyse: applies a function of the Python package to a result.
struct AnalyseCommand {
  std::string file;                  ///< a result, or a scene
  std::string function;              ///< by its name, "k-lidar"
  std::vector<std::string> options;  ///< those of the function, as words: "--channel=raman"
  std::string output;                ///< .nc, .csv, .png, .pdf or .svg; empty: none
  bool json = false;
  bool force = false;  ///< replaces whatever is where the output goes
};

/// photic bench: compares the estimators on a scene.
struct BenchCommand {
  std::string scene;
  std::vector<scene::Override> overrides;
  double time_s = 60;
  int threads = 0;  ///< 0: all cores
  bool json = false;
};

/// photic check: reports every problem of a scene.
struct CheckCommand {
  std::string scene;
  std::vector<scene::Override> overrides;
  bool json = false;
};

/// photic show: prints the effective scene of a scene file or of a result.
struct ShowCommand {
  std::string file;
  std::vector<scene::Override> overrides;
  bool json = false;
};

/// photic optics: reports the optical properties of a scene's layers, of water of given
/// constituents, of an oil, or of air.
struct OpticsCommand {
  std::string scene;               ///< empty: one layer of this water, under the laser of 532 nm
  std::vector<std::string> water;  ///< "key=value" of a layer
  std::string oil;                 ///< a class or a file, which is reported alone
  std::string air;                 ///< an atmosphere, a file or a scene, which is reported alone
  std::string aerosol = "rural";   ///< of its lowest 2 km
  std::optional<double> visibility_km;  ///< without one the air is as the profile says
  std::vector<double> wavelength_nm;    ///< ascending; empty: those that light of the scene has
  std::string output;                   ///< .nc or .csv; empty: none
  std::vector<scene::Override> overrides;
  bool json = false;
  Call call;  ///< for the history of the output

  [[nodiscard]] bool is_air_of_scene() const { return air.ends_with(".toml"); }
};

/// photic new: writes a commented scene to start from.
struct NewCommand {
  std::string kind;
  bool list = false;   ///< lists all kinds instead
  std::string output;  ///< empty: standard output
  Call call;
};

/// photic schema: prints the JSON Schema of scene files.
struct SchemaCommand {};

/// photic help: what there is.
struct HelpCommand {
  std::string command;  ///< empty: of all, in short
  CommandManual program;
};

/// photic manual: prints the page photic(1).
struct ManualCommand {
  CommandManual program;
};

/// photic complete -- WORD...: prints what may stand in the place of the last word, for shells.
struct CompleteCommand {
  std::vector<std::string> words;  ///< at least one, which may be empty
  CommandManual program;
};

/// photic --version
struct VersionCommand {};

using Command = std::variant<RunCommand, PlotCommand, AnalyseCommand, BenchCommand, CheckCommand,
                             ShowCommand, OpticsCommand, NewCommand, SchemaCommand, HelpCommand,
                             ManualCommand, CompleteCommand, VersionCommand>;

int run(const RunCommand& command);
int run(const PlotCommand& command);
int run(const AnalyseCommand& command);
int run(const BenchCommand& command);
int run(const CheckCommand& command);
int run(const ShowCommand& command);
int run(const OpticsCommand& command);
int run(const NewCommand& command);
int run(const SchemaCommand& command);
int run(const HelpCommand& command);
int run(const ManualCommand& command);
int run(const CompleteCommand& command);
int run(const VersionCommand& command);

}  // namespace photic::app
