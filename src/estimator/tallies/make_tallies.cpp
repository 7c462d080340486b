#include "estimator/tallies/make_tallies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/constants.hpp"
#include "estimator/origin.hpp"
#include "estimator/tallies/grids.hpp"
#include "estimator/tallies/radiance_ways.hpp"
#include "surface/flat.hpp"

namespace photic::estimator {
namespace {

constexpr double usual_slab = 0.05;           // attenuation lengths
constexpr double usual_slab_in_vacuum = 0.1;  // m; any is as good

/// Makes the tallies of one model.
class Maker {
 public:
  Maker(const Model& model, const geometry::Slabs& slabs)
      : model_(model), slabs_(slabs), grids_(model.shape.tallies) {
    out_.escapes_at_surface = !in_air() && !model.air;
    out_.escapes_at_end = in_air();
    out_.source_height_m = model.scene.source.position_m.z;
    out_.begins_in_water = geometry::stands_in_water(model.as_given.source.position_m);
    for (std::int32_t column = 0; column < slabs.row.columns; ++column)
      out_.inside.push_back({ContinuousAbsorption(slabs, column), {}, {}});
  }

  Tallies operator()() {
    for (const scene::Tally& tally : model_.scene.tally) add(tally);
    return std::move(out_);
  }

 private:
  void add(const scene::Tally& tally) {
    using enum scene::TallyKind;
    switch (tally.kind) {
      case irradiance:
        add_irradiance(tally);
        break;
      case boundaries:
        add_boundaries(tally);
        break;
      case fluence:
        add_fluence(tally);
        break;
      case radiance:
        out_.radiance.emplace(radiance_ways(tally, model_, slabs_, cell("radiance")), slabs_);
        break;
    }
  }

  [[nodiscard]] bool in_air() const { return model_.medium.kind == medium::MediumKind::air; }
  /// Returns whether the source's light goes up where it leads away from the surface.
  [[nodiscard]] bool rises_away(bool of_air) const { return of_air && !model_.is_air_alone(); }
  [[nodiscard]] std::size_t cell(const std::string& grid) const {
    return first_cell(grids_, grid).value();
  }

  /// Calls f(the tallies of a side, whether it is the air's) for the sides that this world follows
  /// flights on, and each of its columns.
  template <class F>
  void each_side(F f) {
    for (FlightTallies& column : out_.inside) f(column, in_air() || model_.is_air_alone());
    if (out_.escapes_at_surface && !model_.is_air_alone()) f(out_.outside, true);
  }

  void add_irradiance_in_shells(const scene::Tally& tally) {
    std::vector<ShellIrradiance::Level> levels;
    for (const TallyLevel& level : levels_of(tally))
      levels.push_back({levels.size(), level.distance,
                        slab_at(tally, model_.from_surface(level), out_.inside.front(), true)});
    out_.in_shells.emplace(
        slabs_.shells, levels, out_.inside.front().absorption,
        ShellIrradiance::Zones{-normalised(model_.scene.source.direction), tally.zone_deg},
        ShellIrradiance::Cells{cell("irradiance_down"), cell("irradiance_up"),
                               cell("scalar_irradiance_down"), cell("scalar_irradiance_up")});
  }
  void add_irradiance(const scene::Tally& tally) {
    if (slabs_.shells.exist()) return add_irradiance_in_shells(tally);
    const Irradiance::Cells down{cell("irradiance_down"), cell("scalar_irradiance_down")};
    const Irradiance::Cells up{cell("irradiance_up"), cell("scalar_irradiance_up")};
    const auto levels = levels_of(tally);
    each_side([&](FlightTallies& side, bool of_air) {
      const ContinuousAbsorption& absorption = side.absorption;
      std::vector<Irradiance::Level> here;
      for (std::size_t i = 0; i < levels.size(); ++i) {
        if (levels[i].in_air != of_air) continue;
        const double distance = model_.from_surface(levels[i]);
        here.push_back({i, off_source(distance), slab_at(tally, distance, side, of_air)});
      }
      if (here.empty()) return;
      const bool rises = rises_away(of_air);
      const double end =
          in_air() ? model_.medium.air_m : absorption.end_of(absorption.layers() - 1);
      side.irradiance.emplace(here, absorption, end, rises ? up : down, rises ? down : up);
    });
  }
  /// The distance of a level, a little farther if the source stands on it: whether light passes it
  /// that sets out there is not to depend on what floats round off.
  [[nodiscard]] double off_source(double distance) const {
    constexpr double farther = 1e-6;
    const double source = -model_.scene.source.position_m.z;
    return std::abs(distance - source) < farther / 2 * distance ? distance * (1 + farther)
                                                                : distance;
  }
  [[nodiscard]] double slab_at(const scene::Tally& tally, double distance,
                               const FlightTallies& side, bool of_air) const {
    if (tally.slab_m) return *tally.slab_m;
    if (of_air && !in_air() && !model_.is_air_alone()) return usual_slab_in_vacuum;
    const ContinuousAbsorption& absorption = side.absorption;
    return usual_slab / model_.medium.c[absorption.first_layer() + absorption.layer_of(distance)];
  }

  void add_boundaries(const scene::Tally& tally) {
    const auto& constituent = labels_of_absorbed("constituent");
    const std::size_t constituents = constituent.size();
    const medium::Absorbers& absorbers = model_.medium.absorbers;
    const std::size_t above =
        in_air() ? labels_of_absorbed("layer").size() - absorbers.layer.size() : 0;
    Boundaries::Cells cells;
    cells.absorbed = cell("absorbed") + above * constituents;
    cells.constituents = constituents;
    cells.escaped = cell("escaped");
    cells.reflected_by_surface = first_cell(grids_, "reflected_by_surface");
    cells.left_water = first_cell(grids_, "left_water");
    cells.film = first_cell(grids_, "absorbed_by_film");
    cells.bottom = first_cell(grids_, "absorbed_by_bottom");
    if (!cells.bottom) cells.bottom = first_cell(grids_, "absorbed_by_ground");
    const auto layers = static_cast<std::size_t>(model_.medium.layers());
    std::vector<double> share(layers * constituents);
    std::vector<double> lost;
    for (std::size_t k = 0; k < layers; ++k) {
      lost.push_back(lost_by_collision(k));
      if (k >= absorbers.layer.size()) continue;  // a vacuum above the air
      for (std::size_t i = 0; i < absorbers.constituent.size(); ++i) {
        const auto place = std::ranges::find(constituent, absorbers.constituent[i]);
        share[k * constituents + static_cast<std::size_t>(place - constituent.begin())] =
            absorbers.share_of(k, i);
      }
    }
    out_.boundaries.emplace(cells, std::move(share), std::move(lost),
                            escape_edges(tally, model_.medium));
  }
  /// The share of the weight that a collision in a layer takes: what is not absorbed along flights
  /// already. Where free paths are drawn more often than light collides, weights grow along them,
  /// and all is taken here.
  [[nodiscard]] double lost_by_collision(std::size_t k) const {
    const auto layer = static_cast<std::int32_t>(k);
    const double c = gather<double>(slabs_.c.first, slabs_.at(0, layer));
    const double walk_c = gather<double>(slabs_.walk_c.first, slabs_.at(0, layer));
    const double albedo = gather<double>(slabs_.albedo, slabs_.at(0, layer));
    return std::max(0.0, std::min(walk_c / c, 1.0) - albedo);
  }
  /// The names along a dimension of what is absorbed, of the water and the air.
  [[nodiscard]] const std::vector<std::string>& labels_of_absorbed(const std::string& name) const {
    const auto grid = std::ranges::find(grids_, "absorbed", &tally::TallyGrid::name);
    return std::ranges::find(grid->dimensions, name, &tally::Dimension::name)
        ->coordinates.front()
        .labels;
  }

  void add_fluence(const scene::Tally& tally) {
    const bool of_air = !tally.height_m.empty();
    each_side([&](FlightTallies& side, bool is_air) {
      if (is_air != of_air) return;
      const bool rings = !tally.radius_m.empty();
      Fluence::Edges edges{{}, rings ? tally.radius_m : tally.x_m, rings};
      for (const double distance : of_air ? tally.height_m : tally.depth_m)
        edges.distance.push_back(model_.from_surface({distance, of_air}));
      const scene::Source& source = model_.scene.source;
      const Vec3<double> zero = rings ? source.position_m : Vec3<double>{};
      side.fluence.emplace_back(std::move(edges), zero - origin_of(source, model_.medium.kind),
                                side.absorption, cell(fluence_name(tally)));
    });
  }

  const Model& model_;
  const geometry::Slabs& slabs_;
  const std::vector<tally::TallyGrid>& grids_;
  Tallies out_;
};

}  // namespace

std::shared_ptr<const Tallies> make_tallies(const Model& model, const geometry::Slabs& slabs) {
  if (model.scene.tally.empty()) return nullptr;
  return std::make_shared<const Tallies>(Maker(model, slabs)());
}

}  // namespace photic::estimator
