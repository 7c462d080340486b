#include "scene/netcdf_cast_ids.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <set>
#include <utility>

#include "scene/suggest.hpp"
#include "scene/unit_text.hpp"

namespace photic::scene {
namespace {

using NameSet = std::set<std::string>;

/// Finds them for the values of one variable.
class Finder {
 public:
  Finder(const NetcdfColumns& file, const Layout& layout)
      : file_(file),
        layout_(layout),
        values_(layout.shape.size()),
        levels_(layout.shape.dimension[layout.level_axis]) {}

  void find_profiles() {
    if (!layout_.profile_axis) return;
    const std::size_t axis = *layout_.profile_axis;
    CastId id{layout_.shape.dimension[axis], {}, layout_.shape.length[axis]};
    for (std::size_t i = 0; i < values_; ++i) id.value.push_back(layout_.shape.index(axis, i));
    found.push_back(std::move(id));
  }

  void find_counts() {
    std::string counts;
    for (const auto& [name, header] : file_.contents().variable) {
      if (header.text("sample_dimension") != levels_) continue;
      if (!counts.empty())
        file_.fail(name, fmt::format("counts the values of {}, as {} does", levels_, counts),
                   "one variable has the attribute sample_dimension");
      counts = name;
    }
    if (!counts.empty()) found.push_back(by_counts(counts));
  }

  void find_indices() {
    for (const auto& [name, header] : file_.contents().variable)
      if (is_of_levels(header) && !header.text("instance_dimension").empty())
        found.push_back(by_indices(name, header));
  }

  template <class Matches>
  void find_codes(const Matches& matches) {
    for (const auto& [name, header] : file_.contents().variable)
      if (is_of_levels(header) && header.text("instance_dimension").empty() &&
          matches(name, header))
        found.push_back(by_codes(name));
  }

  std::vector<CastId> found;

 private:
  /// Returns whether a variable has a value for each level.
  [[nodiscard]] bool is_of_levels(const NetcdfHeader& header) const {
    const Shape shape = shape_of(header);
    return Alignment::of(shape, layout_.shape) &&
           (shape.axis(levels_) || (layout_.has_own_dimensions && shape.size() == values_));
  }

  [[nodiscard]] CastId by_counts(const std::string& name) const {
    const NetcdfVariable counts = file_.read(name);
    const std::size_t wanted = layout_.shape.length[layout_.level_axis];
    std::vector<std::size_t> of_level;
    for (std::size_t cast = 0; cast < counts.value.size(); ++cast) {
      const double count = counts.value[cast];
      if (!(count >= 0) || count != std::floor(count))
        file_.fail(name + shape_of(counts).index_text(cast),
                   fmt::format("must be a whole number, at least 0, not {:g}", count));
      if (count > static_cast<double>(wanted - of_level.size())) wrong_sum(name, counts);
      of_level.insert(of_level.end(), static_cast<std::size_t>(count), cast);
    }
    if (of_level.size() != wanted) wrong_sum(name, counts);
    CastId id{name, {}, counts.value.size()};
    for (std::size_t i = 0; i < values_; ++i)
      id.value.push_back(of_level[layout_.shape.index(layout_.level_axis, i)]);
    return id;
  }

  [[noreturn]] void wrong_sum(const std::string& name, const NetcdfVariable& counts) const {
    double sum = 0;
    for (const double count : counts.value) sum += count;
    file_.fail(name,
               fmt::format("its counts add up to {:.15g}, and the dimension {} has {} values", sum,
                           levels_, layout_.shape.length[layout_.level_axis]),
               "each value belongs to one cast");
  }

  [[nodiscard]] CastId by_indices(const std::string& name, const NetcdfHeader& header) const {
    const std::string dimension = header.text("instance_dimension");
    const auto casts = file_.contents().dimension.find(dimension);
    if (casts == file_.contents().dimension.end())
      file_.fail(name, fmt::format("its instance_dimension is \"{}\", which the file does not have",
                                   dimension));
    const NetcdfVariable index = file_.read(name);
    const Shape shape = shape_of(index);
    const auto place = Alignment::of(shape, layout_.shape);
    CastId id{name, {}, casts->second};
    for (std::size_t i = 0; i < values_; ++i) {
      const std::size_t at = (*place)(i);
      const double cast = index.value[at];
      const bool is_index =
          cast >= 0 && cast < static_cast<double>(casts->second) && cast == std::floor(cast);
      if (!is_index && !std::isnan(cast))
        file_.fail(name + shape.index_text(at),
                   fmt::format("{:.15g} is no index of {}, which has {}, counted from 0", cast,
                               dimension, casts->second));
      id.value.push_back(is_index ? static_cast<std::size_t>(cast) : NetcdfCodes::none);
    }
    return id;
  }

  [[nodiscard]] CastId by_codes(const std::string& name) const {
    CastId id{name, {}, {}, file_.codes(name)};
    const auto place = Alignment::of(shape_of(id.codes), layout_.shape);
    for (std::size_t i = 0; i < values_; ++i) id.value.push_back(id.codes.value[(*place)(i)]);
    id.codes.value.clear();
    return id;
  }

  const NetcdfColumns& file_;
  const Layout& layout_;
  const std::size_t values_;
  const std::string levels_;
};

/// "profileindex" of profile_index and ProfileIndex.
std::string joined_parts(const std::string& name) {
  return fmt::format("{}", fmt::join(parts_of(name), ""));
}

bool names_casts(const std::string& name, const NetcdfHeader& header) {
  static const NameSet roles{"profile_id", "trajectory_id", "timeseries_id"};
  static const NameSet words{
      "profile",         "profileindex",   "profileid",   "profilenumber", "profilenum",
      "profileno",       "cycle",          "cycleid",     "cyclenumber",   "cast",
      "castindex",       "castid",         "castnumber",  "castno",        "station",
      "stationid",       "stationindex",   "stationname", "stationnumber", "dive",
      "diveid",          "divenumber",     "divenum",     "trajectory",    "trajectoryid",
      "trajectoryindex", "trajectoryname", "platform",    "platformid",    "platformnumber",
      "platformname",    "platformcode",   "wmo",         "wmoid",         "wmonumber",
      "floatid",         "cruise",         "cruiseid",    "deployment",    "deploymentid"};
  const std::string word = joined_parts(name);
  // Ascents and descents of floats have the same cycle; other directions are angles.
  return roles.contains(header.text("cf_role")) || words.contains(word) ||
         (word == "direction" && !header.has_numbers);
}

bool names_time(const std::string& name, const NetcdfHeader& header) {
  static const NameSet names{"time", "juld"};
  return header.text("standard_name") == "time" || names.contains(lower_case(name));
}

bool names_place(const std::string& name, const NetcdfHeader& header) {
  static const NameSet standard_names{"latitude", "longitude"};
  static const NameSet names{"latitude", "lat", "longitude", "lon"};
  return standard_names.contains(header.text("standard_name")) || names.contains(lower_case(name));
}

/// Gliders number what lies between two profiles by halves (SOCIB's toolbox; from memory).
void drop_halves(CastId& id) {
  if (id.casts || joined_parts(id.name) != "profileindex" || id.codes.number.empty()) return;
  for (std::size_t& code : id.value) {
    if (code == NetcdfCodes::none) continue;
    const double number = id.codes.number[code];
    if (number != std::floor(number)) code = NetcdfCodes::none;
  }
}

}  // namespace

std::string CastId::label(std::size_t code) const {
  return casts ? fmt::format("{}", code) : codes.code_text(code);
}

std::vector<CastId> cast_ids(const NetcdfColumns& file, const Layout& layout) {
  Finder finder(file, layout);
  finder.find_profiles();
  finder.find_counts();
  finder.find_indices();
  finder.find_codes(names_casts);
  for (CastId& id : finder.found) drop_halves(id);
  return std::move(finder.found);
}

std::vector<std::vector<CastId>> times_and_places(const NetcdfColumns& file, const Layout& layout) {
  Finder places(file, layout), times(file, layout);
  places.find_codes(names_place);
  times.find_codes(names_time);
  std::vector<CastId> both = places.found;
  both.insert(both.end(), times.found.begin(), times.found.end());
  return {std::move(both), std::move(places.found), std::move(times.found)};
}

}  // namespace photic::scene
