#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/optics_file.hpp"
#include "io/optics_table.hpp"
#include "io/table_parts.hpp"

namespace photic::io {
namespace {

using medium::OpticalTable;

constexpr std::size_t width = 100;          ///< of lines that can be broken
constexpr std::size_t lines_told_each = 3;  ///< of a process; of more only where they lie

/// A heading and the numbers below it.
struct TextColumn {
  std::string heading;
  std::vector<std::string> cells;
};

TextColumn column(const std::string& heading, const std::vector<double>& values, std::size_t first,
                  std::size_t count, const char* format) {
  TextColumn out{heading, {}};
  for (std::size_t i = first; i < first + count; ++i) {
    std::string cell = std::isnan(values[i]) ? "?" : fmt::format(fmt::runtime(format), values[i]);
    if (cell.starts_with("-0.") && cell.find_first_of("123456789") == std::string::npos)
      cell.erase(0, 1);  // g of molecules is 0, but for rounding
    out.cells.push_back(std::move(cell));
  }
  return out;
}

/// Columns side by side, to the right in their widths.
std::string side_by_side(const std::vector<TextColumn>& columns) {
  std::string out;
  const auto add_line = [&](const auto& text_of) {
    for (const TextColumn& c : columns) {
      std::size_t wide = c.heading.size();
      for (const std::string& cell : c.cells) wide = std::max(wide, cell.size());
      out += fmt::format("  {:>{}}", text_of(c), wide);
    }
    out += '\n';
  };
  add_line([](const TextColumn& c) { return c.heading; });
  for (std::size_t i = 0; i < columns.front().cells.size(); ++i)
    add_line([i](const TextColumn& c) { return c.cells[i]; });
  return out;
}

TextColumn wavelengths(const OpticalTable& table) {
  return column("nm", table.wavelength_nm, 0, table.wavelengths(), "{:.2f}");
}

std::string totals(const OpticalTable& table, std::size_t layer) {
  const std::size_t count = table.wavelengths(), first = layer * count;
  const auto of = [&](const char* heading, const std::vector<double>& values, const char* format) {
    return column(heading, values, first, count, format);
  };
  const char* const coefficient = "{:#.5g}";
  const char* const ratio = "{:.4f}";
  return side_by_side(
      {wavelengths(table), of("a [1/m]", table.a_per_m, coefficient),
       of("b [1/m]", table.b_per_m, coefficient), of("c [1/m]", table.c_per_m(), coefficient),
       of("b_b [1/m]", table.bb_per_m(), coefficient), of("b/c", table.albedo(), ratio),
       of("b_b/b", table.backscatter_fraction, "{:.5f}"), of("g", table.mean_cosine, ratio)});
}

/// Nothing if they are not known.
std::string parts(const OpticalTable& table, std::size_t layer) {
  const std::size_t count = table.wavelengths(), first = layer * count;
  std::vector<TextColumn> columns = {wavelengths(table)};
  for (const auto& [name, a, b, bb] : table.parts) {
    const auto add = [&](const char* letter, const std::vector<double>& values) {
      if (!values.empty() && !std::isnan(values[first]))
        columns.push_back(
            column(fmt::format("{} {}", letter, name), values, first, count, "{:#.5g}"));
    };
    add("a", a);
    add("b", b);
    add("b_b", bb);
  }
  return columns.size() == 1 ? "" : "\n  of these, by constituent [1/m]\n" + side_by_side(columns);
}

std::string emission_line(const OpticalTable::Emission& emission, std::size_t layer) {
  const double coefficient = emission.coefficient_per_m[layer];
  if (coefficient == 0) return fmt::format("    {}: nothing\n", emission.process);
  const auto& nm = emission.wavelength_nm;
  std::string out = fmt::format("    {}: {:.4g} 1/m at ", emission.process, coefficient);
  if (nm.size() > lines_told_each)
    return out +
           fmt::format("{:.2f} to {:.2f} nm, in {} lines\n", nm.front(), nm.back(), nm.size());
  for (std::size_t i = 0; i < nm.size(); ++i)
    out += fmt::format("{}{:.2f}", i == 0 ? "" : ", ", nm[i]);
  return out + " nm\n";
}

std::string layer_text(const OpticalTable& table, std::size_t layer) {
  const double bottom = table.edge_m[layer + 1];
  std::string out =
      fmt::format("Layer \"{}\", from {:g} m {}\n", table.layer_name[layer], table.edge_m[layer],
                  std::isinf(bottom) ? "down, bottomless" : fmt::format("to {:g} m", bottom));
  out += totals(table, layer) + parts(table, layer);
  out += fmt::format("\n  light emitted, in photons per metre and photon of {:.6g} nm\n",
                     table.excitation_nm);
  for (const auto& emission : table.emission) out += emission_line(emission, layer);
  return out + '\n';
}

/// A line of any length, broken; what follows the first is set back.
std::string set_back(const std::string& line) {
  std::string out;
  for (const std::string& part : wrapped(line, width - 4))
    out += (out.empty() ? "  " : "    ") + part + '\n';
  return out;
}

}  // namespace

std::string optics_text(const OpticalTable& table) {
  std::string out;
  for (std::size_t k = 0; k < table.layers(); ++k) out += layer_text(table, k);
  out += "Where the numbers come from\n";
  for (const auto& source : table.sources) out += set_back(source_line(source));
  for (const auto& emission : table.emission)
    for (const std::string& line : source_lines(emission)) out += set_back(line);
  return out;
}

}  // namespace photic::io
