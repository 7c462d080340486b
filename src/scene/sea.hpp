// The sea: its surface, its water in layers or in columns of layers, its bed, and oil on it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "optics/sea_particles.hpp"
#include "scene/choices.hpp"
#include "scene/user_table.hpp"

namespace photic::scene {

/// Inherent optical properties at one wavelength: totals, water included.
struct IopEntry {
  double wavelength_nm{};
  double a_per_m{};
  double b_per_m{};
  double a_phytoplankton_per_m = 0.0;  ///< the part of a that excites chlorophyll fluorescence
  std::optional<double> bb_per_m =
      std::nullopt;           ///< backscattering; in all entries of a layer or in none
  double a_cdom_per_m = 0.0;  ///< the share of a that excites CDOM's
  friend bool operator==(const IopEntry&, const IopEntry&) = default;
};

/// A phase function by name and parameters; a mixture holds others.
struct PhaseFunction {
  std::optional<PhaseModel> model;  ///< given in every phase function that has been read
  double g{};                       ///< henyey-greenstein
  double refractive_index{};        ///< fournier-forand
  double slope{};                   ///< fournier-forand
  double depolarisation{};          ///< rayleigh
  optics::SeaParticles particles = optics::paper_phytoplankton;  ///< mie
  UserTable table;    ///< table: of angle_deg, phase_function_per_sr
  double fraction{};  ///< as a component of a mixture: its share of the scattering
  std::vector<PhaseFunction> components;  ///< mixture
  friend bool operator==(const PhaseFunction&, const PhaseFunction&) = default;
};

/// A homogeneous layer of water: constituents, or inherent optical properties given outright, or
/// one of Jerlov's types.
struct Layer {
  std::string name;
  std::optional<double> bottom_depth_m;  ///< absent in a bottomless last layer
  double chlorophyll_mg_m3 = 0.0;
  double chlorophyll_yield = 0.01;  ///< fluorescence photons per photon absorbed by phytoplankton
  double cdom_a440_per_m = 0.0;
  double cdom_slope_per_nm = 0.017;
  double minerals_g_m3 = 0.0;
  std::optional<double> temperature_c, salinity_psu;  ///< of the water's absorption and scattering;
                                                      ///< none: the sea's
  std::string jerlov;         ///< IB | II | III | 1C | 3C | 5C; empty in other layers
  std::vector<IopEntry> iop;  ///< empty in a layer of constituents; ascending in wavelength
  std::optional<PhaseFunction> phase_function;  ///< of an iop layer whose entries have no bb_per_m
  friend bool operator==(const Layer&, const Layer&) = default;
};

/// The sea surface: flat, or facets whose slopes have a density, and whitecaps between them.
struct Surface {
  SurfaceModel model = SurfaceModel::flat;
  double wind_speed_m_s = 0.0;      ///< cox-munk, paper
  double wind_direction_deg = 0.0;  ///< the wind's origin, from +x to +y
  bool slick = false;               ///< cox-munk
  bool gram_charlier = true;        ///< cox-munk
  double upwind_slope_variance = 0.0, crosswind_slope_variance = 0.0;  ///< gaussian
  std::optional<bool> whitecaps;            ///< none: with cox-munk alone, where there is no slick
  std::optional<double> whitecap_fraction;  ///< none: by the law
  WhitecapLaw whitecap_law = WhitecapLaw::monahan1980;
  WhitecapReflectance whitecap_reflectance = WhitecapReflectance::koepke1984;
  std::optional<FacetWeight> facets;  ///< none: reciprocal with a laser, else conserving

  /// Returns whether there are facets that are not level.
  [[nodiscard]] bool is_rough() const;
  /// Returns whether all facets are level across the wind, or along it.
  [[nodiscard]] bool is_one_dimensional() const;
  [[nodiscard]] bool has_whitecaps() const;
  friend bool operator==(const Surface&, const Surface&) = default;
};

/// The sea bed where the last layer ends.
struct Bottom {
  /// The albedo for light that comes in: one number, or a table of albedo and wavelength_nm,
  /// zenith_deg or both.
  std::variant<double, UserTable> albedo = 0.0;
  friend bool operator==(const Bottom&, const Bottom&) = default;
};

/// A film of oil on all of the sea.
struct Oil {
  std::optional<OilClass> of_class;  ///< this, or:
  UserTable table;                   ///< of wavelength_nm, n, a_per_m, emission_per_nm
  double thickness_um{};
  std::optional<double> yield;        ///< none: that of the class
  std::optional<double> lifetime_ns;  ///< the same
  double absorption_factor = 1.0;
  friend bool operator==(const Oil&, const Oil&) = default;
};

/// Water that ends at vertical faces, beside others in a row along x.
struct Column {
  std::string name;
  std::optional<double> x_min_m;  ///< of the first one alone; none: it has no end there
  std::optional<double> x_max_m;  ///< none: the last one has no end
  std::optional<Oil> oil;         ///< on its top alone
  std::optional<Bottom> bottom;   ///< where its last layer ends; none: the scene's
  std::vector<Layer> layer;       ///< from the surface down
  friend bool operator==(const Column&, const Column&) = default;
};

struct Sea {
  double salinity_psu = 35.0;
  double temperature_c = 20.0;
  std::optional<double>
      refractive_index;  ///< replaces Quan & Fry's for the geometry, at all wavelengths
  std::optional<double> group_index;  ///< replaces Quan & Fry's for the timing, at all wavelengths
  Surface surface;
  std::vector<Layer> layer;                ///< from the surface down; this, or:
  std::vector<Column> column;              ///< ascending in x
  std::optional<double> y_min_m, y_max_m;  ///< of all columns; none: they have no end there

  /// Returns whether columns end somewhere, so that beside them there is no sea.
  [[nodiscard]] bool ends() const;
  /// Returns whether water and surface are the same at every place of a level.
  [[nodiscard]] bool is_alike_everywhere() const { return column.size() < 2 && !ends(); }
  friend bool operator==(const Sea&, const Sea&) = default;
};

/// Layers from the surface down to the bed: those of the sea, or those of one of its columns.
struct Stack {
  const std::vector<Layer>& layer;
  std::string path;     ///< of the layers, as of --set: "sea.layer", "sea.column.1.layer"
  std::string section;  ///< "sea.layer", "sea.column.layer"
  std::string name;     ///< of the column; "" where there are none
};

/// All stacks of a sea, column after column: at least one.
[[nodiscard]] std::vector<Stack> stacks_of(const Sea& sea);

/// The bed of the sea, or of one of its columns.
struct PlacedBed {
  std::optional<Bottom> bottom;  ///< none: black
  std::string path;              ///< "bottom", "sea.column.1.bottom"
};

/// All beds, column after column: at least one. `of_all`: where a column has none of its own.
[[nodiscard]] std::vector<PlacedBed> beds_of(const Sea& sea, const std::optional<Bottom>& of_all);

/// A layer of a sea, with what messages and results call it.
struct PlacedLayer {
  const Layer& layer;
  std::string path;  ///< "sea.layer.0", "sea.column.1.layer.0"
  std::string name;  ///< "layer0", "plume/layer0"
  double top_m = 0;  ///< the depth of its upper edge

  [[nodiscard]] const Layer* operator->() const { return &layer; }
};

/// The layers of a sea, column after column: in this order they are numbered wherever light is.
[[nodiscard]] std::vector<PlacedLayer> layers_of(const Sea& sea);

/// The name of a layer in messages: if it is one of the sea's, that with its column.
[[nodiscard]] std::string name_in(const Sea& sea, const Layer& layer);

}  // namespace photic::scene
