#include "io/table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "io/echo_rows.hpp"
#include "io/environment_table.hpp"
#include "io/sensitivity_table.hpp"
#include "io/table_parts.hpp"
#include "io/tally_table.hpp"
#include "io/text_columns.hpp"

namespace photic::io {
namespace {

constexpr std::size_t blanks = 3;  // before a column

/// Beside the depth.
std::size_t channels_abreast(std::size_t width) {
  return std::max<std::size_t>(1, (width - blanks - place_width) / (blanks + cell_width));
}

/// One telescope's gates for the channels [first, last).
std::string block(const tally::Result& result, const std::vector<EchoRow>& rows,
                  std::size_t telescope, std::size_t first, std::size_t last, std::size_t step) {
  const std::size_t gates = result.gates();
  const auto row = [&](std::size_t c, std::size_t gate) -> const EchoRow& {
    return rows[(telescope * result.channels() + c) * gates + gate];
  };
  std::vector<TextColumn> columns{place_column(result, row(first, 0), gates, step)};
  for (std::size_t c = first; c < last; ++c) {
    columns.push_back({estimate_heading(result.channel_name[c], "echo"), {}});
    for (std::size_t gate = 0; gate < gates; gate += step)
      columns.back().cells.push_back(
          estimate_cell(row(c, gate).echo, row(c, gate).relative_error, row(c, gate).converged()));
  }
  return side_by_side(columns, blanks) + '\n';
}

std::string tables(const tally::Result& result, const std::vector<EchoRow>& rows, std::size_t step,
                   std::size_t width) {
  const std::string about =
      "Echo: photons detected in the gate per photon emitted; error: standard error over echo";
  std::string out = paragraph(about, width);
  if (step > 1) out += fmt::format("Shown: 1 gate of {}; --table full shows all\n", step);
  out += '\n';
  const std::size_t abreast = channels_abreast(width);
  for (std::size_t t = 0; t < result.telescopes(); ++t) {
    out += fmt::format("telescope {}\n", result.telescope_name[t]);
    for (std::size_t c = 0; c < result.channels(); c += abreast)
      out += block(result, rows, t, c, std::min(c + abreast, result.channels()), step);
  }
  if (result.channels() > 1)
    out += paragraph(fmt::format("{}: of light scattered once, in the first channel of the table.",
                                 result.gate_depth_is_range ? "Range" : "Depth"),
                     width);
  return out;
}

/// The counts of one telescope: "elastic 45 of 100 gates, raman 94".
std::string converged_counts(const tally::Result& result, const std::vector<EchoRow>& rows,
                             std::size_t telescope) {
  const auto gates = static_cast<std::ptrdiff_t>(result.gates());
  std::string out;
  for (std::size_t c = 0; c < result.channels(); ++c) {
    const auto first =
        rows.begin() + static_cast<std::ptrdiff_t>(telescope * result.channels() + c) * gates;
    const auto count =
        std::count_if(first, first + gates, [](const EchoRow& row) { return row.converged(); });
    out += fmt::format("{}{} {} of {}", c == 0 ? "" : ", ", result.channel_name[c], count, gates);
  }
  return out + " gates";
}

std::string converged(const tally::Result& result, const std::vector<EchoRow>& rows,
                      std::size_t width) {
  if (result.telescopes() == 1)
    return paragraph("converged: " + converged_counts(result, rows, 0), width);
  std::string out = "converged\n";
  for (std::size_t t = 0; t < result.telescopes(); ++t)
    out += paragraph("  " + result.telescope_name[t] + ": " + converged_counts(result, rows, t),
                     width, 4);
  return out;
}

std::string pace(const tally::Result& result) {
  std::string out = fmt::format("{} photons in {:.3g} s on {} thread{}",
                                with_prefix(static_cast<double>(result.photons)),
                                result.wall_time_s, result.threads, result.threads == 1 ? "" : "s");
  if (result.wall_time_s > 0)
    out += fmt::format(": {} photons/s, {} collisions/s",
                       with_prefix(static_cast<double>(result.photons) / result.wall_time_s),
                       with_prefix(static_cast<double>(result.collisions) / result.wall_time_s));
  return out;
}

std::string made_by(const tally::Result& result) {
  return fmt::format(
      "estimator: {}{}; seed: {}; engine: {}", result.estimator,
      result.estimator_reason.empty() ? "" : " (auto: " + result.estimator_reason + ")",
      result.seed, result.engine);
}

}  // namespace

std::string run_summary(const tally::Result& result, std::size_t width) {
  std::string out = result.has_echoes() ? converged(result, echo_rows(result), width) : "";
  out += converged_tallies(result, width) + paragraph(pace(result), width) +
         paragraph(made_by(result), width);
  if (const std::string rested = rested_channels(result); !rested.empty())
    out += paragraph("photons of channels that met the target before others: " + rested, width);
  out += fmt::format("stopped by: {}{}\n", result.stopped_by,
                     result.partial ? "; this is a partial result" : "");
  for (const auto& warning : result.warnings) out += paragraph("warning: " + warning, width);
  return out;
}

namespace {

std::string of_echoes(const tally::Result& result, const TableLayout& layout, std::size_t width) {
  if (!result.has_echoes()) return "";
  const std::vector<EchoRow> rows = echo_rows(result);
  const std::size_t step = layout.step(result.gates());
  return tables(result, rows, step, width) + legend(rows, width) +
         environment_table(result, step, layout) + sensitivity_table(result, step, layout) + '\n';
}

}  // namespace

std::string echo_table(const tally::Result& result, const TableLayout& layout) {
  expect(layout.max_rows > 0, "a table has at least one row");
  const std::size_t width = std::max(layout.width, min_width);
  const std::string title = result.title.empty() ? "" : paragraph(result.title, width);
  return title + of_echoes(result, layout, width) + tally_table(result, layout) +
         run_summary(result, width);
}

}  // namespace photic::io
