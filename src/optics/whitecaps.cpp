#include "optics/whitecaps.hpp"

#include <algorithm>
#include <cmath>

namespace photic::optics {
namespace {

/// Throws InputError where there are no data.
double reflectance_at(const Spectrum& of, double wavelength_nm, const char* suggestion) {
  if (!of.values.covers(wavelength_nm))
    no_data("whitecap reflectance", wavelength_nm, of.source, of.values.min(), of.values.max(),
            suggestion);
  return of.values(wavelength_nm);
}

}  // namespace

Sourced whitecap_fraction_monahan(double wind_speed_m_s) {
  return {std::min(1.0, 2.95e-6 * std::pow(wind_speed_m_s, 3.52)),
          "Monahan & O'Muircheartaigh 1980, J. Phys. Oceanogr. 10, 2094 [uncertain by a factor of "
          "two]"};
}

Sourced whitecap_fraction_stramska(double wind_speed_m_s) {
  constexpr double calm = 6.33;
  return {
      std::min(1.0, 8.75e-5 * std::pow(std::max(0.0, wind_speed_m_s - calm), 3)),
      "Stramska & Petelski 2003, J. Geophys. Res. 108(C3), 3086 [uncertain by a factor of two]"};
}

Sourced whitecap_reflectance_koepke(const Library& library, double wavelength_nm) {
  const Spectrum& of = library.whitecaps_koepke;
  return {
      reflectance_at(of, wavelength_nm, "choose another wavelength, or write whitecaps = false"),
      of.source};
}

Sourced whitecap_reflectance_frouin(const Library& library, double wavelength_nm) {
  constexpr double short_waves_nm = 412;
  const Spectrum &base = library.whitecaps_koepke, &relative = library.whitecaps_frouin;
  const double share = reflectance_at(
      relative, wavelength_nm, "write whitecap_reflectance = \"koepke1984\", or whitecaps = false");
  return {share * whitecap_reflectance_koepke(library, short_waves_nm).value,
          base.source + "; " + relative.source};
}

}  // namespace photic::optics
