#include "scene/netcdf_levels.hpp"

#include <limits>
#include <utility>

namespace photic::scene {

ProfileVariable::ProfileVariable(const NetcdfColumns& file, const std::string& name)
    : name_(name), variable_(file.read(name)), flags_(file, name) {}

std::string ProfileVariable::at(std::size_t position) const {
  return name_ + shape_of(variable_).index_text(position);
}

Levels ProfileVariable::levels(const std::vector<std::size_t>& positions) const {
  Levels levels;
  for (const std::size_t position : positions) levels.value.push_back(variable_.value[position]);
  Flagged flagged = flags_.judge(positions, levels.value);
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (flagged.is_bad[i]) levels.value[i] = std::numeric_limits<double>::quiet_NaN();
  levels.flagged = std::move(flagged.dropped);
  levels.remarks = std::move(flagged.remarks);
  return levels;
}

}  // namespace photic::scene
