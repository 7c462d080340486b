#include "io/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "io/echo_rows.hpp"
#include "io/environment_table.hpp"
#include "io/sensitivity_table.hpp"
#include "io/table_parts.hpp"

namespace photic::io {
namespace {

constexpr std::size_t channels_abreast = 4;  // 10 + 4 * 22 columns: what fits a terminal of 100

/// "12 345 678"
std::string grouped(std::uint64_t number) {
  std::string digits = fmt::format("{}", number);
  for (std::size_t end = digits.size(); end > 3; end -= 3) digits.insert(end - 3, 1, ' ');
  return digits;
}

std::string relative_error_text(double relative_error) {
  if (std::isnan(relative_error)) return "-";
  const double percent = 100 * relative_error;
  if (percent >= 1000) return "> 999 %";
  // Two digits, as many as an error deserves.
  return fmt::format("{:.{}f} %", percent, percent < 1 ? 2 : percent < 10 ? 1 : 0);
}

std::string cell(const EchoRow& row) {
  const std::string echo = row.echo == 0 ? "0" : fmt::format("{:.3e}", row.echo);
  return fmt::format("   {:>9} {:>7} {}", echo, relative_error_text(row.relative_error),
                     row.converged() ? ' ' : '*');
}

/// One telescope's gates for the channels [first, last).
std::string block(const tally::Result& result, const std::vector<EchoRow>& rows,
                  std::size_t telescope, std::size_t first, std::size_t last, std::size_t step) {
  const std::size_t gates = result.gates();
  std::string out(10, ' ');
  for (std::size_t c = first; c < last; ++c)
    out += fmt::format("   {:<19.19}", result.channel_name[c]);
  out += fmt::format("\n{:>10}",
                     place_heading(result, rows[(telescope * result.channels() + first) * gates]));
  for (std::size_t c = first; c < last; ++c)
    out += fmt::format("   {:>9} {:>7}  ", "echo", "error");
  out += '\n';
  for (std::size_t gate = 0; gate < gates; gate += step) {
    const auto row = [&](std::size_t c) -> const EchoRow& {
      return rows[(telescope * result.channels() + c) * gates + gate];
    };
    out += fmt::format("{:>10}", place_text(row(first)));
    for (std::size_t c = first; c < last; ++c) out += cell(row(c));
    out += '\n';
  }
  return trimmed(out) + '\n';
}

std::string tables(const tally::Result& result, const std::vector<EchoRow>& rows,
                   std::size_t step) {
  std::string out = result.title.empty() ? "" : result.title + '\n';
  out += "Echo: photons detected in the gate per photon emitted; error: standard error over echo";
  out += step > 1 ? fmt::format("; shown: 1 gate of {}\n\n", step) : "\n\n";
  for (std::size_t t = 0; t < result.telescopes(); ++t) {
    out += fmt::format("telescope {}\n", result.telescope_name[t]);
    for (std::size_t c = 0; c < result.channels(); c += channels_abreast)
      out += block(result, rows, t, c, std::min(c + channels_abreast, result.channels()), step);
  }
  if (result.channels() > 1)
    out += fmt::format("{}: of light scattered once, in the first channel of the table.\n",
                       result.gate_depth_is_range ? "Range" : "Depth");
  return out;
}

std::string converged_counts(const tally::Result& result, const std::vector<EchoRow>& rows) {
  const std::size_t gates = result.gates();
  std::string out = "converged";
  for (std::size_t t = 0; t < result.telescopes(); ++t) {
    if (result.telescopes() > 1) out += fmt::format("\n  {}:", result.telescope_name[t]);
    for (std::size_t c = 0; c < result.channels(); ++c) {
      const auto first =
          rows.begin() + static_cast<std::ptrdiff_t>((t * result.channels() + c) * gates);
      const auto count = std::count_if(first, first + static_cast<std::ptrdiff_t>(gates),
                                       [](const EchoRow& row) { return row.converged(); });
      out += fmt::format("{} {} {} of {} gates", c == 0 ? "" : ",", result.channel_name[c], count,
                         gates);
    }
  }
  return out + '\n';
}

std::string run_summary(const tally::Result& result) {
  std::string out = fmt::format("{} photons in {:.3g} s on {} thread{}", grouped(result.photons),
                                result.wall_time_s, result.threads, result.threads == 1 ? "" : "s");
  if (result.wall_time_s > 0)
    out += fmt::format(": {:.3g} million photons/s, {:.3g} million collisions/s",
                       static_cast<double>(result.photons) / result.wall_time_s / 1e6,
                       static_cast<double>(result.collisions) / result.wall_time_s / 1e6);
  if (const std::string rested = rested_channels(result); !rested.empty())
    out += "\nphotons of channels that met the target before others: " + rested;
  out += fmt::format("\nstopped by: {}{}\n", result.stopped_by,
                     result.partial ? "; this is a partial result" : "");
  for (const auto& warning : result.warnings) out += fmt::format("warning: {}\n", warning);
  return out;
}

}  // namespace

std::string echo_table(const tally::Result& result, std::size_t max_rows) {
  expect(max_rows > 0, "a table has at least one row");
  const std::vector<EchoRow> rows = echo_rows(result);
  const std::size_t step = (result.gates() + max_rows - 1) / max_rows;
  return tables(result, rows, step) + legend(rows) + converged_counts(result, rows) +
         environment_table(result, step) + sensitivity_table(result, step) + run_summary(result);
}

}  // namespace photic::io
