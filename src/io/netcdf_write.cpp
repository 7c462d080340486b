#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <limits>
#include <utility>

#include "io/atomic_file.hpp"
#include "io/netcdf.hpp"
#include "io/netcdf_axes.hpp"
#include "io/netcdf_flags.hpp"
#include "io/netcdf_image.hpp"
#include "io/netcdf_state.hpp"
#include "io/netcdf_tallies.hpp"

namespace photic::io {
namespace {

const std::string echo_meaning = "expected photons detected in the gate per photon emitted";

const std::string usual_coordinates =
    "telescope_name channel_name channel_wavelength gate_time gate_depth";

/// The attributes that an estimate, its error and its diagnostics share.
Attributes dimensionless(const std::string& long_name, const std::string& more_coordinates = "") {
  return {{"long_name", long_name},
          {"units", "1"},
          {"_FillValue", nan},
          {"coordinates", usual_coordinates + more_coordinates}};
}

/// Single: far finer than any error bar, for what has many numbers.
enum class Precision { full, single };

void add_numbers(NetcdfImage& file, const std::string& name,
                 const std::vector<std::string>& dimensions, const ZeroedVector<double>& numbers,
                 const Attributes& attributes, Precision precision) {
  if (precision == Precision::full) return file.add_variable(name, dimensions, numbers, attributes);
  ZeroedVector<float> rounded;
  rounded.reserve(numbers.size());
  for (const double number : numbers) rounded.push_back(static_cast<float>(number));
  Attributes in_single = attributes;
  for (auto& [key, value] : in_single)
    if (key == "_FillValue") value = std::numeric_limits<float>::quiet_NaN();
  file.add_variable(name, dimensions, rounded, in_single);
}

void add_estimates(NetcdfImage& file, const std::string& name,
                   const std::vector<std::string>& dimensions, const tally::Estimates& estimates,
                   const std::string& long_name, const std::string& cell_methods,
                   const std::string& more_ancillary = "", const std::string& more_coordinates = "",
                   Precision precision = Precision::full) {
  const std::string error_name = name + "_standard_error";
  Attributes attributes = dimensionless(long_name, more_coordinates);
  if (!cell_methods.empty()) attributes.emplace_back("cell_methods", cell_methods);
  attributes.emplace_back("ancillary_variables", error_name + more_ancillary);
  add_numbers(file, name, dimensions, estimates.mean, attributes, precision);
  add_numbers(file, error_name, dimensions, estimates.standard_error,
              dimensionless("standard error of " + name, more_coordinates), precision);
}

/// The names of a grid's cells, where its axes have names.
std::string coordinates_of(const tally::Grid& grid) {
  std::string out;
  for (const tally::Axis& axis : grid.axes)
    if (!axis.labels.empty()) out += fmt::format(" {}_name", axis.name);
  return out;
}
std::vector<std::string> dimensions_of(const tally::Grid& grid) {
  std::vector<std::string> out{"telescope", "channel"};
  if (grid.profile) out.emplace_back("gate");
  for (const tally::Axis& axis : grid.axes) out.push_back(axis.name);
  if (!grid.profile) out.emplace_back("gate");
  return out;
}

void add_echoes(NetcdfImage& file, const tally::Result& result) {
  const std::vector<double> photons(result.channel_photons.begin(), result.channel_photons.end());
  file.add_variable("channel_photons", {"telescope", "channel"}, photons,
                    {{"long_name",
                      "photons that the echoes of a channel are means over: fewer than all where "
                      "it met the target before others did"},
                     {"units", "1"},
                     {"coordinates", "telescope_name channel_name"}});
  add_estimates(
      file, "echo", {"telescope", "channel", "gate"}, result.echo, echo_meaning, "gate: sum",
      " converged convergence_flags largest_score_share variance_of_variance error_growth "
      "order_cut_share");
  for (const tally::GridEstimates& grid : result.grids) {
    const auto& [name, long_name, part, axes, profile, beside_walks] = grid.grid;
    std::string methods = "gate: sum", flags;
    if (profile)
      for (const tally::Axis& axis : axes) methods += fmt::format(" {}: sum", axis.name);
    else
      flags = fmt::format(" {0}_converged {0}_convergence_flags", name);
    add_estimates(file, name, dimensions_of(grid.grid), grid,
                  fmt::format("{}, {}", echo_meaning, long_name), methods, flags,
                  coordinates_of(grid.grid), profile ? Precision::single : Precision::full);
  }
}

/// The flags of echoes, whose coordinates they share.
void add_flags(NetcdfImage& file, const std::string& prefix, const std::string& what,
               const std::vector<std::string>& dimensions, const std::vector<std::int32_t>& flags,
               const std::string& more_coordinates = "") {
  add_flags(file, {prefix, what, dimensions, usual_coordinates + more_coordinates}, flags);
}

void add_convergence(NetcdfImage& file, const tally::Result& result) {
  const std::vector<std::string> dimensions = {"telescope", "channel", "gate"};
  add_flags(file, "", "echo", dimensions, result.convergence_flags);
  for (const tally::GridEstimates& grid : result.grids)
    if (!grid.grid.profile)
      add_flags(file, grid.grid.name + "_", grid.grid.part, dimensions_of(grid.grid), grid.flags,
                coordinates_of(grid.grid));
  file.add_variable("largest_score_share", dimensions, result.largest_score_share,
                    dimensionless("share of the largest single score in the echo"));
  file.add_variable("variance_of_variance", dimensions, result.variance_of_variance,
                    dimensionless("relative variance of the estimated variance of the echo"));
  file.add_variable("error_growth", dimensions, result.error_growth,
                    dimensionless("standard error of echo times the root of the photons, over the "
                                  "same with an eighth to a quarter of the photons"));
  file.add_variable("order_cut_share", dimensions, result.order_cut_share,
                    dimensionless("first order of scattering that was cut off, over the echo"));
}

/// Adds nothing if environments set no numbers.
void add_environment_values(NetcdfImage& file, const tally::Result& result) {
  if (result.environment_path.empty()) return;
  file.add_dimension("environment_path", result.environment_path.size());
  file.add_variable("environment_path_name", {"environment_path"}, result.environment_path,
                    {{"long_name", "path in the scene of a number that an environment sets"}});
  file.add_variable("environment_value", {"environment", "environment_path"},
                    result.environment_value,
                    {{"long_name", "value at the path in the environment, in the unit of its name"},
                     {"units", "1"},
                     {"_FillValue", nan},
                     {"coordinates", "environment_name environment_path_name"}});
}

/// Adds nothing if there are none.
void add_environments(NetcdfImage& file, const tally::Result& result) {
  if (result.environment_name.empty()) return;
  const std::vector<std::string> dimensions = {"environment", "telescope", "channel", "gate"};
  const std::string more_coordinates = " environment_name";
  const std::string flags = " environment_converged environment_convergence_flags";
  file.add_dimension("environment", result.environment_name.size());
  file.add_variable("environment_name", {"environment"}, result.environment_name,
                    {{"long_name", "name of the environment: the scene in other water"}});
  add_environment_values(file, result);
  add_estimates(file, "environment_echo", dimensions, result.environment_echo,
                echo_meaning + ", in the environment", "gate: sum", flags, more_coordinates);
  add_estimates(file, "environment_difference", dimensions, result.environment_difference,
                "echo in the environment minus that of the scene, from the same photons",
                "gate: sum", flags, more_coordinates);
  add_flags(file, "environment_", "echo", dimensions, result.environment_convergence_flags,
            more_coordinates);
}

/// Adds nothing if there are none.
void add_sensitivities(NetcdfImage& file, const tally::Result& result) {
  if (result.parameter_name.empty()) return;
  const std::vector<std::string> dimensions = {"parameter", "telescope", "channel", "gate"};
  const std::string more_coordinates = " parameter_name parameter_value";
  const std::string flags = " sensitivity_converged sensitivity_convergence_flags";
  file.add_dimension("parameter", result.parameter_name.size());
  file.add_variable("parameter_name", {"parameter"}, result.parameter_name,
                    {{"long_name", "path of the parameter in the scene"}});
  file.add_variable("parameter_value", {"parameter"}, result.parameter_value,
                    {{"long_name", "value of the parameter in the scene, in the unit of its name"},
                     {"units", "1"},
                     {"_FillValue", nan},
                     {"coordinates", "parameter_name"}});
  add_estimates(file, "sensitivity", dimensions, result.sensitivity,
                "derivative of the echo with respect to the parameter: per unit of its value",
                "gate: sum", flags, more_coordinates);
  add_estimates(
      file, "logarithmic_sensitivity", dimensions, result.logarithmic_sensitivity,
      "parameter over echo, times the derivative of the echo with respect to the parameter", "",
      flags, more_coordinates);
  add_flags(file, "sensitivity_", "sensitivity", dimensions, result.sensitivity_convergence_flags,
            more_coordinates);
}

void add_description(NetcdfImage& file, const tally::Result& result, const WriteInfo& info) {
  file.add_global("Conventions", "CF-1.10");
  file.add_global("title", LongText{result.title});
  file.add_global(
      "source",
      fmt::format("Photic {}: Monte Carlo simulation of an oceanographic lidar, {} estimator",
                  result.version, result.estimator));
  file.add_global("history", LongText{info.history});
  file.add_global(
      "references",
      "R. Barbini, F. Colao, E. Cupini, N. Ferrari, G. Ferro, A. Palucci (2000): Marine code for "
      "modelling range resolved oceanographic lidar fluorosensor measurements. Proceedings of "
      "EARSeL-SIG-Workshop LIDAR, Dresden, 16-17 June 2000");
  file.add_global("photic_format", photic_format);
  file.add_global("version", result.version);
  file.add_global("engine", result.engine);
  file.add_global("estimator", result.estimator);
  if (!info.scene_file.empty()) file.add_global("scene_file", LongText{info.scene_file});
  file.add_global("scene", LongText{result.scene_toml});
  if (!result.strategies.empty())
    file.add_global("strategies", LongText{fmt::format("{}", fmt::join(result.strategies, "\n"))});
  file.add_global("optics_sources", LongText{fmt::format("{}", fmt::join(result.sources, "\n"))});
}

void add_run(NetcdfImage& file, const tally::Result& result) {
  file.add_global("seed", result.seed);
  file.add_global("photons", result.photons);
  file.add_global("batches", result.batches);
  file.add_global("stopped_by", result.stopped_by);
  file.add_global("partial", std::int32_t{result.partial ? 1 : 0});
  file.add_global("collisions", result.collisions);
  file.add_global("wall_time_s", result.wall_time_s);
  file.add_global("threads", std::int32_t{result.threads});
  file.add_global(
      "collisions_per_second",
      result.wall_time_s > 0 ? static_cast<double>(result.collisions) / result.wall_time_s : nan);
  file.add_global("photons_lost_too_many_events", result.lost_too_many_events);
  file.add_global("photons_lost_not_finite", result.lost_not_finite);
  const tally::Ledger& ledger = result.ledger;
  file.add_global("ledger_comment",
                  "shares of the weight of the photons emitted, by where it ended");
  tally::Ledger::each([&](const char* name,
                          double share) { file.add_global(fmt::format("ledger_{}", name), share); },
                      ledger);
  file.add_global("warnings", LongText{fmt::format("{}", fmt::join(result.warnings, "\n"))});
}

}  // namespace

std::string history_line(const std::string& command_line) {
  const auto now =
      std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}: {}", fmt::gmtime(now), command_line);
}

namespace {

void add_all_of_echoes(NetcdfImage& file, const tally::Result& result) {
  add_axes(file, result);
  add_gates(file, result);
  add_axes_of_grids(file, result);
  add_echoes(file, result);
  add_convergence(file, result);
  add_environments(file, result);
  add_sensitivities(file, result);
}

std::vector<tally::Grid> grids_of(const tally::Result& result) {
  std::vector<tally::Grid> out;
  for (const auto& grid : result.grids) out.push_back(grid.grid);
  return out;
}

}  // namespace

void write_netcdf(const tally::Result& result, const std::string& path, const WriteInfo& info) {
  NetcdfImage file;
  add_description(file, result, info);
  add_run(file, result);
  file.add_dimension("bnds", 2);
  if (result.has_echoes()) add_all_of_echoes(file, result);
  add_tallies(file, result);
  if (result.state) add_state(file, *result.state, grids_of(result));
  write_atomically(path, file.finish(), info.keep_as);
}

}  // namespace photic::io
