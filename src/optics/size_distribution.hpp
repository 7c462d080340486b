// The numbers of particles by size: relative numbers, since optics ask for means over particles.
#pragma once

#include <variant>
#include <vector>

#include "optics/data_table.hpp"

namespace photic::optics {

/// A power law between two radii, named after Junge: particles per radius go as radius^-slope.
struct Junge {
  double slope = 0;
  double min_radius_m = 0, max_radius_m = 0;
  friend auto operator<=>(const Junge&, const Junge&) = default;
};

/// Log-normal in number, cut off at two radii: particles per ln(radius) go as
/// exp(-(ln(radius / mode))^2 / (2 (ln spread)^2)). The mode is the median radius, the spread the
/// geometric standard deviation, above 1 (Hess, Koepke & Schult 1998, Bull. Am. Meteorol. Soc. 79,
/// 831).
struct LogNormal {
  double mode_radius_m = 0;
  double spread = 0;
  double min_radius_m = 0, max_radius_m = 0;
  friend auto operator<=>(const LogNormal&, const LogNormal&) = default;
};

/// Numbers per radius, in any unit, at ascending radii: between them a power law (a straight line
/// where a number is 0), outside them none.
struct SizeTable {
  std::vector<double> radius_m, number;
  friend auto operator<=>(const SizeTable&, const SizeTable&) = default;
};

using SizeDistribution = std::variant<Junge, LogNormal, SizeTable>;

/// Columns radius_um (ascending) and number_per_um (of any one volume). Throws InputError.
SizeTable size_table(const DataTable& table);

/// The radii [m], two or more and ascending, between which the distribution is smooth and outside
/// which there is none. Throws ContractViolation if the distribution is none.
std::vector<double> smooth_between_m(const SizeDistribution& sizes);

/// Particles per ln(radius), relative.
double number_per_log_radius(const SizeDistribution& sizes, double radius_m);

}  // namespace photic::optics
