#include "io/columns_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/table_parts.hpp"

namespace photic::io {
namespace {

constexpr std::size_t most_shown = 6;  // 10 + 6 * 15 columns: what fits a terminal of 100
constexpr std::size_t widest = 22;

using Rows = std::vector<EchoRow>;

/// The scene's rows and those of the columns that are shown.
struct Shown {
  Rows scene;
  std::vector<Rows> columns;
  std::size_t width = 0;  ///< of a column
};

Shown first_ones(const tally::Result& result, const Columns& columns) {
  const std::size_t count = std::min(columns.names.size(), most_shown);
  Shown out{echo_rows(result), {}, std::min(widest, 90 / count)};
  for (std::size_t i = 0; i < count; ++i) out.columns.push_back(columns.rows(i));
  return out;
}

std::string number(double value, int decimals) {
  if (std::abs(value) > 999) return value > 0 ? ">999" : "<-999";
  return fmt::format("{:.{}f}", value, decimals);
}

/// The names of the columns, as many lines as the longest takes.
std::string names(const std::string& place, const Columns& all, const Shown& shown) {
  std::vector<std::vector<std::string>> columns;
  std::size_t lines = 0;
  for (std::size_t e = 0; e < shown.columns.size(); ++e) {
    columns.push_back(wrapped(all.names[e], shown.width - 2));
    lines = std::max(lines, columns.back().size());
  }
  std::string out;
  for (std::size_t i = 0; i < lines; ++i) {
    out += fmt::format("{:>10}", i + 1 == lines ? place : "");
    for (const auto& column : columns) {
      const std::size_t above = lines - column.size();  // empty: names end in one line
      out += fmt::format("{:>{}} ", i < above ? "" : column[i - above], shown.width - 1);
    }
    out += '\n';
  }
  return out;
}

/// The gates of one telescope and channel, whose first row is `first`.
std::string block(const tally::Result& result, const Columns& columns, const Shown& shown,
                  std::size_t first, std::size_t step) {
  std::string out = names(place_heading(result, shown.scene[first]), columns, shown);
  for (std::size_t i = first; i < first + result.gates(); i += step) {
    const EchoRow& scene = shown.scene[i];
    out += fmt::format("{:>10}", place_text(scene));
    for (const Rows& rows : shown.columns)
      out += fmt::format("{:>{}}{}", columns.text(scene, rows[i]), shown.width - 1,
                         scene.converged() && rows[i].converged() ? ' ' : '*');
    out += '\n';
  }
  return trimmed(out);
}

/// Why the columns shown have not converged, and how many of their gates have.
std::string below(const Columns& columns, const Shown& shown) {
  Rows all;
  std::string counts = "converged";
  for (std::size_t e = 0; e < shown.columns.size(); ++e) {
    const Rows& rows = shown.columns[e];
    all.insert(all.end(), rows.begin(), rows.end());
    const auto count =
        std::count_if(rows.begin(), rows.end(), [](const EchoRow& row) { return row.converged(); });
    counts += fmt::format("{} {} {} of {} gates", e == 0 ? "" : ",", columns.names[e], count,
                          rows.size());
  }
  return legend(all) + counts + '\n';
}

}  // namespace

std::string with_error(double value, double error) {
  if (!std::isfinite(value) || !std::isfinite(error)) return "-";
  const int decimals =
      error > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 4) : 4;
  return number(value, decimals) + "±" + number(error > 0 ? std::max(error, 1e-4) : 0, decimals);
}

std::string columns_table(const tally::Result& result, const Columns& columns, std::size_t step) {
  if (columns.names.empty()) return "";
  const Shown shown = first_ones(result, columns);
  std::string out = fmt::format("\n{}\n\n", columns.title);
  for (std::size_t first = 0; first < shown.scene.size(); first += result.gates()) {
    const EchoRow& row = shown.scene[first];
    out += fmt::format("telescope {}, channel {}\n", result.telescope_name[row.telescope],
                       result.channel_name[row.channel]);
    out += block(result, columns, shown, first, step) + '\n';
  }
  const std::size_t more = columns.names.size() - shown.columns.size();
  if (more > 0)
    out +=
        fmt::format("{} more {}{} in the file.\n", more, columns.noun, more == 1 ? " is" : "s are");
  return out + below(columns, shown) + '\n';
}

}  // namespace photic::io
