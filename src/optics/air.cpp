#include "optics/air.hpp"

#include <utility>

#include "core/interpolation.hpp"
#include "optics/air_molecules.hpp"
#include "optics/phase_functions.hpp"

namespace photic::optics {
namespace {

constexpr double per_m_of_km = 1e-3;

/// A text once, in a list with semicolons.
void add_source(std::string& list, const std::string& source) {
  if (list.find(source) != std::string::npos) return;
  list += (list.empty() ? "" : "; ") + source;
}

/// Makes the layers one by one.
class LayerMaker {
 public:
  LayerMaker(const AirLibrary& library, const AirProfile& profile, const AerosolChoice& choice,
             double nm, Phases phases, const std::stop_token& stop, AirOptics& out)
      : library_(library),
        profile_(profile),
        choice_(choice),
        nm_(nm),
        phases_(phases),
        stop_(stop),
        out_(out) {}

  /// Between the edges i - 1 and i.
  AirLayer operator()(std::size_t i) {
    AirLayer layer;
    layer.bottom_km = profile_.edges_km[i - 1];
    layer.top_km = profile_.edges_km[i];
    const auto middle = [&](const std::vector<double>& values) {
      return LinearTable(profile_.z_km, values)((layer.bottom_km + layer.top_km) / 2);
    };
    const auto mean = [&](const std::vector<double>& z_km, const std::vector<double>& values) {
      return mean_between(z_km, values, layer.bottom_km, layer.top_km);
    };
    const double air = mean(profile_.z_km, profile_.air_per_m3);
    layer.refractive_index = air_index(nm_, air);
    layer.group_index = 1 + (layer.refractive_index - 1) * air_group_over_phase(nm_);
    layer.molecules_b_per_m = air * air_scattering_m2(nm_);
    const double ozone = mean(profile_.z_km, profile_.ozone_per_m3);
    if (ozone > 0) {
      const Sourced of = ozone_absorption_m2(library_, nm_, middle(profile_.temperature_k));
      layer.ozone_a_per_m = ozone * of.value;
      add_source(out_.ozone_source, of.source);
    }

    layer.scatterers.push_back({layer.molecules_b_per_m, rayleigh(out_.depolarisation)});
    double g_b = 0;
    for (std::size_t k = 0; k < aerosol_regions; ++k) {
      const double at_550_per_m =
          per_m_of_km * mean(profile_.aerosol_z_km, profile_.aerosols_per_km[k]);
      if (at_550_per_m == 0) continue;
      const double humidity = middle(profile_.relative_humidity_percent);
      const AerosolOptics of =
          aerosol_optics(library_, choice_.model[k], nm_, humidity, phases_, stop_);
      const double b = at_550_per_m * of.scattering();
      layer.aerosols_a_per_m += at_550_per_m * of.absorption;
      layer.aerosols_b_per_m += b;
      g_b += b * of.g;
      layer.scatterers.push_back({b, of.phase});
      add_source(out_.aerosols_source, of.source);
    }
    if (layer.aerosols_b_per_m > 0) layer.aerosols_g = g_b / layer.aerosols_b_per_m;
    if (phases_ == Phases::left_out) return layer;
    layer.phase = phase_of(layer.scatterers);
    return layer;
  }

 private:
  const AirLibrary& library_;
  const AirProfile& profile_;
  const AerosolChoice& choice_;
  double nm_;
  Phases phases_;
  const std::stop_token& stop_;
  AirOptics& out_;
};

}  // namespace

PhaseShape phase_of(const std::vector<AirScatterer>& scatterers) {
  double b_per_m = 0;
  for (const AirScatterer& of : scatterers) b_per_m += of.b_per_m;
  std::vector<std::pair<double, PhaseShape>> parts;
  for (const AirScatterer& of : scatterers)
    parts.emplace_back(b_per_m > 0 ? of.b_per_m / b_per_m : 1.0, of.phase);
  return mixture(parts);
}

AirOptics air_at(const AirLibrary& library, const AirProfile& profile,
                 const AerosolChoice& aerosols, double wavelength_nm, Phases phases,
                 const std::stop_token& stop) {
  AirOptics out;
  out.depolarisation = air_depolarisation(wavelength_nm);
  out.profile_source = profile.source;
  out.molecules_source = air_scattering_source;
  LayerMaker make(library, profile, aerosols, wavelength_nm, phases, stop, out);
  for (std::size_t i = 1; i < profile.edges_km.size(); ++i) out.layers.push_back(make(i));
  out.gases_source = "left out";
  if (out.ozone_source.empty()) out.ozone_source = "no ozone";
  if (out.aerosols_source.empty()) out.aerosols_source = "no aerosols";
  return out;
}

}  // namespace photic::optics
