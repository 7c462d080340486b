#include "io/echo_rows.hpp"

#include <fmt/format.h>

#include <limits>

#include "core/error.hpp"

namespace photic::io {
namespace {

std::size_t cells(const tally::Result& result) {
  return result.telescopes() * result.channels() * result.gates();
}

bool are(std::size_t count, const tally::Estimates& estimates) {
  return estimates.mean.size() == count && estimates.standard_error.size() == count;
}

/// The rows of the cells of an echo that begin at `first`.
std::vector<EchoRow> rows_of(const tally::Result& result, const tally::Estimates& echo,
                             const std::vector<std::int32_t>& flags, std::size_t first) {
  const std::size_t gates = result.gates();
  const std::size_t count = cells(result);
  expect(result.gate_depth_edge_m.size() == result.telescopes() * result.channels() * (gates + 1),
         "a depth for every telescope, channel and edge of a gate");
  std::vector<EchoRow> rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    EchoRow& row = rows[i];
    row.gate = i % gates;
    row.channel = i / gates % result.channels();
    row.telescope = i / gates / result.channels();
    row.time_start_ns = result.gate_time_edge_ns[row.gate];
    row.time_end_ns = result.gate_time_edge_ns[row.gate + 1];
    row.depth_m = result.gate_depth_m(row.telescope, row.channel, row.gate);
    row.echo = echo.mean[first + i];
    row.standard_error = echo.standard_error[first + i];
    row.relative_error =
        row.echo > 0 ? row.standard_error / row.echo : std::numeric_limits<double>::quiet_NaN();
    row.flags = flags[first + i];
  }
  return rows;
}

}  // namespace

std::vector<EchoRow> echo_rows(const tally::Result& result) {
  const std::size_t count = cells(result);
  expect(are(count, result.echo) && result.convergence_flags.size() == count,
         "an echo, its error and its flags for every telescope, channel and gate");
  return rows_of(result, result.echo, result.convergence_flags, 0);
}

std::vector<EchoRow> environment_rows(const tally::Result& result, std::size_t environment) {
  const std::size_t count = result.environment_name.size() * cells(result);
  expect(are(count, result.environment_echo) && are(count, result.environment_difference) &&
             result.environment_convergence_flags.size() == count,
         "an echo, its difference, their errors and flags in every environment");
  const std::size_t first = environment * cells(result);
  std::vector<EchoRow> rows =
      rows_of(result, result.environment_echo, result.environment_convergence_flags, first);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].difference = result.environment_difference.mean[first + i];
    rows[i].difference_standard_error = result.environment_difference.standard_error[first + i];
  }
  return rows;
}

std::vector<EchoRow> sensitivity_rows(const tally::Result& result, std::size_t parameter) {
  const std::size_t count = result.parameter_name.size() * cells(result);
  expect(are(count, result.sensitivity) && are(count, result.logarithmic_sensitivity) &&
             result.sensitivity_convergence_flags.size() == count,
         "derivatives, their errors and flags with respect to every parameter");
  const std::size_t first = parameter * cells(result);
  std::vector<EchoRow> rows = echo_rows(result);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EchoRow& row = rows[i];
    row.sensitivity = result.sensitivity.mean[first + i];
    row.sensitivity_standard_error = result.sensitivity.standard_error[first + i];
    row.logarithmic_sensitivity = result.logarithmic_sensitivity.mean[first + i];
    row.logarithmic_sensitivity_standard_error =
        result.logarithmic_sensitivity.standard_error[first + i];
    row.flags = result.sensitivity_convergence_flags[first + i];
  }
  return rows;
}

std::string rested_channels(const tally::Result& result) {
  std::vector<std::string> rested;
  for (std::size_t i = 0; i < result.channel_photons.size(); ++i) {
    if (result.channel_photons[i] == result.photons) continue;
    const std::string& channel = result.channel_name[i % result.channels()];
    const std::string telescope =
        result.telescopes() > 1 ? result.telescope_name[i / result.channels()] + " " : "";
    rested.push_back(fmt::format("{}{} {}", telescope, channel, result.channel_photons[i]));
  }
  return fmt::format("{}", fmt::join(rested, ", "));
}

std::vector<std::string_view> flag_names(std::int32_t flags) {
  std::vector<std::string_view> names;
  for (const auto& meaning : tally::flag_meanings())
    if ((flags & meaning.flag) != 0) names.emplace_back(meaning.name);
  return names;
}

}  // namespace photic::io
