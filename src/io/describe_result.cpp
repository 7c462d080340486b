#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <limits>
#include <numeric>
#include <utility>

#include "io/dataset_axes.hpp"
#include "io/dataset_flags.hpp"
#include "io/dataset_tallies.hpp"
#include "io/describe.hpp"

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

/// The attributes of numbers in single precision.
Attributes in_single(Attributes attributes) {
  for (auto& [key, value] : attributes)
    if (key == "_FillValue") value = std::numeric_limits<float>::quiet_NaN();
  return attributes;
}

void add_numbers(Dataset& dataset, const std::string& name,
                 const std::vector<std::string>& dimensions, const ZeroedVector<double>& numbers,
                 const Attributes& attributes, Precision precision) {
  if (precision == Precision::full)
    return dataset.add_variable(name, dimensions, numbers, attributes);
  ZeroedVector<float> rounded;
  rounded.reserve(numbers.size());
  for (const double number : numbers) rounded.push_back(static_cast<float>(number));
  dataset.add_variable(name, dimensions, rounded, in_single(attributes));
}

void add_estimates(Dataset& dataset, const std::string& name,
                   const std::vector<std::string>& dimensions, const tally::Estimates& estimates,
                   const std::string& long_name, const std::string& cell_methods,
                   const std::string& more_ancillary = "", const std::string& more_coordinates = "",
                   Precision precision = Precision::full) {
  const std::string error_name = name + "_standard_error";
  Attributes attributes = dimensionless(long_name, more_coordinates);
  if (!cell_methods.empty()) attributes.emplace_back("cell_methods", cell_methods);
  attributes.emplace_back("ancillary_variables", error_name + more_ancillary);
  add_numbers(dataset, name, dimensions, estimates.mean, attributes, precision);
  add_numbers(dataset, error_name, dimensions, estimates.standard_error,
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

void add_echoes(Dataset& dataset, const tally::Result& result) {
  const std::vector<double> photons(result.channel_photons.begin(), result.channel_photons.end());
  dataset.add_variable(
      "channel_photons", {"telescope", "channel"}, photons,
      {{"long_name",
        "photons that the echoes of a channel are means over: fewer than all where "
        "it met the target before others did"},
       {"units", "1"},
       {"coordinates", "telescope_name channel_name"}});
  add_estimates(
      dataset, "echo", {"telescope", "channel", "gate"}, result.echo, echo_meaning, "gate: sum",
      " converged convergence_flags largest_score_share variance_of_variance error_growth "
      "order_cut_share");
  for (const tally::GridEstimates& grid : result.grids) {
    const auto& [name, long_name, part, axes, profile, beside_walks] = grid.grid;
    std::string methods = "gate: sum", flags;
    if (profile)
      for (const tally::Axis& axis : axes) methods += fmt::format(" {}: sum", axis.name);
    else
      flags = fmt::format(" {0}_converged {0}_convergence_flags", name);
    add_estimates(dataset, name, dimensions_of(grid.grid), grid,
                  fmt::format("{}, {}", echo_meaning, long_name), methods, flags,
                  coordinates_of(grid.grid), profile ? Precision::single : Precision::full);
  }
}

/// Adds nothing if none are kept.
void add_groups(Dataset& dataset, const tally::Result& result) {
  const tally::GroupMeans& by_group = result.by_group;
  if (by_group.groups == 0) return;
  dataset.add_dimension("batch_group", by_group.groups);
  std::vector<std::int32_t> numbers(by_group.groups);
  std::iota(numbers.begin(), numbers.end(), 0);
  dataset.add_variable("batch_group", {"batch_group"}, numbers,
                       {{"long_name", "group of batches, in their order"}, {"units", "1"}});
  dataset.add_variable("group_photons", {"telescope", "channel", "batch_group"}, by_group.photons,
                       {{"long_name",
                         "photons of a group of batches that the echoes of a channel are means "
                         "over: 0 where it rested"},
                        {"units", "1"},
                        {"coordinates", "telescope_name channel_name"}});
  const auto add = [&](const std::string& name, std::vector<std::string> dimensions,
                       const ZeroedVector<float>& means, const std::string& long_name,
                       const std::string& more_coordinates) {
    for (const char* dimension : {"telescope", "channel", "batch_group", "gate"})
      dimensions.emplace_back(dimension);
    dataset.add_variable(name, dimensions, means,
                         in_single(dimensionless(long_name, more_coordinates)));
  };
  add("echo_by_group", {}, by_group.echo, echo_meaning + ", in a group of batches", "");
  if (!by_group.environment_echo.empty())
    add("environment_echo_by_group", {"environment"}, by_group.environment_echo,
        echo_meaning + ", in the environment, in a group of batches", " environment_name");
}

/// The flags of echoes, whose coordinates they share.
void add_flags(Dataset& dataset, const std::string& prefix, const std::string& what,
               const std::vector<std::string>& dimensions, const std::vector<std::int32_t>& flags,
               const std::string& more_coordinates = "") {
  add_flags(dataset, {prefix, what, dimensions, usual_coordinates + more_coordinates}, flags);
}

void add_convergence(Dataset& dataset, const tally::Result& result) {
  const std::vector<std::string> dimensions = {"telescope", "channel", "gate"};
  add_flags(dataset, "", "echo", dimensions, result.convergence_flags);
  for (const tally::GridEstimates& grid : result.grids)
    if (!grid.grid.profile)
      add_flags(dataset, grid.grid.name + "_", grid.grid.part, dimensions_of(grid.grid), grid.flags,
                coordinates_of(grid.grid));
  dataset.add_variable("largest_score_share", dimensions, result.largest_score_share,
                       dimensionless("share of the largest single score in the echo"));
  dataset.add_variable("variance_of_variance", dimensions, result.variance_of_variance,
                       dimensionless("relative variance of the estimated variance of the echo"));
  dataset.add_variable(
      "error_growth", dimensions, result.error_growth,
      dimensionless("standard error of echo times the root of the photons, over the "
                    "same with an eighth to a quarter of the photons"));
  dataset.add_variable("order_cut_share", dimensions, result.order_cut_share,
                       dimensionless("first order of scattering that was cut off, over the echo"));
}

/// Adds nothing if environments set no numbers.
void add_environment_values(Dataset& dataset, const tally::Result& result) {
  if (result.environment_path.empty()) return;
  dataset.add_dimension("environment_path", result.environment_path.size());
  dataset.add_variable("environment_path_name", {"environment_path"}, result.environment_path,
                       {{"long_name", "path in the scene of a number that an environment sets"}});
  dataset.add_variable(
      "environment_value", {"environment", "environment_path"}, result.environment_value,
      {{"long_name", "value at the path in the environment, in the unit of its name"},
       {"units", "1"},
       {"_FillValue", nan},
       {"coordinates", "environment_name environment_path_name"}});
}

/// Adds nothing if there are none.
void add_environments(Dataset& dataset, const tally::Result& result) {
  if (result.environment_name.empty()) return;
  const std::vector<std::string> dimensions = {"environment", "telescope", "channel", "gate"};
  const std::string more_coordinates = " environment_name";
  const std::string flags = " environment_converged environment_convergence_flags";
  dataset.add_dimension("environment", result.environment_name.size());
  dataset.add_variable("environment_name", {"environment"}, result.environment_name,
                       {{"long_name", "name of the environment: the scene in other water"}});
  add_environment_values(dataset, result);
  add_estimates(dataset, "environment_echo", dimensions, result.environment_echo,
                echo_meaning + ", in the environment", "gate: sum", flags, more_coordinates);
  add_estimates(dataset, "environment_difference", dimensions, result.environment_difference,
                "echo in the environment minus that of the scene, from the same photons",
                "gate: sum", flags, more_coordinates);
  add_flags(dataset, "environment_", "echo", dimensions, result.environment_convergence_flags,
            more_coordinates);
}

/// Adds nothing if there are none.
void add_sensitivities(Dataset& dataset, const tally::Result& result) {
  if (result.parameter_name.empty()) return;
  const std::vector<std::string> dimensions = {"parameter", "telescope", "channel", "gate"};
  const std::string more_coordinates = " parameter_name parameter_value";
  const std::string flags = " sensitivity_converged sensitivity_convergence_flags";
  dataset.add_dimension("parameter", result.parameter_name.size());
  dataset.add_variable("parameter_name", {"parameter"}, result.parameter_name,
                       {{"long_name", "path of the parameter in the scene"}});
  dataset.add_variable(
      "parameter_value", {"parameter"}, result.parameter_value,
      {{"long_name", "value of the parameter in the scene, in the unit of its name"},
       {"units", "1"},
       {"_FillValue", nan},
       {"coordinates", "parameter_name"}});
  add_estimates(dataset, "sensitivity", dimensions, result.sensitivity,
                "derivative of the echo with respect to the parameter: per unit of its value",
                "gate: sum", flags, more_coordinates);
  add_estimates(
      dataset, "logarithmic_sensitivity", dimensions, result.logarithmic_sensitivity,
      "parameter over echo, times the derivative of the echo with respect to the parameter", "",
      flags, more_coordinates);
  add_flags(dataset, "sensitivity_", "sensitivity", dimensions,
            result.sensitivity_convergence_flags, more_coordinates);
}

void add_description(Dataset& dataset, const tally::Result& result, const WriteInfo& info) {
  dataset.add_global("Conventions", "CF-1.10");
  dataset.add_global("title", LongText{result.title});
  dataset.add_global(
      "source",
      fmt::format("Photic {}: Monte Carlo simulation of an oceanographic lidar, {} estimator",
                  result.version, result.estimator));
  dataset.add_global("history", LongText{info.history});
  dataset.add_global(
      "references",
      "R. Barbini, F. Colao, E. Cupini, N. Ferrari, G. Ferro, A. Palucci (2000): Marine code for "
      "modelling range resolved oceanographic lidar fluorosensor measurements. Proceedings of "
      "EARSeL-SIG-Workshop LIDAR, Dresden, 16-17 June 2000");
  dataset.add_global("photic_format", photic_format);
  dataset.add_global("version", result.version);
  dataset.add_global("engine", result.engine);
  dataset.add_global("estimator", result.estimator);
  if (!info.scene_file.empty()) dataset.add_global("scene_file", LongText{info.scene_file});
  dataset.add_global("scene", LongText{result.scene_toml});
  if (!result.strategies.empty())
    dataset.add_global("strategies",
                       LongText{fmt::format("{}", fmt::join(result.strategies, "\n"))});
  dataset.add_global("optics_sources",
                     LongText{fmt::format("{}", fmt::join(result.sources, "\n"))});
}

void add_run(Dataset& dataset, const tally::Result& result) {
  dataset.add_global("seed", result.seed);
  dataset.add_global("photons", result.photons);
  dataset.add_global("batches", result.batches);
  dataset.add_global("stopped_by", result.stopped_by);
  dataset.add_global("partial", std::int32_t{result.partial ? 1 : 0});
  dataset.add_global("collisions", result.collisions);
  dataset.add_global("wall_time_s", result.wall_time_s);
  dataset.add_global("threads", std::int32_t{result.threads});
  dataset.add_global(
      "collisions_per_second",
      result.wall_time_s > 0 ? static_cast<double>(result.collisions) / result.wall_time_s : nan);
  dataset.add_global("photons_lost_too_many_events", result.lost_too_many_events);
  dataset.add_global("photons_lost_not_finite", result.lost_not_finite);
  const tally::Ledger& ledger = result.ledger;
  dataset.add_global("ledger_comment",
                     "shares of the weight of the photons emitted, by where it ended");
  tally::Ledger::each(
      [&](const char* name, double share) {
        dataset.add_global(fmt::format("ledger_{}", name), share);
      },
      ledger);
  dataset.add_global("warnings", LongText{fmt::format("{}", fmt::join(result.warnings, "\n"))});
}

}  // namespace

std::string history_line(const std::string& command_line) {
  const auto now =
      std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}: {}", fmt::gmtime(now), command_line);
}

namespace {

void add_all_of_echoes(Dataset& dataset, const tally::Result& result) {
  add_axes(dataset, result);
  add_gates(dataset, result);
  add_axes_of_grids(dataset, result);
  add_echoes(dataset, result);
  add_convergence(dataset, result);
  add_environments(dataset, result);
  add_sensitivities(dataset, result);
  add_groups(dataset, result);
}

}  // namespace

void describe(const tally::Result& result, const WriteInfo& info, Dataset& dataset) {
  add_description(dataset, result, info);
  add_run(dataset, result);
  dataset.add_dimension("bnds", 2);
  if (result.has_echoes()) add_all_of_echoes(dataset, result);
  add_tallies(dataset, result);
}

}  // namespace photic::io
