// The inversion of conversions by walks from telescopes.
#pragma once

#include "core/constants.hpp"
#include "core/vec3.hpp"
#include "medium/medium.hpp"
#include "surface/lambert.hpp"

namespace photic::estimator {

/// So many vertices of a telescope's walk invert conversions alike.
inline constexpr double first_vertices = 1;

/// The inversion of conversions by a walk from a telescope: its chance, and its directions.
/// Converted light leaves in all directions, but the light it was made of comes along the laser's
/// beam, which some scatterings of the laser's light look for, too. Where that is vertical, the
/// densities depend on the angle to the vertical alone.
template <class T>
struct InverseConversion {
  T probability{};  ///< at a vertex, of the walk's first ones
  T directed{};     ///< share of directions drawn about the beam, with the shape `lobe`; the rest
                    ///< is drawn from all alike
  Vec3<T> beam;     ///< of the laser in the water, a unit vector
  Index<T> lobe{};  ///< a table of the medium
  T scattered{};    ///< share of directions drawn so where the laser's light is scattered

  /// The chance where a telescope detects `line`: 0 for the laser's own and where that line is not
  /// emitted. `before`: vertices that the walk has had. Behind the first few ever fewer conversions
  /// are inverted: of n vertices more a walk leaves them all out with a chance of about 1 / (n p).
  /// So light that is scattered many times after its conversion, as in wide views, is not left to a
  /// few walks of great weight, which a constant p would make as rare as (1 - p)^n.
  T chance(const medium::MediumView& sea, const Index<T>& line, const Index<T>& layer,
           const Index<T>& before) const {
    const T emitted = gather<T>(sea.conversion, sea.at(line, layer));
    const T beyond = to_real<T>(before) - T(first_vertices);
    const T rarer = T(1) + probability * select(beyond > T(0), beyond, T(0));
    return select((line > Index<T>(0)) & (emitted > T(0)), probability / rarer, T(0));
  }

  /// The density of directions drawn over the phase function's value `p`.
  T over_phase(const medium::MediumView& sea, const Vec3<T>& direction, const T& p) const {
    const T x = one_minus_cos(beam, direction);
    return ((T(1) - directed) * T(0.25 / pi) + directed * sea.phases.template value<T>(x, lobe)) /
           p;
  }
  /// The same where a walk from a telescope scatters the laser's light; the bed draws all alike.
  T scattered_over_phase(const medium::MediumView& sea, const Index<T>& layer,
                         const Vec3<T>& direction, const T& p) const {
    if (!any(scattered > T(0))) return T(1);
    const T x = one_minus_cos(beam, direction);
    const T over = T(1) + scattered * (sea.phases.template value<T>(x, lobe) / p - T(1));
    return sea.bed_angles == 0 ? over : select(surface::on_bed<T>(sea, layer), T(1), over);
  }
  /// The chance over the phase function's value that a walk from a telescope which detects `line`
  /// inverts a conversion at a vertex where the path `converts`, or scatters the laser's light
  /// elsewhere.
  T goes_on(const medium::MediumView& sea, const Index<T>& line, const Index<T>& layer,
            const Index<T>& before, const Mask<T>& converts, const Vec3<T>& direction,
            const T& p) const {
    const T scatters = scattered_over_phase(sea, layer, direction, p);
    if (!any(converts)) return scatters;
    return select(converts, chance(sea, line, layer, before) * over_phase(sea, direction, p),
                  scatters);
  }
};

}  // namespace photic::estimator
