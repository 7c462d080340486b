#include "io/environment_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/echo_rows.hpp"
#include "io/table_parts.hpp"

namespace photic::io {
namespace {

constexpr std::size_t most_shown = 6;  // 10 + 6 * 15 columns: what fits a terminal of 100
constexpr std::size_t widest = 22;

using Rows = std::vector<EchoRow>;

/// The scene's rows and those of the environments that are shown.
struct Shown {
  Rows scene;
  std::vector<Rows> environments;
  std::size_t width = 0;  ///< of a column
};

Shown first_ones(const tally::Result& result) {
  const std::size_t count = std::min(result.environment_name.size(), most_shown);
  Shown out{echo_rows(result), {}, std::min(widest, 90 / count)};
  for (std::size_t e = 0; e < count; ++e) out.environments.push_back(environment_rows(result, e));
  return out;
}

std::string number(double value, int decimals) {
  return value > 999 ? ">999" : fmt::format("{:.{}f}", value, decimals);
}

/// "0.8123±0.0012": two digits of the error, as many as it deserves; smaller ones are told as 1e-4.
std::string ratio_text(const EchoRow& scene, const EchoRow& environment) {
  if (!(scene.echo > 0)) return "-";
  const double ratio = 1 + environment.difference / scene.echo;
  const double error = environment.difference_standard_error / scene.echo;
  if (!std::isfinite(ratio) || !std::isfinite(error)) return "-";
  const int decimals =
      error > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 4) : 4;
  return number(ratio, decimals) + "±" + number(error > 0 ? std::max(error, 1e-4) : 0, decimals);
}

/// The names of the environments, as many lines as the longest takes.
std::string names(const tally::Result& result, const Shown& shown) {
  std::vector<std::vector<std::string>> columns;
  std::size_t lines = 0;
  for (std::size_t e = 0; e < shown.environments.size(); ++e) {
    columns.push_back(wrapped(result.environment_name[e], shown.width - 2));
    lines = std::max(lines, columns.back().size());
  }
  std::string out;
  for (std::size_t i = 0; i < lines; ++i) {
    const std::string depth = result.gate_depth_is_range ? "range [m]" : "depth [m]";
    out += fmt::format("{:>10}", i + 1 == lines ? depth : "");
    for (const auto& column : columns) {
      const std::size_t above = lines - column.size();  // empty: names end in one line
      out += fmt::format("{:>{}} ", i < above ? "" : column[i - above], shown.width - 1);
    }
    out += '\n';
  }
  return out;
}

/// The gates of one telescope and channel, whose first row is `first`.
std::string block(const tally::Result& result, const Shown& shown, std::size_t first,
                  std::size_t step) {
  std::string out = names(result, shown);
  for (std::size_t i = first; i < first + result.gates(); i += step) {
    const EchoRow& scene = shown.scene[i];
    out += fmt::format("{:>10.2f}", scene.depth_m);
    for (const Rows& rows : shown.environments)
      out += fmt::format("{:>{}}{}", ratio_text(scene, rows[i]), shown.width - 1,
                         scene.converged() && rows[i].converged() ? ' ' : '*');
    out += '\n';
  }
  return trimmed(out);
}

/// Why the environments shown have not converged, and how many of their gates have.
std::string below(const tally::Result& result, const Shown& shown) {
  Rows all;
  std::string counts = "converged";
  for (std::size_t e = 0; e < shown.environments.size(); ++e) {
    const Rows& rows = shown.environments[e];
    all.insert(all.end(), rows.begin(), rows.end());
    const auto count =
        std::count_if(rows.begin(), rows.end(), [](const EchoRow& row) { return row.converged(); });
    counts += fmt::format("{} {} {} of {} gates", e == 0 ? "" : ",", result.environment_name[e],
                          count, rows.size());
  }
  return legend(all) + counts + '\n';
}

}  // namespace

std::string environment_table(const tally::Result& result, std::size_t step) {
  if (result.environment_name.empty()) return "";
  const Shown shown = first_ones(result);
  std::string out = "\nEnvironments: echo over that of the scene, with its standard error\n\n";
  for (std::size_t first = 0; first < shown.scene.size(); first += result.gates()) {
    const EchoRow& row = shown.scene[first];
    out += fmt::format("telescope {}, channel {}\n", result.telescope_name[row.telescope],
                       result.channel_name[row.channel]);
    out += block(result, shown, first, step) + '\n';
  }
  const std::size_t more = result.environment_name.size() - shown.environments.size();
  if (more > 0)
    out += fmt::format("{} more environment{} in the file.\n", more, more == 1 ? " is" : "s are");
  return out + below(result, shown) + '\n';
}

}  // namespace photic::io
