// The records that walks keep of a surface whose facets send light on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "estimator/bidirectional/birth.hpp"
#include "estimator/bidirectional/path_point.hpp"
#include "lanes/records.hpp"

namespace photic::estimator {

template <class T>
struct FacetRecords {
  lanes::Records<T, SurfaceEntry<T>> entry;  ///< of each walk that comes through the surface
  std::vector<std::int32_t> sent_down;       ///< facets by which it set out, of each walk
  lanes::Records<T, Ray<T>> behind;          ///< each ray that goes up, as facets have sent it back
  std::vector<std::int32_t> sent_back;       ///< of each ray: 1 if they have
  std::vector<std::int32_t> beyond;  ///< of each telescope's walk, its first ray beyond the pivot
                                     ///< that they have; none: many; empty if nobody asks

  FacetRecords(std::size_t walks, std::size_t rays, bool keeps_beyond)
      : entry(walks),
        sent_down(walks),
        behind(rays),
        sent_back(rays),
        beyond(keeps_beyond ? walks : 0) {}
};

}  // namespace photic::estimator
