#include "io/echo_rows.hpp"

#include <limits>

#include "core/error.hpp"

namespace photic::io {

std::vector<EchoRow> echo_rows(const tally::Result& result) {
  const std::size_t gates = result.gates();
  const std::size_t count = result.telescopes() * result.channels() * gates;
  expect(result.echo.mean.size() == count && result.echo.standard_error.size() == count &&
             result.convergence_flags.size() == count,
         "an echo, its error and its flags for every telescope, channel and gate");
  expect(result.gate_depth_edge_m.size() == result.channels() * (gates + 1),
         "a depth for every channel and edge of a gate");
  std::vector<EchoRow> rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    EchoRow& row = rows[i];
    row.gate = i % gates;
    row.channel = i / gates % result.channels();
    row.telescope = i / gates / result.channels();
    row.time_start_ns = result.gate_time_edge_ns[row.gate];
    row.time_end_ns = result.gate_time_edge_ns[row.gate + 1];
    const double* depth_edge = &result.gate_depth_edge_m[row.channel * (gates + 1) + row.gate];
    row.depth_m = 0.5 * (depth_edge[0] + depth_edge[1]);
    row.echo = result.echo.mean[i];
    row.standard_error = result.echo.standard_error[i];
    row.relative_error =
        row.echo > 0 ? row.standard_error / row.echo : std::numeric_limits<double>::quiet_NaN();
    row.flags = result.convergence_flags[i];
  }
  return rows;
}

std::vector<std::string_view> flag_names(std::int32_t flags) {
  std::vector<std::string_view> names;
  for (const auto& meaning : tally::flag_meanings())
    if ((flags & meaning.flag) != 0) names.emplace_back(meaning.name);
  return names;
}

}  // namespace photic::io
