#include "optics/aerosols.hpp"

#include <algorithm>
#include <cmath>

#include "core/interpolation.hpp"
#include "optics/air_library.hpp"
#include "optics/phase_functions.hpp"

namespace photic::optics {
namespace {

/// The positions of the interpolation between two values each, in wavelength and humidity.
struct Steps {
  std::size_t wavelength;
  double t_wavelength, t_humidity;

  double operator()(const std::vector<double>& dry, const std::vector<double>& moist) const {
    const std::size_t i = wavelength;
    return geometric_lerp(geometric_lerp(dry[i - 1], dry[i], t_wavelength),
                          geometric_lerp(moist[i - 1], moist[i], t_wavelength), t_humidity);
  }
};

}  // namespace

AerosolModel::Columns AerosolModel::columns(const DataTable& table, const std::string& suffix) {
  return {table.numbers("extinction" + suffix), table.numbers("absorption" + suffix),
          table.numbers("g" + suffix)};
}

AerosolModel::AerosolModel(const DataTable& table)
    : wavelength_nm_(table.ascending_numbers("wavelength_nm")), source_(source_of(table)) {
  if (wavelength_nm_.size() < 2)
    table.fail(0, "wavelength_nm", "an aerosol model needs two rows or more");
  const auto& names = table.columns();
  if (std::find(names.begin(), names.end(), "extinction") != names.end()) {
    humidity_percent_ = {0, 99};  // the same at all of them
    at_humidity_.assign(2, columns(table, ""));
    return;
  }
  for (const int humidity : {0, 70, 80, 99}) {
    humidity_percent_.push_back(humidity);
    at_humidity_.push_back(columns(table, "_rh" + std::to_string(humidity)));
  }
}

AerosolOptics AerosolModel::at(double nm, double relative_humidity_percent) const {
  const auto& w = wavelength_nm_;
  if (!(nm >= w.front() && nm <= w.back()))
    no_data("aerosol", nm, source_, w.front(), w.back(), "choose another wavelength");
  const auto& rh = humidity_percent_;
  const double humidity = std::clamp(relative_humidity_percent, rh.front(), rh.back());
  const auto dryness = [](double percent) { return std::log(100 - percent); };
  const std::size_t i = interval_of(w, nm).upper, k = interval_of(rh, humidity).upper;
  const Steps steps{
      i, std::log(nm / w[i - 1]) / std::log(w[i] / w[i - 1]),
      (dryness(humidity) - dryness(rh[k - 1])) / (dryness(rh[k]) - dryness(rh[k - 1]))};
  const Columns &dry = at_humidity_[k - 1], &moist = at_humidity_[k];
  AerosolOptics out;
  out.extinction = steps(dry.extinction, moist.extinction);
  out.absorption = steps(dry.absorption, moist.absorption);
  out.g = steps(dry.g, moist.g);
  out.phase = henyey_greenstein(out.g);
  out.source = source_;
  return out;
}

AerosolOptics aerosol_optics(const AirLibrary& library, const std::string& model,
                             double wavelength_nm, double relative_humidity_percent, Phases phases,
                             const std::stop_token& stop) {
  const std::string opac = "opac-";
  if (model.starts_with(opac))
    return library.opac.at(library.spheres, model.substr(opac.size()), wavelength_nm, phases, stop);
  const auto found = library.aerosols.find(model);
  if (found == library.aerosols.end()) {
    no_model("aerosol", model,
             "rural, maritime, urban, tropospheric, fog-advection, fog-radiation, stratospheric, "
             "meteoric, opac-waso-80 and so on");
  }
  return found->second.at(wavelength_nm, relative_humidity_percent);
}

}  // namespace photic::optics
