#include "scene/bed_albedo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "core/interpolation.hpp"

namespace photic::scene {
namespace {

/// The nodes at which an albedo is known. A variable that it does not depend on has no nodes.
struct AlbedoGrid {
  std::vector<double> nm, deg;
  std::vector<double> albedo;  ///< [nm][deg]
};

std::vector<double> values_of(const UserTable& table, const char* column) {
  const auto found = std::ranges::find(table.columns(), column, &UserTable::Column::name);
  return found == table.columns().end() ? std::vector<double>{} : found->values;
}

AlbedoGrid grid_of(const Bottom& bottom) {
  if (const auto* number = std::get_if<double>(&bottom.albedo)) return {{}, {}, {*number}};
  const auto& table = std::get<UserTable>(bottom.albedo);
  AlbedoGrid grid{values_of(table, "wavelength_nm"), values_of(table, "zenith_deg"),
                  values_of(table, "albedo")};
  if (!grid.nm.empty() && !grid.deg.empty()) {
    // Rows go through all angles of each wavelength.
    grid.nm.erase(std::unique(grid.nm.begin(), grid.nm.end()), grid.nm.end());
    grid.deg.resize(grid.albedo.size() / grid.nm.size());
  }
  return grid;
}

/// Interpolates linearly between two neighbours; `at` returns the value of a node by its number.
template <class At>
double between_nodes(const std::vector<double>& nodes, double x, const At& at) {
  if (nodes.empty()) return at(0);
  const auto [upper, t] = interval_of(nodes, x);
  return (1 - t) * at(upper - 1) + t * at(upper);
}

}  // namespace

double albedo_of(const Bottom& bottom, double wavelength_nm, double zenith_deg) {
  expect(zenith_deg >= 0 && zenith_deg <= 90, "light comes to the sea bed from above");
  if (const auto* number = std::get_if<double>(&bottom.albedo)) return *number;
  const auto [nm, deg, albedo] = grid_of(bottom);
  if (!nm.empty() && (wavelength_nm < nm.front() || wavelength_nm > nm.back()))
    throw InputError({{"", 0, 0,
                       fmt::format("the sea bed's albedo covers {:g} to {:g} nm, not {:.6g} nm",
                                   nm.front(), nm.back(), wavelength_nm),
                       "add rows for it"}});
  const std::size_t angles = std::max<std::size_t>(1, deg.size());
  return between_nodes(nm, wavelength_nm, [&](std::size_t i) {
    return between_nodes(deg, zenith_deg, [&](std::size_t k) { return albedo[i * angles + k]; });
  });
}

bool depends_on_angle(const Bottom& bottom) { return !grid_of(bottom).deg.empty(); }

std::optional<double> angle_lit_by_one_alone(const std::optional<Bottom>& one,
                                             const std::optional<Bottom>& other,
                                             double wavelength_nm) {
  // Straight lines that are positive at all nodes of both are so between them.
  std::vector<double> angles{0, 90};
  for (const auto& bed : {one, other})
    if (bed) std::ranges::copy(grid_of(*bed).deg, std::back_inserter(angles));
  const auto reflects = [&](const std::optional<Bottom>& bed, double deg) {
    return bed && albedo_of(*bed, wavelength_nm, deg) > 0;
  };
  const auto found = std::ranges::find_if(
      angles, [&](double deg) { return reflects(one, deg) && !reflects(other, deg); });
  return found == angles.end() ? std::nullopt : std::optional(*found);
}

std::optional<double> angle_lit_there_alone(const Environment& there, const Scene& here,
                                            double wavelength_nm) {
  const auto beds_there = beds_of(there.sea, there.bottom), beds = beds_of(here.sea, here.bottom);
  if (beds_there.size() != beds.size()) return std::nullopt;  // not read so far, or refused
  for (std::size_t k = 0; k < beds.size(); ++k)
    if (const auto angle =
            angle_lit_by_one_alone(beds_there[k].bottom, beds[k].bottom, wavelength_nm))
      return angle;
  return std::nullopt;
}

std::string reported_albedo(const Bottom& bottom) {
  const AlbedoGrid grid = grid_of(bottom);
  const auto [least, most] = std::ranges::minmax(grid.albedo);
  const std::string values = least == most
                                 ? plain_number(least)
                                 : fmt::format("{} to {}", plain_number(least), plain_number(most));
  const auto* table = std::get_if<UserTable>(&bottom.albedo);
  const bool from_file = table && table->data().column_line() > 0;
  return values + (from_file ? ", given in " + table->data().name() : ", given");
}

}  // namespace photic::scene
