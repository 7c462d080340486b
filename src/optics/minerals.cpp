#include "optics/minerals.hpp"

#include <cmath>

#include "optics/spheres.hpp"

namespace photic::optics {
namespace {

constexpr const char* given = "given in the scene";

/// 2.65 g/cm^3: PREMAR-2F (Barbini et al. 2000).
constexpr double density_g_m3 = 2.65e6;

}  // namespace

Minerals minerals_by_power_law(const MineralsPowerLaw& law, double g_m3, double nm) {
  const MineralsPowerLaw& usual = european_minerals;
  const auto source = [](bool published, const char* where) {
    return std::string(published ? where : given);
  };
  Minerals out;
  out.a_per_m = g_m3 * law.a_443_m2_per_g * std::exp(-law.a_slope_per_nm * (nm - 443));
  out.b_per_m = g_m3 * law.b_555_m2_per_g * std::pow(555 / nm, law.b_exponent);
  out.source = "a at 443 nm " + source(law.a_443_m2_per_g == usual.a_443_m2_per_g,
                                       "Babin, Stramski et al. 2003, J. Geophys. Res. 108(C7), "
                                       "3211 [from memory]");
  out.source +=
      ", its slope " + source(law.a_slope_per_nm == usual.a_slope_per_nm, "the same [verified]");
  out.source += "; b at 555 nm " + source(law.b_555_m2_per_g == usual.b_555_m2_per_g,
                                          "Babin, Morel et al. 2003, Limnol. Oceanogr. 48, 843 "
                                          "[verified]");
  out.source += ", its exponent " + source(law.b_exponent == usual.b_exponent,
                                           "within Doxaran et al. 2009, Limnol. Oceanogr. 54, 1257 "
                                           "[from memory]");
  return out;
}

Minerals minerals_of_spheres(const SphereSections& one, double g_m3) {
  const double spheres_per_m3 = g_m3 / (density_g_m3 * one.volume_m3);
  return {spheres_per_m3 * one.absorption_m2, spheres_per_m3 * one.scattering_m2,
          "spheres by Mie theory, sizes, index and density of PREMAR-2F, Barbini et al. 2000 "
          "[verified]"};
}

}  // namespace photic::optics
