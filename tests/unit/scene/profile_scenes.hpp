// Scenes whose chlorophyll is a profile in a file.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "unit/scene/written_files.hpp"

namespace photic::scene {

inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The base scene with this for the chlorophyll of its first layer, from line 22 on, column 21.
inline std::string profiled(const std::string& profile) {
  return edited({{22, 22, "chlorophyll_mg_m3 = { " + profile + " }"}});
}

/// Of all layers but a bottomless one.
inline double mean_of(const Scene& scene, double Layer::*value) {
  double sum = 0, top = 0;
  for (const Layer& layer : scene.sea.layer) {
    if (!layer.bottom_depth_m) break;
    sum += layer.*value * (*layer.bottom_depth_m - top);
    top = *layer.bottom_depth_m;
  }
  return sum / top;
}

inline double mean_chlorophyll(const Scene& scene) {
  return mean_of(scene, &Layer::chlorophyll_mg_m3);
}

inline const std::string from_float = "file = 'float.nc', depth = 'PRES', variable = 'CHLA'";

/// Two profiles of five levels, the second shallower by far.
inline void write_float(WrittenFiles& files) {
  files.write("float.nc", "");
  const std::vector<std::string> dimensions{"N_PROF", "N_LEVELS"};
  files.netcdf["PRES"] = {dimensions, {2, 5}, "decibar", {0, 5, 10, 20, 30, 0, 1, 2, 3, 4}};
  files.netcdf["CHLA"] = {dimensions, {2, 5}, "mg/m3", {0.1, 0.2, 0.4, 0.3, 0.3, 9, 9, 9, 9, 9}};
  files.netcdf["LATITUDE"] = {{"N_PROF"}, {2}, "degree_north", {30, 60}};
}

/// One profile against depths in m.
inline void write_depths(WrittenFiles& files, const std::vector<double>& depth_m,
                         const std::vector<double>& value) {
  files.write("float.nc", "");
  files.netcdf["z"] = {{"z"}, {depth_m.size()}, "m", depth_m};
  files.netcdf["CHLA"] = {{"z"}, {value.size()}, "mg/m3", value};
}

inline const std::string from_depths = "file = 'float.nc', depth = 'z', variable = 'CHLA'";

/// The remarks on the profile of a scene, without place and file.
inline Texts remarks_of(const WrittenFiles& files, const Reading& reading) {
  Texts texts;
  for (const std::string& remark : reading.remarks) {
    std::string text = files.without_folder(remark);
    for (const std::string head : {"scene.toml:22:21: ", "float.nc: ", "chl.csv: "})
      if (text.starts_with(head)) text.erase(0, head.size());
    texts.push_back(text);
  }
  return texts;
}

}  // namespace photic::scene
