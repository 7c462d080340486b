// Phase functions given by formulas: per steradian, 1 over the whole sphere, of x = 1 -
// cos(scattering angle).
//
// Each comes as the PhaseShape a PhaseTable is made of. Parameters out of range are InputErrors.
#pragma once

#include <utility>
#include <vector>

#include "optics/library.hpp"
#include "optics/phase_table.hpp"

namespace photic::optics {

PhaseShape isotropic();

/// Molecular scattering with the depolarisation of *natural* light (0.039 for sea water; 0 to 1):
/// 3/(16 pi) 2/(2+rho) [(1+rho) + (1-rho) cos^2]. Morel 1974, in Optical Aspects of Oceanography,
/// Academic Press.
PhaseShape rayleigh(double depolarisation);

/// Raman scattering with the depolarisation of a *polarised* beam (0.17; 0 to 1), another quantity
/// than rayleigh's: 3/(16 pi) (1+3rho)/(1+2rho) [1 + (1-rho)/(1+3rho) cos^2]. Porto 1966, J. Opt.
/// Soc. Am. 56, 1585.
PhaseShape raman_phase(double depolarisation);

/// A sharp peak straight back is finer than the cells of a PhaseTable there.
inline constexpr double lowest_henyey_greenstein_g = -0.4;

/// Henyey & Greenstein 1941, Astrophys. J. 93, 70, eq. (2); g is the mean cosine, below 1.
PhaseShape henyey_greenstein(double g);

/// Mobley's average of Petzold's measurements: the table, continued to 0 degrees by its power law,
/// scaled to 1.
PhaseShape petzold(const Library& library);

/// The sum of shapes times their shares of the scattering, which add up to 1.
PhaseShape mixture(const std::vector<std::pair<double, PhaseShape>>& parts);

}  // namespace photic::optics
