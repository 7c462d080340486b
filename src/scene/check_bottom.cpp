#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "core/error.hpp"
#include "optics/library.hpp"
#include "optics/table_text.hpp"
#include "scene/checks.hpp"

namespace photic::scene {
namespace {

constexpr const char* nm_column = "wavelength_nm";
constexpr const char* deg_column = "zenith_deg";

/// A column, from 0 to `most`.
std::vector<double> numbers_to(double most, const char* column, const optics::DataTable& table,
                               const char* suggestion) {
  std::vector<double> out = table.numbers_from_0(column);
  std::vector<Diagnostic> found;
  for (std::size_t row = 0; row < out.size(); ++row) {
    if (out[row] <= most) continue;
    const auto [line, at] = table.place(row, column);
    found.push_back({table.name(), line, at,
                     fmt::format("{} {} is above {}", column, out[row], most), suggestion});
  }
  optics::raise_together(std::move(found), out.size());
  return out;
}

/// Angles from 0 to 90, the same for every wavelength, if there are any.
void check_angles(const optics::DataTable& table) {
  const auto deg = numbers_to(90, deg_column, table, "0 is straight down, 90 along the bed");
  const auto nm =
      table.has(nm_column) ? table.numbers_from_0(nm_column) : std::vector<double>(deg.size(), 0.0);
  std::size_t count = 0;
  while (count < nm.size() && nm[count] == nm[0]) ++count;
  if (count == 1 && deg.size() > 1)
    table.fail(1, nm_column, fmt::format("wavelength_nm {} has no row at every angle", nm[0]),
               "give a row for each pair, sorted by wavelength, then angle");
  for (std::size_t i = 0; i < deg.size(); ++i) {
    const std::size_t k = i % count;
    if (i > 0 && nm[i] < nm[i - 1])
      table.fail(i, nm_column, fmt::format("wavelength_nm {} comes after {}", nm[i], nm[i - 1]),
                 "wavelengths ascend, all angles of one together");
    if (i >= count && (deg[i] != deg[k] || (nm[i] == nm[i - 1]) != (k > 0)))
      table.fail(i, deg_column, "every wavelength must have the same angles", "");
    if (i > 0 && k > 0 && deg[i] <= deg[i - 1])
      table.fail(i, deg_column,
                 fmt::format("zenith_deg {} is not above the {} before it", deg[i], deg[i - 1]),
                 "angles ascend");
    const char* whole = "give the albedo from 0 to 90 degrees";
    if (k == 0 && deg[i] != 0)
      table.fail(i, deg_column, fmt::format("the angles begin at {} degrees, not at 0", deg[i]),
                 whole);
    if (k + 1 == count && deg[i] != 90)
      table.fail(i, deg_column, fmt::format("the angles end at {} degrees, not at 90", deg[i]),
                 whole);
  }
  const std::size_t last = deg.size() - 1;
  if (deg.size() % count != 0)
    table.fail(last, deg_column, "every wavelength must have the same angles", "");
  if (table.has(nm_column) && deg.size() == count)
    table.fail(last, nm_column, "there is only one wavelength",
               "add others, or leave wavelength_nm out if the albedo is the same at all");
}

/// The medium's table has even steps of sqrt(1 - cos), of about so many degrees at most.
constexpr double finest_deg = 0.5;

void remark_on_fine_angles(const optics::DataTable& table, const std::string& path,
                           Findings& findings) {
  const auto deg = table.numbers_from_0(deg_column);
  for (std::size_t i = 1; i < deg.size(); ++i)
    if (deg[i] > deg[i - 1] && deg[i] - deg[i - 1] < finest_deg)
      return findings.remark(
          path, fmt::format("the albedo is smoothed over {} degrees: {} and {} are closer",
                            finest_deg, deg[i - 1], deg[i]));
}

}  // namespace

void check_albedo(const UserTable& table, const std::string& path, Findings& findings) {
  try {
    numbers_to(1, "albedo", table.data(), "it is the share of the light that is reflected");
    if (table.data().has(deg_column)) {
      check_angles(table.data());
      remark_on_fine_angles(table.data(), path, findings);
    } else {
      optics::wavelengths_of(table.data());
    }
  } catch (const InputError& error) {
    for (const Diagnostic& d : error.diagnostics()) {
      const Place place{d.file, d.line, d.column};
      findings.add(path, d.line > 0 ? place : findings.place_of(path), d.reason, d.suggestion);
    }
  }
}

namespace {

/// The bed at a path, below some layers. `label`: its section.
void check_bed(const Bottom& bottom, const std::string& path, const char* label, const Stack& stack,
               Findings& findings) {
  if (!findings.good({path})) return;
  if (const auto* table = std::get_if<UserTable>(&bottom.albedo))
    check_albedo(*table, below(path, "albedo"), findings);
  if (stack.layer.empty() || stack.layer.back().bottom_depth_m || !findings.good({"sea"})) return;
  findings.add(
      path, "the sea has no bed: its last layer is bottomless",
      fmt::format("give the last [[{}]] its bottom_depth_m{}, or leave {} out", stack.section,
                  stack.name.empty() ? " (a sea by iop_table has none)" : "", label));
}

}  // namespace

bool has_bed(const Scene& scene) {
  return std::ranges::any_of(beds_of(scene.sea, scene.bottom),
                             [](const PlacedBed& at) { return at.bottom.has_value(); });
}

void check_bottom(const Scene& scene, Findings& findings) {
  const auto stacks = stacks_of(scene.sea);
  if (scene.bottom) check_bed(*scene.bottom, "bottom", "[bottom]", stacks.front(), findings);
  for (std::size_t i = 0; i < scene.sea.column.size(); ++i) {
    const auto& bottom = scene.sea.column[i].bottom;
    const std::string path = below(below("sea.column", i), "bottom");
    if (!bottom) continue;
    check_bed(*bottom, path, "[sea.column.bottom]", stacks[i], findings);
    if (scene.bottom && findings.good({path}))
      findings.add(path, "[bottom] is the bed of all columns, and this is that of one",
                   "keep one of them");
  }
}

}  // namespace photic::scene
