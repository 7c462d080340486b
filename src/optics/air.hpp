// The optics of air at one wavelength, layer by layer.
#pragma once

#include <array>
#include <stop_token>
#include <string>
#include <vector>

#include "optics/air_library.hpp"

namespace photic::optics {

/// The aerosol model (optics/aerosols.hpp) of each region. The default is LOWTRAN 7's.
struct AerosolChoice {
  std::array<std::string, aerosol_regions> model{"rural", "tropospheric", "stratospheric",
                                                 "meteoric"};
};

/// Molecules, or the aerosols of a region, in a layer.
struct AirScatterer {
  double b_per_m = 0;
  PhaseShape phase;  ///< none where aerosols' are left out
};

/// The phase function of all of them together.
PhaseShape phase_of(const std::vector<AirScatterer>& scatterers);

/// The means of a profile between two of its edges.
struct AirLayer {
  double bottom_km = 0, top_km = 0;
  double refractive_index = 1, group_index = 1;
  double molecules_b_per_m = 0;
  double ozone_a_per_m = 0;
  double gases_a_per_m = 0;  ///< by others
  double aerosols_a_per_m = 0, aerosols_b_per_m = 0;
  double aerosols_g = 0;  ///< mean cosine of what aerosols scatter, 0 without aerosols
  PhaseShape phase;       ///< of all that is scattered; none where it is left out
  std::vector<AirScatterer> scatterers;

  [[nodiscard]] double a_per_m() const { return ozone_a_per_m + gases_a_per_m + aerosols_a_per_m; }
  [[nodiscard]] double b_per_m() const { return molecules_b_per_m + aerosols_b_per_m; }
};

struct AirOptics {
  double depolarisation = 0;     ///< of what molecules scatter
  std::vector<AirLayer> layers;  ///< from the lowest edge up
  std::string profile_source, molecules_source, ozone_source, gases_source, aerosols_source;
};

/// Throws InputError for a wavelength without data (200 to 1100 nm; to 1099 nm where
/// there is ozone, from 250 nm for OPAC) or a model that does not exist.
AirOptics air_at(const AirLibrary& library, const AirProfile& profile,
                 const AerosolChoice& aerosols, double wavelength_nm,
                 Phases phases = Phases::wanted, const std::stop_token& stop = {});

}  // namespace photic::optics
