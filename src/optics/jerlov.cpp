#include "optics/jerlov.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace photic::optics {
namespace {

constexpr std::array types{"IB", "II", "III", "1C", "3C", "5C"};

}  // namespace

JerlovSpectra::JerlovSpectra(const DataTable& table) {
  for (const char* type : types)
    of_type.emplace(type, AbsorptionAndScattering{{table, fmt::format("a_{}_per_m", type)},
                                                  {table, fmt::format("b_{}_per_m", type)}});
}

JerlovWater jerlov_water(const Library& library, const std::string& type, double nm) {
  constexpr const char* quantity = "Jerlov water type";
  const auto found = library.jerlov.of_type.find(type);
  if (found == library.jerlov.of_type.end())
    no_model(quantity, type, fmt::format("{}", fmt::join(types, ", ")));
  const auto& [a, b] = found->second;
  return {a.at(nm, quantity), b.at(nm, quantity), a.source};
}

}  // namespace photic::optics
