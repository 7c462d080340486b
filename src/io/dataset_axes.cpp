#include "io/dataset_axes.hpp"

#include "io/dataset_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace photic::io {
namespace {

void add_axis(Dataset& dataset, const tally::Axis& axis) {
  dataset.add_dimension(axis.name, axis.size());
  if (!axis.labels.empty())
    return dataset.add_variable(axis.name + "_name", {axis.name}, axis.labels,
                                {{"long_name", axis.long_name}});
  if (axis.edges.empty()) {
    std::vector<std::int32_t> numbers(axis.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    return dataset.add_variable(axis.name, {axis.name}, numbers,
                                {{"long_name", axis.long_name}, {"units", axis.units}});
  }
  const auto pairs = bounds(axis.edges);
  Attributes attributes{{"long_name", axis.long_name + ", centre of the interval"},
                        {"units", axis.units},
                        {"bounds", axis.name + "_bounds"}};
  for (const auto& [key, value] : axis.attributes) attributes.emplace_back(key, value);
  dataset.add_variable(axis.name, {axis.name}, centres(pairs), attributes);
  const bool down =
      std::ranges::find(axis.attributes, std::pair<std::string, std::string>("positive", "down")) !=
      axis.attributes.end();
  dataset.add_variable(
      axis.name + "_bounds", {axis.name, "bnds"}, pairs,
      {{"long_name", down ? "top and bottom of the interval" : "ends of the interval"}});
}

}  // namespace

void add_axes(Dataset& dataset, const tally::Result& result) {
  dataset.add_dimension("telescope", result.telescopes());
  dataset.add_dimension("channel", result.channels());
  dataset.add_dimension("gate", result.gates());
  dataset.add_variable("telescope_name", {"telescope"}, result.telescope_name,
                       {{"long_name", "name of the telescope"}});
  dataset.add_variable("channel_name", {"channel"}, result.channel_name,
                       {{"long_name", "name of the channel"}});
  dataset.add_variable("channel_wavelength", {"channel"}, result.channel_wavelength_nm,
                       {{"standard_name", "radiation_wavelength"},
                        {"long_name", "mean wavelength of the light that the channel counts"},
                        {"units", "nm"},
                        {"_FillValue", nan},
                        {"coordinates", "channel_name"}});
  if (!result.film_attenuation_per_m.empty()) {
    dataset.add_variable(
        "film_attenuation", {"telescope", "channel"}, result.film_attenuation_per_m,
        {{"long_name",
          "absorption of the film of oil along the laser's axis down and the telescope's up, per "
          "thickness"},
         {"units", "m-1"},
         {"_FillValue", nan},
         {"coordinates", "telescope_name channel_name channel_wavelength"}});
    dataset.add_variable(
        "film_interface_ratio", {"telescope", "channel"}, result.film_interface_ratio,
        {{"long_name",
          "share of light that passes a film without absorption on these ways, over that which "
          "passes bare water"},
         {"units", "1"},
         {"_FillValue", nan},
         {"coordinates", "telescope_name channel_name channel_wavelength"}});
  }
}

void add_gates(Dataset& dataset, const tally::Result& result) {
  // Bounds carry no units: they have those of their variable (CF-1.10, section 7.1).
  const auto time = bounds(result.gate_time_edge_ns);
  dataset.add_variable("gate_time", {"gate"}, centres(time),
                       {{"long_name", "time from the laser to the telescope, centre of the gate"},
                        {"units", "ns"},
                        {"bounds", "gate_time_bounds"}});
  dataset.add_variable("gate_time_bounds", {"gate", "bnds"}, time,
                       {{"long_name", "start and end of the gate"}});

  const auto gate_depth = bounds(result.gate_depth_edge_m, result.telescopes() * result.channels());
  const std::string quantity =
      result.gate_depth_is_range ? "range along the axis of the telescope" : "depth";
  Attributes attributes = {
      {"long_name",
       quantity + " from which light scattered once arrives at the centre of the gate"},
      {"units", "m"},
      {"_FillValue", nan},
      {"coordinates", "telescope_name channel_name gate_time"},
      {"bounds", "gate_depth_bounds"}};
  if (!result.gate_depth_is_range)
    attributes.insert(attributes.end(), {{"standard_name", "depth"}, {"positive", "down"}});
  dataset.add_variable("gate_depth", {"telescope", "channel", "gate"}, centres(gate_depth),
                       attributes);
  dataset.add_variable("gate_depth_bounds", {"telescope", "channel", "gate", "bnds"}, gate_depth,
                       {{"long_name", quantity + " at start and end of the gate"}});
}

void add_axes_of_grids(Dataset& dataset, const tally::Result& result) {
  std::set<std::string> known;
  for (const tally::GridEstimates& grid : result.grids)
    for (const tally::Axis& axis : grid.grid.axes)
      if (known.insert(axis.name).second) add_axis(dataset, axis);
}

}  // namespace photic::io
