#include "tally/grid.hpp"

#include <fmt/format.h>

namespace photic::tally {

std::vector<Grid> echo_grids(std::size_t orders, std::vector<std::string> processes,
                             std::vector<double> depths) {
  const Axis order{
      .name = "order",
      .long_name = fmt::format("scatterings, conversions and bottom reflections of the light, 0: "
                               "of the surface's own echo; "
                               "the last, {}, includes all higher ones",
                               orders - 1),
      .quantity = Quantity::order,
      .count = orders};
  const Axis process{
      .name = "process",
      .long_name =
          "process that changed the light's wavelength; of the laser's wavelength: "
          "bottom, if it touched the sea bed, surface, if it touched nothing but waves, "
          "air, if it was never in the water, else elastic",
      .quantity = Quantity::process,
      .labels = std::move(processes)};
  const Axis depth{.name = "depth",
                   .units = "m",
                   .long_name = "depth of the last scattering",
                   .quantity = Quantity::depth,
                   .edges = std::move(depths),
                   .attributes = {{"standard_name", "depth"}, {"positive", "down"}, {"axis", "Z"}}};
  std::vector<Grid> out{
      {.name = "echo_by_order",
       .long_name = "by order of scattering",
       .part = "echo of an order",
       .axes = {order},
       .beside_walks = {true}},  // no walk carries light that has not been scattered
      {.name = "echo_by_process",
       .long_name = "by process",
       .part = "echo of a process",
       .axes = {process}}};
  if (!depth.edges.empty())
    out.push_back({.name = "echo_by_depth",
                   .long_name = "by depth of the last scattering",
                   .axes = {depth},
                   .profile = true});
  return out;
}

}  // namespace photic::tally
