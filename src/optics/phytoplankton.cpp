#include "optics/phytoplankton.hpp"

#include <algorithm>
#include <cmath>

namespace photic::optics {
namespace {

constexpr const char* quantity = "phytoplankton absorption";

double particles(const Library& library, double c, double nm) {
  return library.particles_a.at(nm, quantity) * std::pow(c, library.particles_e.at(nm, quantity));
}

/// The factor on a spectrum's value at the nearer end of its table, for a wavelength beyond it.
double shape_beyond(const Library& library, double c, double nm, double end_nm) {
  return nm == end_nm ? 1.0 : particles(library, c, nm) / particles(library, c, end_nm);
}

Phytoplankton bricaud(const Library& library, double c, double nm) {
  const LinearTable& a = library.phytoplankton_a.values;
  const double inside = std::clamp(nm, a.min(), a.max());
  const double at_end = a(inside) * std::pow(c, 1 - library.phytoplankton_b.values(inside));
  const double all = particles(library, c, nm);
  Phytoplankton out;
  out.a_per_m = all;
  out.a_exciting_per_m = std::min(all, at_end * shape_beyond(library, c, nm, inside));
  // Gordon & Morel 1983, Remote Assessment of Ocean Color, Springer; case-1 water.
  out.b_per_m = 0.30 * (550.0 / nm) * std::pow(c, 0.62);
  out.source =
      library.particles_a.source + "; exciting " + library.phytoplankton_a.source +
      "; scattering Gordon & Morel 1983, Remote Assessment of Ocean Color, Springer [verified]";
  return out;
}

Phytoplankton prieur_sathyendranath(const Library& library, double c, double nm) {
  const LinearTable& relative = library.relative_a_c.values;
  const double inside = std::clamp(nm, relative.min(), relative.max());
  Phytoplankton out;
  out.a_per_m = 0.06 * std::pow(c, 0.602) * relative(inside) * shape_beyond(library, c, nm, inside);
  out.a_exciting_per_m = out.a_per_m;
  out.b_per_m = 0.33 * (550.0 / nm) * std::pow(c, 0.620);
  out.source =
      library.relative_a_c.source + " and PREMAR-2F, which also gives the scattering [verified]";
  return out;
}

}  // namespace

Phytoplankton phytoplankton(const Library& library, const std::string& model,
                            double chlorophyll_mg_m3, double wavelength_nm) {
  const bool modern = model == "bricaud";
  if (!modern && model != "prieur-sathyendranath")
    no_model("phytoplankton", model, "bricaud, prieur-sathyendranath");
  if (chlorophyll_mg_m3 == 0.0) return no_phytoplankton();
  return modern ? bricaud(library, chlorophyll_mg_m3, wavelength_nm)
                : prieur_sathyendranath(library, chlorophyll_mg_m3, wavelength_nm);
}

}  // namespace photic::optics
