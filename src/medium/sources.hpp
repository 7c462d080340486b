// The sources of numbers, each named once for all wavelengths that it served for.
#pragma once

#include <string>
#include <vector>

namespace photic::medium {

struct Contribution;

struct Source {
  std::string quantity;              ///< "a of water"
  double first_nm = 0, last_nm = 0;  ///< the wavelengths it was taken for
  std::string source;
};

/// Adds where a number comes from, or another wavelength that it comes from there at.
void add_source(const std::string& quantity, const std::string& source, double wavelength_nm,
                std::vector<Source>& sources);
/// The same of what a constituent adds to a and b.
void add_source(const Contribution& contribution, double wavelength_nm,
                std::vector<Source>& sources);

/// "a of water, 400-700 nm: Pope & Fry 1997 …"
std::string source_line(const Source& source);

}  // namespace photic::medium
