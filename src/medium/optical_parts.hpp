// The effect of each constituent of the layers, for the table of their optics.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "medium/layer_optics.hpp"
#include "medium/optical_table.hpp"

namespace photic::medium {

/// The optics of every layer at every wavelength, in the table's order.
using WatersOptics = std::vector<WaterOptics>;

/// The backscattering of each constituent of a layer [1/m].
using BackscatteringByName = std::map<std::string, double>;

/// The backscattering of any layers; the constituents' phase functions are those of all of them.
class Backscattering {
 public:
  Backscattering(const LayerOptics& optics_of, const optics::PhaseTableCache& phases)
      : optics_of_(optics_of), phases_(phases) {}

  BackscatteringByName operator()(const scene::Layer& layer, double nm, const WaterOptics& water);

 private:
  double fraction(const ScatteringPart& part, double nm);

  const LayerOptics& optics_of_;
  const optics::PhaseTableCache& phases_;
  std::map<std::pair<Scatterer, double>, double> fraction_;
};

/// The constituents that any of the waters names.
std::vector<OpticalTable::Part> parts_of(const WatersOptics& waters,
                                         const std::vector<BackscatteringByName>& backscattering);

}  // namespace photic::medium
