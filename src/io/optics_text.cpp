#include <fmt/format.h>

#include <cmath>

#include "io/air_text.hpp"
#include "io/optics_file.hpp"
#include "io/optics_table.hpp"
#include "io/text_columns.hpp"

namespace photic::io {
namespace {

using medium::OpticalTable;

constexpr std::size_t lines_listed_each = 3;  ///< of a process; of more only where they lie

TextColumn wavelengths(const OpticalTable& table) {
  return text_column("nm", table.wavelength_nm, 0, table.wavelengths(), "{:.2f}");
}

std::string totals(const OpticalTable& table, std::size_t layer) {
  const std::size_t count = table.wavelengths(), first = layer * count;
  const auto of = [&](const char* heading, const std::vector<double>& values, const char* format) {
    return text_column(heading, values, first, count, format);
  };
  const char* const coefficient = "{:#.5g}";
  const char* const ratio = "{:.4f}";
  return side_by_side(
      {wavelengths(table), of("a [1/m]", table.a_per_m, coefficient),
       of("b [1/m]", table.b_per_m, coefficient), of("c [1/m]", table.c_per_m(), coefficient),
       of("b_b [1/m]", table.bb_per_m(), coefficient), of("b/c", table.albedo(), ratio),
       of("b_b/b", table.backscatter_fraction, "{:.5f}"), of("g", table.mean_cosine, ratio)});
}

/// Empty if they are not known.
std::string parts(const OpticalTable& table, std::size_t layer) {
  const std::size_t count = table.wavelengths(), first = layer * count;
  std::vector<TextColumn> columns = {wavelengths(table)};
  for (const auto& [name, a, b, bb] : table.parts) {
    const auto add = [&](const char* letter, const std::vector<double>& values) {
      if (!values.empty() && !std::isnan(values[first]))
        columns.push_back(
            text_column(fmt::format("{} {}", letter, name), values, first, count, "{:#.5g}"));
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
  if (nm.size() > lines_listed_each)
    return out +
           fmt::format("{:.2f} to {:.2f} nm, in {} lines\n", nm.front(), nm.back(), nm.size());
  for (std::size_t i = 0; i < nm.size(); ++i)
    out += fmt::format("{}{:.2f}", i == 0 ? "" : ", ", nm[i]);
  return out + " nm\n";
}

std::string layer_text(const OpticalTable& table, std::size_t layer) {
  const double bottom = table.last_m[layer];
  std::string out =
      fmt::format("Layer \"{}\", from {:g} m {}\n", table.layer_name[layer], table.first_m[layer],
                  std::isinf(bottom) ? "down, bottomless" : fmt::format("to {:g} m", bottom));
  out += totals(table, layer) + parts(table, layer);
  out += fmt::format("\n  light emitted, in photons per metre and photon of {:.6g} nm\n",
                     table.excitation_nm);
  for (const auto& emission : table.emission) out += emission_line(emission, layer);
  return out + '\n';
}

}  // namespace

std::string optics_text(const OpticalTable& table) {
  if (table.of == medium::Layered::air) return air_text(table);
  std::string out;
  for (std::size_t k = 0; k < table.layers(); ++k) out += layer_text(table, k);
  out += "Where the numbers come from\n";
  for (const auto& source : table.sources) out += set_back(source_line(source));
  for (const auto& emission : table.emission)
    for (const std::string& line : source_lines(emission)) out += set_back(line);
  return out;
}

}  // namespace photic::io
