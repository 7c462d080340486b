// The constituents that absorb the source's light, layer by layer.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace photic::medium {

/// The shares of constituents in the absorption of layers.
struct Absorbers {
  std::vector<std::string> layer;          ///< names
  std::vector<std::string> constituent;    ///< the same, each once
  std::vector<std::vector<double>> share;  ///< [layer][constituent]; those of a layer add up to 1,
                                           ///< or are 0; the last ones may be left out

  /// Adds a layer with the absorption of its constituents [1/m]; a name may come twice. One without
  /// a name is all of them.
  void add(const std::string& name, const std::vector<std::pair<std::string, double>>& a_per_m);
  [[nodiscard]] double share_of(std::size_t of_layer, std::size_t of_constituent) const {
    const auto& shares = share[of_layer];
    return of_constituent < shares.size() ? shares[of_constituent] : 0;
  }
};

}  // namespace photic::medium
