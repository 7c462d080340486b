#include "medium/outside_column.hpp"

#include <algorithm>

namespace photic::medium {

double integral_to(const std::vector<double>& edge_m, const std::vector<double>& coefficient,
                   std::size_t line, double to_m) {
  const std::size_t layers = edge_m.size() - 1;
  double sum = 0;
  for (std::size_t k = 0; k < layers; ++k)
    sum +=
        coefficient[line * layers + k] * std::max(0.0, std::min(to_m, edge_m[k + 1]) - edge_m[k]);
  return sum;
}

OutsideColumn column_to(const Air& air, double height_m) {
  OutsideColumn out;
  for (std::size_t l = 0; l < air.a.size() / air.layers(); ++l) {
    out.optical_depth.push_back(integral_to(air.height_m, air.a, l, height_m) +
                                integral_to(air.height_m, air.b, l, height_m));
    out.delay_m.push_back(delay_of(air, l).to(height_m));
  }
  return out;
}

OutsideColumn column_to(const Medium& sea, double depth_m) {
  OutsideColumn out;
  for (std::size_t l = 0; l < sea.line.size(); ++l) {
    out.optical_depth.push_back(integral_to(sea.top, sea.c, l, depth_m));
    out.delay_m.push_back((sea.line[l].group_index - 1) * depth_m);
  }
  if (depth_m > 0) out.per_metre = 1 / depth_m;
  return out;
}

std::vector<double> excess_depths(const Medium& sea, const std::vector<double>& depth_m) {
  const auto rows = static_cast<std::size_t>(sea.environments.count) * sea.line.size();
  std::vector<double> out;
  for (std::size_t e = 0; e < rows; e += sea.line.size())
    for (const double depth : depth_m)
      for (std::size_t l = 0; l < sea.line.size(); ++l)
        out.push_back(integral_to(sea.top, sea.environments.excess_c, e + l, depth));
  return out;
}

AirDelay delay_of(const Air& air, std::size_t line) {
  std::vector<double> to_edge{0};
  for (std::size_t k = 0; k < air.layers(); ++k)
    to_edge.push_back(to_edge.back() + (air.group_index[line * air.layers() + k] - 1) *
                                           (air.height_m[k + 1] - air.height_m[k]));
  return {air.height_m, to_edge};
}

}  // namespace photic::medium
