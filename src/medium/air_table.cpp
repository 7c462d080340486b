#include "medium/air_table.hpp"

#include <fmt/format.h>

#include "core/constants.hpp"
#include "medium/air.hpp"

namespace photic::medium {
namespace {

constexpr double m_per_km = 1e3;

/// As those of water, but each degree, and more near 180 degrees: spheres have rainbows and
/// glories.
std::vector<double> air_angles_deg() {
  std::vector<double> angles;
  for (const double angle : table_angles_deg())
    if (angle <= 10) angles.push_back(angle);
  for (int angle = 11; angle < 180; ++angle) angles.push_back(angle);
  for (int fifth = 4; fifth >= 0; --fifth) angles.push_back(180 - fifth / 5.0);
  return angles;
}

/// Inside the core of a table, the mean over it.
double phase_value(const optics::PhaseShape& phase, double angle_deg) {
  const double x = x_of_angle(angle_deg), core = optics::PhaseView::x_core;
  return x < core ? phase.core_mass / (2 * pi * core) : phase.p(x);
}

/// Writes the layers of one wavelength to their places in the table.
class Filler {
 public:
  /// The parts of layers that are given outright are not known.
  Filler(const optics::PhaseTableCache& tables, OpticalTable& table, bool given_outright,
         bool gases)
      : tables_(tables), table_(table), layers_(table.layers()), given_outright_(given_outright) {
    const std::size_t count = layers_ * table.wavelengths();
    for (auto* values : {&table.a_per_m, &table.b_per_m, &table.backscatter_fraction,
                         &table.mean_cosine, &table.refractive_index})
      values->resize(count);
    table.phase_function_per_sr.resize(count * table.angles());
    const std::vector<double> none(count);
    if (given_outright) return;
    table.parts = {
        {"molecules", {}, none, {}}, {"ozone", none, {}, {}}, {"aerosols", none, none, {}}};
    if (gases) table.parts.push_back({"gases", none, {}, {}});
  }

  void add(const optics::AirOptics& air, std::size_t wavelength) {
    for (std::size_t k = 0; k < layers_; ++k)
      add(air.layers[k], k * table_.wavelengths() + wavelength);
    const double nm = table_.wavelength_nm[wavelength];
    if (given_outright_)
      return add_source("a and b of the air", air.profile_source, nm, table_.sources);
    add_source("profile of the air", air.profile_source, nm, table_.sources);
    add_source("b of molecules", air.molecules_source, nm, table_.sources);
    add_source("a of ozone", air.ozone_source, nm, table_.sources);
    if (table_.parts.size() > 3)
      add_source("a of other gases", air.gases_source, nm, table_.sources);
    add_source("a and b of aerosols", air.aerosols_source, nm, table_.sources);
  }

 private:
  void add(const optics::AirLayer& layer, std::size_t at) {
    table_.a_per_m[at] = layer.a_per_m();
    table_.b_per_m[at] = layer.b_per_m();
    table_.refractive_index[at] = layer.refractive_index;
    if (!given_outright_) {
      table_.parts[0].b_per_m[at] = layer.molecules_b_per_m;
      table_.parts[1].a_per_m[at] = layer.ozone_a_per_m;
      table_.parts[2].a_per_m[at] = layer.aerosols_a_per_m;
      table_.parts[2].b_per_m[at] = layer.aerosols_b_per_m;
      if (table_.parts.size() > 3) table_.parts[3].a_per_m[at] = layer.gases_a_per_m;
    }
    const auto phase = tables_(layer.phase);
    table_.backscatter_fraction[at] = phase->backscatter_fraction();
    table_.mean_cosine[at] = phase->mean_cosine();
    for (std::size_t i = 0; i < table_.angles(); ++i)
      table_.phase_function_per_sr[at * table_.angles() + i] =
          phase_value(layer.phase, table_.angle_deg[i]);
  }

  const optics::PhaseTableCache& tables_;
  OpticalTable& table_;
  std::size_t layers_;
  bool given_outright_;
};

/// An empty table of layers between altitudes.
OpticalTable empty_table(const std::vector<double>& edge_m,
                         const std::vector<double>& wavelength_nm) {
  OpticalTable table;
  table.of = Layered::air;
  table.wavelength_nm = wavelength_nm;
  table.angle_deg = air_angles_deg();
  table.first_m.assign(edge_m.begin(), edge_m.end() - 1);
  table.last_m.assign(edge_m.begin() + 1, edge_m.end());
  for (std::size_t i = 1; i < edge_m.size(); ++i)
    table.layer_name.push_back(
        fmt::format("{:g} to {:g} km", edge_m[i - 1] / m_per_km, edge_m[i] / m_per_km));
  return table;
}

}  // namespace

OpticalTable air_table(const optics::Library& library, const optics::AirProfile& profile,
                       const optics::AerosolChoice& aerosols,
                       const std::vector<double>& wavelength_nm) {
  std::vector<double> edge_m;
  for (const double km : profile.edges_km) edge_m.push_back(km * m_per_km);
  OpticalTable table = empty_table(edge_m, wavelength_nm);
  Filler filler(*library.phases, table, false, false);
  for (std::size_t w = 0; w < wavelength_nm.size(); ++w)
    filler.add(optics::air_at(library.air(), profile, aerosols, wavelength_nm[w]), w);
  return table;
}

OpticalTable air_table(const scene::Scene& scene, const optics::Library& library,
                       const std::vector<double>& wavelength_nm) {
  std::vector<Line> laser(1);
  laser.front().wavelength_nm = scene.source.wavelength_nm;
  const AirBuilder build(scene, library, laser);
  OpticalTable table = empty_table(build(scene).height_m, wavelength_nm);
  Filler filler(*library.phases, table, !scene.atmosphere->layer.empty(),
                !scene.atmosphere->gases.empty());
  for (std::size_t w = 0; w < wavelength_nm.size(); ++w)
    filler.add(build.at(scene, wavelength_nm[w], optics::Phases::wanted), w);
  return table;
}

}  // namespace photic::medium
