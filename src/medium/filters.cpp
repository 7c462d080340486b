#include "medium/filters.hpp"

#include <cmath>

#include "core/interpolation.hpp"
#include "optics/data_table.hpp"

namespace photic::medium {
namespace {

/// A user's table of wavelength_nm and transmission, straight lines between.
Filter filter_of_table(const optics::DataTable& table) {
  const auto nm = table.ascending_numbers("wavelength_nm");
  const auto passed = table.numbers("transmission");
  if (nm.size() < 2) table.fail(0, "wavelength_nm", "a filter needs two rows or more");
  for (std::size_t i = 0; i < passed.size(); ++i) {
    if (!(passed[i] >= 0 && passed[i] <= 1))
      table.fail(i, "transmission", "a transmission is from 0 to 1", "is it in percent?");
  }
  return {nm, [values = LinearTable(nm, passed)](double wavelength_nm) {
            return values.covers(wavelength_nm) ? values(wavelength_nm) : 0.0;
          }};
}

}  // namespace

std::optional<Filter> filter_of(const scene::Channel& channel) {
  if (channel.process) return std::nullopt;
  if (channel.transmission) return filter_of_table(channel.transmission->data());
  const double centre = *channel.centre_nm;
  const double fwhm = *channel.fwhm_nm;
  if (channel.filter == scene::FilterShape::gaussian) {
    // 2e-5 of what passes lies beyond twice the width.
    return Filter{{centre - 2 * fwhm, centre - fwhm, centre - fwhm / 2, centre + fwhm / 2,
                   centre + fwhm, centre + 2 * fwhm},
                  [centre, fwhm](double nm) {
                    const double t = (nm - centre) / fwhm;
                    return std::abs(t) <= 2 ? std::exp(-4 * std::log(2.0) * t * t) : 0.0;
                  }};
  }
  return Filter{{centre - fwhm / 2, centre + fwhm / 2}, [centre, fwhm](double nm) {
                  return std::abs(nm - centre) <= fwhm / 2 ? 1.0 : 0.0;
                }};
}

std::vector<std::optional<Filter>> filters_of(const scene::Scene& scene) {
  std::vector<std::optional<Filter>> out;
  for (const auto& channel : scene.channel) out.push_back(filter_of(channel));
  return out;
}

}  // namespace photic::medium
