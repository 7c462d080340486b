#include "scene/netcdf_latitude.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "scene/unit_text.hpp"

namespace photic::scene {
namespace {

/// The variable that has them; "" if there is none.
std::string latitude_name(const NetcdfColumns& file) {
  std::string found;
  for (const auto& [name, header] : file.contents().variable) {
    if (!header.has_numbers) continue;
    const std::string word = lower_case(name);
    if (word == "latitude") return name;
    if (word == "lat" || header.text("standard_name") == "latitude") found = name;
  }
  return found;
}

}  // namespace

std::optional<double> latitude_deg(const NetcdfColumns& file, const Layout& layout,
                                   const Cast& cast) {
  const std::string name = latitude_name(file);
  if (name.empty()) return std::nullopt;
  const NetcdfVariable latitude = file.read(name);
  const auto place = Alignment::of(shape_of(latitude), layout.shape);
  std::vector<std::size_t> positions{cast.number};  // of a variable of casts
  if (place) {
    positions.clear();
    for (const std::size_t i : cast.value) positions.push_back((*place)(i));
  }
  double sum = 0, count = 0;
  for (const std::size_t i : positions) {
    if (i >= latitude.value.size() || !(std::fabs(latitude.value[i]) <= 90)) continue;
    sum += latitude.value[i];
    count += 1;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

}  // namespace photic::scene
