#include "io/columns_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/table_parts.hpp"
#include "io/text_columns.hpp"

namespace photic::io {
namespace {

constexpr std::size_t ratio_width = 15;  // "-0.8123±0.0012*"

using Rows = std::vector<EchoRow>;

/// The rows of the scene, and of some of the columns.
struct Shown {
  Rows scene;
  std::vector<Rows> columns;
};

Shown first_columns(const tally::Result& result, const Columns& columns, std::size_t count) {
  Shown out{echo_rows(result), {}};
  for (std::size_t i = 0; i < count; ++i) out.columns.push_back(columns.rows(i));
  return out;
}

std::string number(double value, int decimals) {
  if (std::abs(value) > 999) return value > 0 ? ">999" : "<-999";
  return fmt::format("{:.{}f}", value, decimals);
}

/// The gates of one telescope and channel, whose first row is `first`, in the columns [from, to).
std::string block(const tally::Result& result, const Columns& columns, const Shown& shown,
                  std::size_t first, std::size_t from, std::size_t to, std::size_t step) {
  std::vector<TextColumn> out{place_column(result, shown.scene[first], result.gates(), step)};
  for (std::size_t c = from; c < to; ++c) {
    out.push_back({column_letters(c) + ' ', {}});
    for (std::size_t i = first; i < first + result.gates(); i += step) {
      const EchoRow &scene = shown.scene[i], &row = shown.columns[c][i];
      out.back().cells.push_back(fmt::format("{:>{}}{}", columns.text(scene, row), ratio_width - 1,
                                             scene.converged() && row.converged() ? ' ' : '*'));
    }
  }
  return side_by_side(out, 1);
}

std::string meanings(const Columns& columns, const Shown& shown, std::size_t width) {
  std::string out;
  for (std::size_t c = 0; c < shown.columns.size(); ++c) {
    const Rows& rows = shown.columns[c];
    const auto converged = std::ranges::count_if(rows, &EchoRow::converged);
    out += paragraph(fmt::format("  {} {} ({} of {} gates converged)", column_letters(c),
                                 columns.meanings[c], converged, rows.size()),
                     width, 4);
  }
  const std::size_t more = columns.meanings.size() - shown.columns.size();
  if (more > 0)
    out += paragraph(fmt::format("  {} more {} in the file, and printed with --table full", more,
                                 more == 1 ? "is" : "are"),
                     width, 4);
  return out;
}

Rows rows_of_all(const Shown& shown) {
  Rows all;
  for (const Rows& rows : shown.columns) all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

}  // namespace

std::string column_letters(std::size_t column) {
  std::string out;
  for (std::size_t left = column + 1; left > 0; left = (left - 1) / 26)
    out.insert(out.begin(), static_cast<char>('A' + (left - 1) % 26));
  return out;
}

std::string with_error(double value, double error) {
  if (!std::isfinite(value) || !std::isfinite(error)) return "-";
  const int decimals =
      error > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 4) : 4;
  return number(value, decimals) + "±" + number(error > 0 ? std::max(error, 1e-4) : 0, decimals);
}

std::string columns_table(const tally::Result& result, const Columns& columns, std::size_t step,
                          const TableLayout& layout) {
  if (columns.meanings.empty()) return "";
  const std::size_t width = std::max(layout.width, min_width);
  const std::size_t abreast = (width - 1 - place_width) / (1 + ratio_width);
  const std::size_t all = columns.meanings.size();
  const Shown shown =
      first_columns(result, columns, layout.all_columns ? all : std::min(all, abreast));
  std::string out = '\n' + paragraph(columns.title, width) + meanings(columns, shown, width) + '\n';
  for (std::size_t first = 0; first < shown.scene.size(); first += result.gates()) {
    const EchoRow& row = shown.scene[first];
    out += paragraph(fmt::format("telescope {}, channel {}", result.telescope_name[row.telescope],
                                 result.channel_name[row.channel]),
                     width);
    for (std::size_t from = 0; from < shown.columns.size(); from += abreast)
      out += block(result, columns, shown, first, from,
                   std::min(from + abreast, shown.columns.size()), step);
    out += '\n';
  }
  return out + legend(rows_of_all(shown), width);
}

}  // namespace photic::io
