// The way through the surface as the estimators ask for it: what a detector cannot see is known
// before.
#pragma once

#include "transport/connect.hpp"
#include "unit/transport/sea.hpp"

namespace photic::transport {

template <class T>
Connection<T> connect_if_seen(const Sea& sea, const instrument::Telescope<T>& telescope,
                              const Photon<T>& at, const Index<T>& line) {
  return connect_through_surface(sea.view(), telescope, at, line,
                                 may_see(sea.view(), telescope, at.position, line));
}

}  // namespace photic::transport
