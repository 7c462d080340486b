// The column of air, or water, straight between the sea surface and an instrument that stands
// outside the medium whose light is followed.
#pragma once

#include <cstddef>
#include <vector>

#include "medium/air.hpp"
#include "medium/medium.hpp"

namespace photic::medium {

/// For each line.
struct OutsideColumn {
  std::vector<double> optical_depth;
  std::vector<double> delay_m;  ///< by how much the group path is longer than in a vacuum
  double per_metre = 0;         ///< see geometry::OutsideColumn
};

/// The integral of a coefficient, [line][layer], from the surface to a distance; 0 for one below 0.
/// `edge_m`: of the layers, from 0 on.
double integral_to(const std::vector<double>& edge_m, const std::vector<double>& coefficient,
                   std::size_t line, double to_m);
/// The air straight up from the sea to a height.
OutsideColumn column_to(const Air& air, double height_m);
/// The water straight down to a depth.
OutsideColumn column_to(const Medium& sea, double depth_m);

/// By how much the water straight down to depths is deeper in each environment of the sea,
/// [environment][depth][line]; 0 for depths above it.
std::vector<double> excess_depths(const Medium& sea, const std::vector<double>& depth_m);

AirDelay delay_of(const Air& air, std::size_t line);

}  // namespace photic::medium
