// The light that the filters of channels let through.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace photic::medium {

struct Filter {
  std::vector<double> cuts_nm;                 ///< ascending; nothing passes outside of them, and
                                               ///< between them the transmission is smooth
  std::function<double(double)> transmission;  ///< 0 to 1, by wavelength in nm
};

/// The filter of a channel; none for one that counts a process. Throws InputError for a table that
/// is of no use.
std::optional<Filter> filter_of(const scene::Channel& channel);

/// The filters of all channels of a scene, in their order.
std::vector<std::optional<Filter>> filters_of(const scene::Scene& scene);

}  // namespace photic::medium
