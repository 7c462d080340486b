#include "optics/phytoplankton_table.hpp"

#include <fmt/format.h>

namespace photic::optics {
namespace {

constexpr const char* all_column = "a_m2_per_mg";
constexpr const char* exciting_column = "a_exciting_m2_per_mg";

std::vector<double> exciting(const DataTable& table, const std::vector<double>& all) {
  if (!table.has(exciting_column)) return all;
  auto out = table.numbers_from_0(exciting_column);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i] > all[i])
      table.fail(i, exciting_column,
                 fmt::format("{} {} is more than the {} of all absorption, {}", exciting_column,
                             out[i], all_column, all[i]),
                 "it is a share of it");
  }
  return out;
}

}  // namespace

PhytoplanktonTable phytoplankton_table(const DataTable& table) {
  const auto nm = wavelengths_of(table);
  const auto a = table.numbers_from_0(all_column);
  return {{nm, a},
          {nm, table.numbers_from_0("b_m2_per_mg")},
          {nm, exciting(table, a)},
          "given in " + table.name()};
}

Phytoplankton phytoplankton_of_table(const PhytoplanktonTable& table, double c, double nm) {
  if (c == 0.0) return no_phytoplankton();
  const LinearTable& a = table.a_m2_per_mg;
  if (!a.covers(nm)) no_data("phytoplankton", nm, table.source, a.min(), a.max());
  return {c * a(nm), c * table.a_exciting_m2_per_mg(nm), c * table.b_m2_per_mg(nm), table.source};
}

}  // namespace photic::optics
