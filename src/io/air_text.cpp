#include "io/air_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/optics_file.hpp"
#include "io/text_columns.hpp"

namespace photic::io {
namespace {

using medium::OpticalTable;

constexpr double km_per_m = 1e-3;

/// Through all layers, by wavelength; of nothing 0.
std::vector<double> optical_depths(const OpticalTable& table, const std::vector<double>& per_m) {
  std::vector<double> depth(table.wavelengths());
  for (std::size_t i = 0; i < per_m.size(); ++i) {
    const std::size_t layer = i / table.wavelengths();
    depth[i % table.wavelengths()] += per_m[i] * (table.last_m[layer] - table.first_m[layer]);
  }
  return depth;
}

std::string depths(const OpticalTable& table) {
  const std::size_t count = table.wavelengths();
  std::vector<TextColumn> columns = {text_column("nm", table.wavelength_nm, 0, count, "{:g}")};
  const auto add = [&](const std::string& heading, const std::vector<double>& depth) {
    columns.push_back(text_column(heading, depth, 0, count, "{:.5f}"));
  };
  for (const auto& [name, a, b, bb] : table.parts) {
    const bool both = !a.empty() && !b.empty();
    if (!b.empty()) add(name + (both ? ", scattering" : ""), optical_depths(table, b));
    if (!a.empty()) add(name + (both ? ", absorption" : ""), optical_depths(table, a));
  }
  std::vector<double> transmission;
  for (const double depth : optical_depths(table, table.c_per_m()))
    transmission.push_back(std::exp(-depth));
  add("transmission", transmission);
  return side_by_side(columns);
}

/// The coefficients of all layers at the first wavelength.
std::string layers(const OpticalTable& table) {
  const auto of = [&](const char* heading, const std::vector<double>& values, const char* format) {
    std::vector<double> first;
    for (std::size_t k = 0; k < table.layers(); ++k)
      first.push_back(values[k * table.wavelengths()]);
    return text_column(heading, first, 0, first.size(), format);
  };
  const auto in_km = [&](const char* heading, std::vector<double> metres) {
    for (double& each : metres) each *= km_per_m;
    return text_column(heading, metres, 0, table.layers(), "{:g}");
  };
  const char* const coefficient = "{:.4g}";
  const char* const ratio = "{:.4f}";
  return side_by_side(
      {in_km("from km", table.first_m), in_km("to km", table.last_m),
       of("a [1/m]", table.a_per_m, coefficient), of("b [1/m]", table.b_per_m, coefficient),
       of("c [1/m]", table.c_per_m(), coefficient), of("b_b [1/m]", table.bb_per_m(), coefficient),
       of("b/c", table.albedo(), ratio), of("g", table.mean_cosine, ratio)});
}

}  // namespace

std::string air_text(const OpticalTable& table) {
  std::string out = fmt::format("Air from {:g} to {:g} km, straight up: optical depths\n\n",
                                table.first_m.front() * km_per_m, table.last_m.back() * km_per_m);
  out += depths(table);
  out += fmt::format("\nIts layers at {:g} nm{}\n\n", table.wavelength_nm.front(),
                     table.wavelengths() == 1 ? "" : " (all wavelengths: -o FILE, --json)");
  out += layers(table) + "\nWhere the numbers come from\n";
  for (const auto& source : table.sources) out += set_back(source_line(source));
  return out;
}

}  // namespace photic::io
