#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/constants.hpp"
#include "optics/aerosol_profiles.hpp"
#include "scene/checks.hpp"

namespace photic::scene {
namespace {

/// Air of the sea level has an index of 1.0003. Bent light is known up to these: by the axis of an
/// instrument and what is near it alone.
constexpr double max_of_air_index = 1.001, max_bent_deg = 60;

/// Light is scattered close to a lens in the air, by angles that differ over the lens.
void check_reception_in_air(const Scene& scene, Findings& findings) {
  if (scene.simulation.reception == Reception::overlap && findings.good({"simulation.reception"}))
    findings.add("simulation.reception",
                 "light that [atmosphere] scatters close to the lens lights it unevenly: the mean "
                 "over the lens is not known",
                 "write reception = \"ray\"");
}

void check_heights(const std::vector<AirLayer>& layers, Findings& findings) {
  double ground = 0;  // where the layer should begin
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string path = below("atmosphere.layer", i);
    const std::string bottom = below(path, "bottom_height_m"), top = below(path, "top_height_m");
    const AirLayer& layer = layers[i];
    if (!findings.good({bottom, top})) return;
    const std::string from = plain_number(layer.bottom_height_m), here = plain_number(ground);
    const std::string suggestion = fmt::format("write bottom_height_m = {}", here);
    if (layer.bottom_height_m != ground && i == 0)
      findings.add(bottom, fmt::format("the air begins at {} m, not at the sea", from), suggestion);
    else if (layer.bottom_height_m > ground)
      findings.add(bottom, fmt::format("there is a gap in the air from {} to {} m", here, from),
                   suggestion);
    else if (layer.bottom_height_m < ground)
      findings.add(bottom,
                   fmt::format("the layer begins at {} m, below {} m, where the one below it ends",
                               from, here),
                   suggestion);
    if (layer.top_height_m <= layer.bottom_height_m)
      findings.add(top,
                   fmt::format("the layer ends at {} m, not above {} m, where it begins",
                               plain_number(layer.top_height_m), from),
                   "layers go from the sea up");
    ground = layer.top_height_m;
  }
}

void check_iop(const AirLayer& layer, const std::string& path, Findings& findings) {
  if (!findings.good({path})) return;
  for (std::size_t k = 1; k < layer.iop.size(); ++k) {
    const double before = layer.iop[k - 1].wavelength_nm, here = layer.iop[k].wavelength_nm;
    if (!(here > before))
      findings.add(
          below(below(path, k), "wavelength_nm"),
          fmt::format("{} nm does not come after {} nm", plain_number(here), plain_number(before)),
          "sort the iop by ascending wavelength, each once");
  }
}

/// The spheres of "mie" have an index relative to water.
void refuse_spheres(const PhaseFunction& function, const std::string& path, Findings& findings) {
  for (std::size_t k = 0; k < function.components.size(); ++k)
    refuse_spheres(function.components[k], below(below(path, "components"), k), findings);
  if (function.model == PhaseModel::mie)
    findings.add(path, "the spheres of \"mie\" are in water, and not in air",
                 "take another model, or a table");
}

/// Two keys say how much aerosol there is.
void check_aerosols(const Atmosphere& air, Findings& findings) {
  const char* depth = "atmosphere.aerosol_optical_depth_550";
  const bool has_depth = air.aerosol_optical_depth_550.has_value();
  if (has_depth && air.visibility_km)
    findings.add(depth, "it takes the place of visibility_km, which is also given",
                 "leave one of them out");
  else if (!air.has_aerosols() && (has_depth || air.visibility_km))
    findings.add(has_depth ? depth : "atmosphere.visibility_km",
                 "aerosol = \"none\" says that there are no aerosols", "leave one of them out");
}

/// Remarks on values that are possible, but more likely to be in another unit.
void remark_units(const Atmosphere& air, Findings& findings) {
  constexpr double max_fraction = 1, clearest_km = 100, thickest_fog_per_m = 0.1;
  const double humidity = air.relative_humidity_percent.value_or(0);
  if (humidity > 0 && humidity <= max_fraction)
    findings.remark("atmosphere.relative_humidity_percent",
                    fmt::format("{0} % is very dry: is it a fraction? {0} of saturation would be "
                                "{1}",
                                plain_number(humidity), plain_number(100 * humidity)));
  if (air.visibility_km.value_or(0) > clearest_km)
    findings.remark("atmosphere.visibility_km",
                    fmt::format("air of {} km visibility is hardly ever seen: is it in m?",
                                plain_number(*air.visibility_km)));
  for (std::size_t i = 0; i < air.layer.size(); ++i) {
    const AirLayer& layer = air.layer[i];
    const std::string path = below("atmosphere.layer", i);
    if (layer.refractive_index > max_of_air_index && !air.refraction)
      findings.remark(below(path, "refractive_index"),
                      fmt::format("no air has a refractive index of {}: at the sea it is 1.0003",
                                  plain_number(layer.refractive_index)));
    const auto extinction = [](const IopEntry& at) { return at.a_per_m + at.b_per_m; };
    const auto thickest = std::ranges::max_element(layer.iop, {}, extinction);
    if (thickest == layer.iop.end() || extinction(*thickest) <= thickest_fog_per_m) continue;
    findings.remark(below(path, "iop"),
                    fmt::format("an extinction of {} per m is that of the densest fog, of {:.2g} m "
                                "visibility: is it in 1/km?",
                                plain_number(extinction(*thickest)),
                                optics::contrast_depth / extinction(*thickest)));
  }
}

void check_gases(const Atmosphere& air, Findings& findings) {
  double below_km = 0;
  for (std::size_t i = 0; i < air.gases.size(); ++i) {
    const std::string path = below(below("atmosphere.gases", i), "top_km");
    if (!findings.good({path, "atmosphere.top_km"})) return;
    const double top_km = air.gases[i].top_km;
    if (top_km <= below_km)
      findings.add(path,
                   fmt::format("{} km is not above the {} km before it", plain_number(top_km),
                               plain_number(below_km)),
                   "rungs go from the sea up");
    else if (top_km > air.top_km)
      findings.add(path,
                   fmt::format("{} km is above the top of the air at {} km", plain_number(top_km),
                               plain_number(air.top_km)),
                   "leave it out, or write a higher top_km");
    below_km = top_km;
  }
}

/// Light that is bent is known along the axes of instruments in the air that look down.
void check_refraction(const Scene& scene, Findings& findings) {
  const auto check = [&](const std::string& of, const Vec3<double>& position,
                         const Vec3<double>& direction) {
    const std::string path = below(of, "direction");
    if (!findings.good({path, below(of, "position_m")}) || position.z < 0) return;
    if (dot(direction, direction) == 0) return;
    if (-normalised(direction).z < std::cos(max_bent_deg * radian_per_degree))
      findings.add(
          path,
          fmt::format(
              "the axis is more than {:g} degrees off nadir, where refraction is not computed",
              max_bent_deg),
          "look down more steeply, or leave atmosphere.refraction out");
  };
  if (scene.is_of_air_alone() && findings.good({"atmosphere.refraction", "atmosphere.surface"}))
    return findings.add("atmosphere.refraction",
                        "plane air above a ground does not bend light: axes are bent over a sea",
                        "leave it out, or write geometry = \"spherical\"");
  if (scene.source.is_pulsed())
    check("source", scene.source.position_m, scene.source.direction);
  else if (findings.good({"source.kind", "atmosphere.refraction"}))
    findings.add("atmosphere.refraction",
                 "in plane air bent light is known along the axes of lasers and telescopes alone",
                 "leave it out, write geometry = \"spherical\", or take source.kind = \"laser\"");
  for (std::size_t i = 0; i < scene.telescope.size(); ++i)
    check(below("telescope", i), scene.telescope[i].position_m, scene.telescope[i].direction);
  for (std::size_t i = 0; i < scene.atmosphere->layer.size(); ++i) {
    const std::string path = below(below("atmosphere.layer", i), "refractive_index");
    if (findings.good({path}) && scene.atmosphere->layer[i].refractive_index > max_of_air_index)
      findings.add(
          path,
          fmt::format(
              "air of such an index bends light too much: with refraction it can be {:g} at most",
              max_of_air_index),
          "write a lower index, or leave atmosphere.refraction out");
  }
}

}  // namespace

std::optional<double> top_of_air_m(const Scene& scene, const Findings& findings) {
  constexpr double metres_per_km = 1000;
  if (!scene.atmosphere || !findings.good({"atmosphere.layer", "atmosphere.top_km"})) return {};
  const auto& layers = scene.atmosphere->layer;
  return layers.empty() ? metres_per_km * scene.atmosphere->top_km : layers.back().top_height_m;
}

void check_atmosphere(const Scene& scene, Findings& findings) {
  if (!scene.atmosphere) return;
  const Atmosphere& air = *scene.atmosphere;
  check_reception_in_air(scene, findings);
  if (findings.good({"atmosphere.aerosol", "atmosphere.visibility_km",
                     "atmosphere.aerosol_optical_depth_550"}))
    check_aerosols(air, findings);
  if (findings.good({"atmosphere"})) remark_units(air, findings);
  check_gases(air, findings);
  if (const auto* table = air.surface ? std::get_if<UserTable>(&air.surface->albedo) : nullptr;
      table && findings.good({"atmosphere.surface"}))
    check_albedo(*table, "atmosphere.surface.albedo", findings);
  if (air.refraction && !air.is_spherical()) check_refraction(scene, findings);
  check_heights(air.layer, findings);
  for (std::size_t i = 0; i < air.layer.size(); ++i) {
    const std::string path = below("atmosphere.layer", i);
    check_iop(air.layer[i], below(path, "iop"), findings);
    const std::string function = below(path, "phase_function");
    if (air.layer[i].phase_function && findings.good({function}))
      refuse_spheres(*air.layer[i].phase_function, function, findings);
  }
}

}  // namespace photic::scene
