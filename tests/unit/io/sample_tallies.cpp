#include "unit/io/sample_tallies.hpp"

#include <algorithm>
#include <cmath>

#include "unit/io/sample_result.hpp"

namespace photic::test {
namespace {

using tally::Coordinate;
using tally::Dimension;
using tally::TallyGrid;

std::vector<double> steps(double first, double step, std::size_t count) {
  std::vector<double> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(first + step * static_cast<double>(i));
  return out;
}

Dimension points(const std::string& name, const std::vector<double>& depths) {
  return {name,
          depths.size(),
          {{.name = name + "_depth",
            .units = "m",
            .long_name = "depth of the level, negative in the air",
            .values = depths,
            .attributes = {{"positive", "down"}}}}};
}

Dimension cells(const std::string& name, const std::string& units, const std::string& long_name,
                const std::vector<double>& edges) {
  return {name,
          edges.size() - 1,
          {{.name = name, .units = units, .long_name = long_name, .edges = edges}}};
}

Dimension names(const std::string& name, const std::string& long_name,
                const std::vector<std::string>& labels) {
  return {name, labels.size(), {{.name = name, .long_name = long_name, .labels = labels}}};
}

Dimension directions() {
  return {"direction",
          3,
          {{.name = "direction_zenith",
            .units = "degree",
            .long_name = "angle of the light's way from straight up",
            .values = {0, 30, 180}},
           {.name = "direction_azimuth",
            .units = "degree",
            .long_name = "azimuth of the light's way, from +x to +y",
            .values = {0, 90, 0}}}};
}

TallyGrid grid(scene::TallyKind kind, const std::string& name, const std::string& long_name,
               const std::vector<Dimension>& dimensions, const std::string& units = "1") {
  TallyGrid out;
  out.kind = kind;
  out.name = name;
  out.long_name = long_name;
  out.units = units;
  out.normalisation = "per unit irradiance across the beam";
  out.by_strength = tally::ByStrength{50, units == "1" ? "W m-2" : "W m-2 " + units};
  out.dimensions = dimensions;
  return out;
}

void add_irradiances(std::vector<TallyGrid>& out) {
  const std::vector<Dimension> levels{points("level", {-10, 0, 2, 5, 10, 20, 40, 60})};
  for (const auto& [name, long_name] :
       {std::pair{"irradiance_down", "downward plane irradiance"},
        {"irradiance_up", "upward plane irradiance"},
        {"scalar_irradiance_down", "scalar irradiance of light on its way down"},
        {"scalar_irradiance_up", "scalar irradiance of light on its way up"}})
    out.push_back(grid(scene::TallyKind::irradiance, name, long_name, levels));
}

void add_boundaries(std::vector<TallyGrid>& out) {
  const auto kind = scene::TallyKind::boundaries;
  out.push_back(grid(kind, "absorbed", "light absorbed in a layer by a constituent",
                     {names("layer", "name of the layer", {"upper", "lower", "haze"}),
                      names("constituent", "name of the constituent",
                            {"water", "chlorophyll", "cdom", "aerosol"})}));
  out.push_back(grid(kind, "escaped", "light that goes away for good",
                     {cells("escape_zenith", "degree", "angle of the light's way from straight up",
                            steps(0, 10, 10))}));
  for (const auto& [name, long_name] :
       {std::pair{"reflected_by_surface", "light that escaped and never was in the water"},
        {"left_water", "light that escaped and was in the water"},
        {"absorbed_by_bottom", "light absorbed by the sea bed"},
        {"absorbed_by_film", "light absorbed by the film of oil"},
        {"absorbed_by_ground", "light absorbed by the ground"},
        {"balance", "all light, by where it ends"}})
    out.push_back(grid(kind, name, long_name, {}));
}

void add_fluences(std::vector<TallyGrid>& out) {
  const auto kind = scene::TallyKind::fluence;
  out.push_back(
      grid(kind, "fluence_lamp", "fluence about the source",
           {cells("fluence_lamp_depth", "m", "depth of the cell", steps(0, 1, 21)),
            cells("fluence_lamp_radius", "m", "distance from the vertical", steps(0, 0.5, 21))},
           "m-2"));
  out.push_back(grid(kind, "fluence_across", "fluence per metre of y",
                     {cells("fluence_across_depth", "m", "depth of the cell", steps(0, 2, 11)),
                      cells("fluence_across_x", "m", "distance along x", steps(-5, 1, 11))},
                     "m-1"));
}

/// Light that falls off with each of its places, and an error that grows.
void fill(tally::TallyEstimates& out, double first) {
  const std::size_t count = out.grid.size();
  const auto fast = out.grid.dimensions.size() < 2 ? count : out.grid.dimensions.back().size;
  for (std::size_t i = 0; i < count; ++i) {
    const double away = static_cast<double>(i / fast) + 0.7 * static_cast<double>(i % fast);
    const bool dark = away > 24;
    const double relative = std::min(0.9, 0.004 * std::exp(0.7 * away));
    out.mean.push_back(dark ? 0 : first * std::exp(-0.5 * away));
    out.standard_error.push_back(relative * out.mean.back());
    const std::int32_t wide = relative > 0.1 ? tally::large_error : 0;
    out.flags.push_back(dark ? tally::no_score : wide);
  }
}

/// No number twice.
void fill(tally::TotalsState& state, std::size_t count) {
  std::uint64_t number = 1'000'000;
  const auto next = [&] { return std::sqrt(static_cast<double>(++number)); };
  for (std::size_t i = 0; i < count; ++i) {
    state.tallies.push_back(
        {{{next(), next()}, next(), next(), {next(), next(), next(), next()}}, next()});
    tally::Octaves octaves{};
    for (std::uint64_t& each : octaves) each = (std::uint64_t{1} << 60) + ++number;
    state.tally_octaves.push_back(octaves);
  }
}

}  // namespace

std::vector<TallyGrid> sample_tally_grids() {
  std::vector<TallyGrid> out;
  add_irradiances(out);
  add_boundaries(out);
  out.push_back(grid(scene::TallyKind::radiance, "radiance", "radiance of scattered light",
                     {directions(), points("radiance_level", {0, 5, 20})}, "sr-1"));
  add_fluences(out);
  return out;
}

void add_sample_tallies(tally::Result& result) {
  double first = 0.9;
  for (const TallyGrid& grid : sample_tally_grids())
    fill(result.tallies.emplace_back(tally::TallyEstimates{{}, grid, {}}), first *= 0.8);
  // Aerosols are in the haze alone, and it has nothing else.
  tally::TallyEstimates& absorbed = result.tallies[4];
  for (const std::size_t cell : {3, 7, 8, 9, 10}) {
    absorbed.mean[cell] = absorbed.standard_error[cell] = 0;
    absorbed.flags[cell] = tally::no_score;
  }
  result.source_strength = 50;
  result.source_strength_units = "W m-2";
  if (result.state) fill(*result.state, tally::cells_of(sample_tally_grids()));
}

tally::Result sample_tallies_alone() {
  tally::Result result;
  const tally::Result with_echoes = sample_result();
  result.title = "Sun over two layers of water";
  result.scene_toml = "title = \"Sun over two layers of water\"\n[source]\nkind = \"beam\"\n";
  result.version = "0.1.0";
  result.engine = "scalar";
  result.estimator = "forward";
  result.stopped_by = "photons";
  result.seed = 1;
  result.photons = 2'000'000;
  result.batches = 200;
  result.collisions = 9'000'000;
  result.wall_time_s = 2;
  result.threads = 2;
  result.ledger = with_echoes.ledger;
  result.state = tally::TotalsState(sample_shape_of_tallies_alone());
  result.state->photons = 2'000'000;
  result.state->batches = 200;
  result.state->tallies.clear();
  result.state->tally_octaves.clear();
  add_sample_tallies(result);
  return result;
}

tally::Shape sample_shape_of_tallies_alone() {
  tally::Shape shape;
  shape.grids = tally::echo_grids(7, {"elastic"}, {});
  shape.tallies = sample_tally_grids();
  return shape;
}

}  // namespace photic::test
