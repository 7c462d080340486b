// The keys of a constituent that changes with depth, written in place of a number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/rules.hpp"
#include "scene/visitor.hpp"

namespace photic::scene {

/// The rule where points end and layers go on: constant, or none.
struct BeyondPoints {
  std::string above, below;
};

/// Values at depths.
struct ProfilePoints {
  std::vector<double> depth_m, value;
  BeyondPoints beyond;
};

/// A column of a file of text, or a variable of a netCDF file.
struct ProfileFile {
  std::string file;
  optics::ColumnInFile depth;  ///< or the variable of depths
  optics::ColumnInFile column;
  std::string variable;
  std::optional<std::int64_t> profile;  ///< of several in a netCDF file
  std::string negative;                 ///< zero: values below 0 count as 0
  BeyondPoints beyond;
};

/// A formula.
struct ProfileModel {
  std::string model;  ///< gaussian
  double background{}, maximum{}, depth_m{}, width_m{};
};

template <class V>
void describe_beyond(V& v, BeyondPoints& b) {
  v.optional("above", b.above, Choice{{{"constant", "the uppermost value"}}},
             "what holds from the uppermost point up to the top of the layer");
  v.optional("below", b.below, Choice{{{"constant", "the lowermost value"}}},
             "what holds from the lowermost point down to the bottom of the layer");
}

template <class V>
void describe(V& v, ProfilePoints& p) {
  v.required("depth_m", p.depth_m, Numbers{}, "depths in m, ascending");
  v.required(without_unit("value"), p.value, Numbers{}, "the values there; linear between");
  describe_beyond(v, p.beyond);
}

template <class V>
void describe(V& v, ProfileFile& p) {
  v.required(file_key, p.file, File{}, "a file of text, or a netCDF file such as those of floats");
  v.one_of(option(p.column.given(),
                  [&](auto& w) {
                    w.required("column", p.column, ColumnOfFile{},
                               "the values' column of a file of text: its name, or its number "
                               "from 1");
                  }),
           option(!p.variable.empty(), [&](auto& w) {
             w.required("variable", p.variable, Text{}, "the values' variable of a netCDF file");
             w.optional(without_unit("profile"), p.profile, Count{.low = 0},
                        "which of its profiles or casts, from 0");
           }));
  v.required("depth", p.depth, ColumnOfFile{},
             "the column of depths in m, by its name or its number from 1, or the variable of "
             "depths or pressures");
  v.optional("negative", p.negative, Choice{{{"zero", "they count as 0"}}},
             "what happens to values below 0, as dark counts leave them; refused without it");
  describe_beyond(v, p.beyond);
}

template <class V>
void describe(V& v, ProfileModel& p) {
  v.required("model", p.model,
             Choice{{{"gaussian", "a Gaussian maximum on a constant background"}}},
             "the shape: a maximum on a background");
  v.required(without_unit("background"), p.background, not_negative,
             "the value far from the maximum");
  v.required(without_unit("maximum"), p.maximum, not_negative, "the value at the maximum");
  v.required("depth_m", p.depth_m, any_number, "the depth of the maximum in m");
  v.required("width_m", p.width_m, positive, "its standard deviation in m");
}

}  // namespace photic::scene
