// Checks of [[sea.column]] across keys: the row, and what cannot do with it.
#include <fmt/format.h>

#include <optional>
#include <string>

#include "scene/checks.hpp"
#include "scene/waves.hpp"

namespace photic::scene {
namespace {

/// "sea.column.2.key"
std::string key_of_column(std::size_t i, const char* key) {
  return fmt::format("sea.column.{}.{}", i, key);
}

/// Refuses what no estimator does so far.
void refuse_not_yet(const Scene& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.sea.column.size(); ++i) {
    const Column& column = scene.sea.column[i];
    if (column.oil && findings.good({key_of_column(i, "oil")}))
      findings.add(key_of_column(i, "oil"), "a film of oil on one column is not yet simulated",
                   "leave it out, or give all columns the film: [oil]");
  }
  if (scene.atmosphere && findings.good({"atmosphere"}))
    findings.add("atmosphere", "air above columns of water is not yet simulated",
                 "leave [atmosphere] out, or take [[sea.layer]] in place of [[sea.column]]");
}

/// Checks that a column begins where the one before it ends.
void check_begin(const Column& column, double begin_m, std::size_t i, Findings& findings) {
  const std::string path = key_of_column(i, "x_min_m");
  if (!column.x_min_m || !findings.good({path})) return;
  const char* suggestion = "leave x_min_m out: it is for the first column";
  if (*column.x_min_m > begin_m)
    findings.add(path,
                 fmt::format("there is a gap in the row of columns from x = {} to {} m",
                             plain_number(begin_m), plain_number(*column.x_min_m)),
                 suggestion);
  else if (*column.x_min_m < begin_m)
    findings.add(path,
                 fmt::format("the column begins at x = {} m and overlaps the one before it, which "
                             "ends at {} m",
                             plain_number(*column.x_min_m), plain_number(begin_m)),
                 suggestion);
  else
    findings.add(path, "a column begins where the one before it ends", suggestion);
}

void check_faces(const std::vector<Column>& columns, Findings& findings) {
  std::optional<double> begin_m = columns.front().x_min_m;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string path = key_of_column(i, "x_max_m");
    if (!findings.good({path, key_of_column(0, "x_min_m")})) return;
    if (i > 0) check_begin(columns[i], *begin_m, i, findings);
    const auto& end_m = columns[i].x_max_m;
    if (!end_m && i + 1 < columns.size())
      return findings.add(path, "'x_max_m' is missing in [[sea.column]]",
                          "only the last column may have no end");
    if (begin_m && end_m && *end_m <= *begin_m)
      return findings.add(
          path,
          fmt::format("the column ends at x = {} m, not beyond {} m, where it begins",
                      plain_number(*end_m), plain_number(*begin_m)),
          "list columns in ascending x");
    begin_m = end_m;
  }
}

void check_width(const Sea& sea, Findings& findings) {
  if (!sea.y_min_m || !sea.y_max_m || *sea.y_max_m > *sea.y_min_m) return;
  findings.add("sea.y_max_m",
               fmt::format("the columns end at y = {} m, not beyond {} m, where they begin",
                           plain_number(*sea.y_max_m), plain_number(*sea.y_min_m)),
               "y_max_m must be greater than y_min_m");
}

std::string end_of(const std::optional<double>& bottom_m) {
  return bottom_m ? fmt::format("ends at {} m", plain_number(*bottom_m)) : "is bottomless";
}

/// The depth of the bed is the same everywhere.
void check_depths(const Sea& sea, Findings& findings) {
  const auto stacks = stacks_of(sea);
  for (const Stack& stack : stacks) {
    if (stack.layer.empty() || !findings.good({stack.path, stacks.front().path})) return;
    const auto& bed = stacks.front().layer.back().bottom_depth_m;
    const auto& here = stack.layer.back().bottom_depth_m;
    if (here == bed) continue;
    findings.add(below(below(stack.path, stack.layer.size() - 1), "bottom_depth_m"),
                 fmt::format("the column {}, and the first one {}: a stair of beds is no slope",
                             end_of(here), end_of(bed)),
                 "end all columns at the same depth, or none of them");
  }
}

/// Results call layers by the names of column and layer, with a stroke between them; paths by
/// numbers and names, with points between them.
void check_names(const std::vector<Column>& columns, Findings& findings) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string path = key_of_column(i, "name");
    const std::string& name = columns[i].name;
    if (!findings.good({path})) continue;
    if (name.find('/') != std::string::npos)
      findings.add(path, "the name of a column may not have a '/'",
                   "it stands between column and layer in results: take another letter");
    else if (name.find('.') != std::string::npos)
      findings.add(path, "the name of a column may not have a '.'",
                   "it stands between the keys of paths: take another letter");
    else if (!name.empty() && name.find_first_not_of("0123456789") == std::string::npos)
      findings.add(path, "the name of a column may not be a number",
                   "paths take numbers for the places of columns in the row: add a letter");
  }
}

bool contains(const std::optional<double>& from, double place, const std::optional<double>& to) {
  return !(from && place <= *from) && !(to && place >= *to);
}

/// Refuses an instrument beside the water.
void check_place(const std::string& path, const char* what, const Vec3<double>& place,
                 const Sea& sea, Findings& findings) {
  if (place.z >= 0 || !findings.good({path, "sea"})) return;
  if (!contains(sea.column.front().x_min_m, place.x, sea.column.back().x_max_m))
    findings.add(path,
                 fmt::format("the {} is at x = {} m, beside the row of columns", what,
                             plain_number(place.x)),
                 "move it into a column, or move the end of the row");
  else if (!contains(sea.y_min_m, place.y, sea.y_max_m))
    findings.add(path,
                 fmt::format("the {} is at y = {} m, beside the row of columns", what,
                             plain_number(place.y)),
                 "move it into a column, or move y_min_m or y_max_m");
}

void check_instruments(const Scene& scene, Findings& findings) {
  if (!scene.source.is_everywhere)
    check_place("source.position_m", "source", scene.source.position_m, scene.sea, findings);
  for (std::size_t i = 0; i < scene.telescope.size(); ++i)
    check_place(below(below("telescope", i), "position_m"), "telescope",
                scene.telescope[i].position_m, scene.sea, findings);
  if (scene.source.is_everywhere && !scene.sea.is_alike_everywhere() &&
      findings.good({"source", "sea"}))
    findings.add(
        "source.kind",
        "the light of a beam as wide as the world is followed from one place, which stands "
        "for all places only where the sea is alike everywhere",
        "give the beam a position_m, or take one column without ends");
}

void check_estimator_of_columns(const Scene& scene, Findings& findings) {
  if (scene.simulation.estimator != Estimator::bidirectional ||
      !findings.good({"simulation.estimator"}))
    return;
  findings.add("simulation.estimator",
               "the bidirectional estimator cannot treat " + bidirectional_lacks(scene).value(),
               "write estimator = \"forward\", or take [[sea.layer]] in place of [[sea.column]]");
}

/// A lens looks at a point through different columns, of which the mean over it takes one.
void check_reception_over_columns(const Scene& scene, Findings& findings) {
  if (scene.simulation.reception != Reception::overlap || scene.sea.is_alike_everywhere() ||
      !findings.good({"simulation.reception"}))
    return;
  findings.add("simulation.reception",
               "light comes to the points of a lens through different columns: the mean over the "
               "lens is not known",
               "write reception = \"ray\"");
}

/// Remarks on light straight from above that misses the row.
void remark_on_missed_row(const Scene& scene, Findings& findings) {
  const Source& source = scene.source;
  if (source.is_everywhere || source.fills_cone() || source.position_m.z < 0 ||
      source.direction.z >= 0 || !findings.good({"source", "sea.column"}))
    return;
  const Vec3<double> there =
      source.position_m + source.position_m.z / -source.direction.z * source.direction;
  const Sea& sea = scene.sea;
  if (contains(sea.column.front().x_min_m, there.x, sea.column.back().x_max_m) &&
      contains(sea.y_min_m, there.y, sea.y_max_m))
    return;
  findings.remark("source.position_m",
                  fmt::format("the source's axis meets the sea level at x = {:.6g}, y = {:.6g} m, "
                              "beside the row of columns, where there is no sea",
                              there.x, there.y));
}

}  // namespace

void check_columns(const Scene& scene, Findings& findings) {
  const Sea& sea = scene.sea;
  if (sea.column.empty() || !findings.good({"sea.column"})) return;
  check_faces(sea.column, findings);
  if (findings.good({"sea.y_min_m", "sea.y_max_m"})) check_width(sea, findings);
  check_depths(sea, findings);
  check_names(sea.column, findings);
  check_instruments(scene, findings);
  check_estimator_of_columns(scene, findings);
  check_reception_over_columns(scene, findings);
  remark_on_missed_row(scene, findings);
  refuse_not_yet(scene, findings);
}

}  // namespace photic::scene
