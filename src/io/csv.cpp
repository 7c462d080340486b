#include "io/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "io/atomic_file.hpp"
#include "io/echo_rows.hpp"

namespace photic::io {
namespace {

/// RFC 4180, section 2: quotes where needed, a quote within is doubled.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"#\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

/// A text in the head may not end its line.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

const char* const columns =
    "telescope,channel,gate,time_start_ns,time_end_ns,depth_m,echo,standard_error,relative_error,"
    "converged,reasons";

std::string head(const tally::Result& result) {
  std::string out = fmt::format("# {}\n", one_line(result.title));
  out += fmt::format("# Photic {}, estimator {}, engine {}, seed {}, photons {}{}\n",
                     result.version, result.estimator, result.engine, result.seed, result.photons,
                     result.partial ? " (partial: interrupted)" : "");
  for (const auto& warning : result.warnings)
    out += fmt::format("# warning: {}\n", one_line(warning));
  out +=
      "# echo: expected photons detected in the gate per photon emitted; standard_error: of the "
      "echo\n";
  out += fmt::format(
      "# gate: from 0; time: from laser to telescope; depth_m: {}, centre of the gate\n",
      result.gate_depth_is_range ? "range along the axis of the first telescope"
                                 : "vertical, down from the sea level");
  if (result.environment_name.empty()) return out + columns + '\n';
  out +=
      "# environment: none for the scene itself; difference: echo in the environment less the "
      "scene's, from the same photons\n";
  return out + columns + ",environment,difference,difference_standard_error\n";
}

std::string line(const tally::Result& result, const EchoRow& row) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}",
                     field(result.telescope_name[row.telescope]),
                     field(result.channel_name[row.channel]), row.gate, row.time_start_ns,
                     row.time_end_ns, row.depth_m, row.echo, row.standard_error, row.relative_error,
                     row.converged() ? "yes" : "no", fmt::join(flag_names(row.flags), " "));
}

std::string environment_lines(const tally::Result& result, std::size_t environment) {
  std::string out;
  for (const EchoRow& row : environment_rows(result, environment))
    out +=
        fmt::format("{},{},{},{}\n", line(result, row), field(result.environment_name[environment]),
                    row.difference, row.difference_standard_error);
  return out;
}

}  // namespace

std::string echo_csv(const tally::Result& result) {
  const std::string no_environment = result.environment_name.empty() ? "\n" : ",,0,0\n";
  std::string out = head(result);
  for (const EchoRow& row : echo_rows(result)) out += line(result, row) + no_environment;
  for (std::size_t e = 0; e < result.environment_name.size(); ++e)
    out += environment_lines(result, e);
  return out;
}

void write_csv(const tally::Result& result, const std::string& path) {
  write_atomically(path, echo_csv(result));
}

}  // namespace photic::io
