#include "estimator/round_earth.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

#include "core/error.hpp"
#include "geometry/axis.hpp"
#include "medium/lines.hpp"

namespace photic::estimator {
namespace {

constexpr double earth_radius_m = 6371e3;  ///< mean, rounded [moritz2000]
constexpr double noticed = 0.01;           ///< relative difference

/// An axis at the sea.
struct Arrival {
  double range_m, cosine;  ///< to there; to the vertical there, in the air
};

/// docs/theory.md, eq. 104. None beyond the horizon.
std::optional<Arrival> arrival_on_round_earth(double height_m, double cosine) {
  const double from_centre = 1 + height_m / earth_radius_m;  // in radii
  const double sine = from_centre * std::sqrt(1 - cosine * cosine);
  if (sine > 1) return std::nullopt;
  const double there = std::sqrt(1 - sine * sine);
  // (1 + H / R) cos(tilt) - cos(i) without the difference of two large numbers.
  return Arrival{height_m * (1 + from_centre) / (from_centre * cosine + there), there};
}

bool differ(double flat, double round) { return std::abs(round - flat) > noticed * flat; }

std::string distance_text(double metres) {
  return metres < 1e4 ? fmt::format("{:.4g} m", metres) : fmt::format("{:.4g} km", metres / 1e3);
}

template <class Instrument>
void check_axis(const Instrument& instrument, const std::string& path, double n,
                scene::Findings& findings) {
  const std::string direction = scene::below(path, "direction");
  if (!findings.good({direction, scene::below(path, "position_m")})) return;
  const double height = instrument.position_m.z;
  const double cosine = -normalised(instrument.direction).z;
  if (!(height > 0 && cosine > 0)) return;
  const Arrival flat{height / cosine, cosine};
  const auto round = arrival_on_round_earth(height, cosine);
  if (!round)
    return findings.remark(
        direction, fmt::format("on a round earth this axis passes above the horizon; on the flat "
                               "sea of the simulation it meets the surface after {}",
                               distance_text(flat.range_m)));
  const double flat_in_water = geometry::cosine_in_water(flat.cosine, n);
  const double round_in_water = geometry::cosine_in_water(round->cosine, n);
  if (differ(flat.range_m, round->range_m) || differ(flat_in_water, round_in_water))
    findings.remark(
        direction,
        fmt::format("the simulated sea is flat: along this axis the surface is {} away and light "
                    "goes on in the water with the cosine {:.4f} to the vertical; on a round earth "
                    "these are {} and {:.4f}",
                    distance_text(flat.range_m), flat_in_water, distance_text(round->range_m),
                    round_in_water));
}

}  // namespace

void check_round_earth(const scene::Scene& scene, scene::Findings& findings) {
  if (!findings.good({"source.wavelength_nm", "sea"})) return;
  double n = 1;
  try {
    n = medium::refractive_index(scene.sea, scene.source.wavelength_nm);
  } catch (const InputError&) {
    return;  // the medium's check has found that
  }
  check_axis(scene.source, "source", n, findings);
  for (std::size_t t = 0; t < scene.telescope.size(); ++t)
    check_axis(scene.telescope[t], scene::below("telescope", t), n, findings);
}

}  // namespace photic::estimator
