// The medium: everything a walk needs to know of the water, as flat immutable tables.
//
// Lines are the wavelengths light can have: line 0 is the laser's, the others those that inelastic
// processes emit. Layers run from the surface (0) down. A value of line l in layer k stands at
// l * layers + k. Where the sea bed reflects light, it stands in the view's tables as one more
// layer below the last, without thickness.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/lanes.hpp"
#include "core/twin_table.hpp"
#include "medium/absorbers.hpp"
#include "medium/air_delay.hpp"
#include "medium/layering.hpp"
#include "medium/shells.hpp"
#include "medium/sources.hpp"
#include "medium/surface_traits.hpp"
#include "medium/waves.hpp"
#include "optics/phase_table.hpp"
#include "optics/sea_slopes.hpp"
#include "scene/choices.hpp"

namespace photic::medium {

using scene::Process;

/// The environments as a walk sees them: other waters, whose echoes are those of the same paths
/// with other weights. The excess or lack of what light meets in them against the medium stands in
/// rows of one number for each.
///
/// Behind the environments stand tangents, one for each parameter p that derivatives are asked for:
/// for them a path's weight is 1 + p d ln(weight) / dp times what it is in the medium, and their
/// rows hold p d/dp of what those of environments hold the differences of.
struct EnvironmentsView {
  std::int32_t count = 0;  ///< of environments and tangents
  std::int32_t first_tangent = 0;
  std::int32_t stride = 0;       ///< from row to row: padded with zeros
  std::int32_t parts = 0;        ///< of the scattering that are more or less in some environment
  std::int32_t first_depth = 0;  ///< row of ...
  std::int32_t first_emitted = 0, first_part = 0, first_bed = 0, first_surface = 0;
  bool other_waves = false;    ///< some have other waves or whitecaps
  bool other_film = false;     ///< some have another film of oil
  bool other_outside = false;  ///< some have another column between the surface and instruments
  std::int32_t first_outside = 0, first_film = 0, first_emission = 0;
  Table number;           ///< [row][environment]
  IndexTable part_phase;  ///< table in the medium's phases, [line][layer][part]
};

/// Rows are a multiple of this long: a whole number of packs, however wide.
inline constexpr std::int32_t environment_padding = 16;

/// The lines of a process are a band, between which photons are shared out: a photon has a
/// spectral_bin, by which it is known beforehand in which line of each band its light is emitted,
/// if it is.
inline constexpr std::int32_t spectral_bins = 512;

template <class T>
Index<T> spectral_bin_of(const T& u) {
  return floor_index(u * T(spectral_bins));
}

/// An albedo of the sea bed that depends on the angle is known at the ends of so many steps.
inline constexpr std::int32_t bed_angle_steps = 256;

/// The even steps of sqrt(1 - cos) at whose ends the transmission and reflection of an
/// environment's film are known.
inline constexpr std::int32_t film_angle_steps = 128;

/// A depth [m] in a layer.
template <class T>
struct Level {
  Index<T> layer{};
  T depth{};
  T below_top{};  ///< depth below the layer's upper edge
};

/// A coefficient at a level [1/m], and its integral from the surface straight down to there.
template <class T>
struct Column {
  T coefficient{}, integral{};
};

/// The side of the sea surface that a medium fills.
enum class MediumKind : std::int8_t {
  water,
  air,  ///< upside down: its heights are depths (upside_down.hpp)
};

/// A Medium as a walk sees it. Depths are positive down [m]; coefficients in 1/m.
struct MediumView {
  std::int32_t layers = 0, lines = 0, bands = 0;
  std::int32_t places = 0;      ///< places of scattering: the layers, and a bed that reflects
  std::int32_t bed_angles = 0;  ///< 0: the sea bed is black
  MediumKind kind = MediumKind::water;
  ShortTable bed_albedo;  ///< [line][bed_angles], see surface/lambert.hpp
  ShortTable top;         ///< depth of a layer's upper edge; layers + 1 values, the last may be inf
  ShortTable albedo;      ///< b / c, [line][layer]
  // Coefficients and their integrals from the surface to a layer's top, [line][layer]:
  ShortPairs c;            ///< attenuation
  ShortTable bed_tau;      ///< the integral of c to the sea bed, [line]
  LayeringView by_depth;   ///< in one row, whose edges are `top`
  ShortTable conversion;   ///< share of a collision at line 0 that emits at this line, over the
                           ///< share of spectral_bins that may, [line][layer]
  ShortTable absorption;   ///< share of a collision that ends the photon, [line][layer]
  IndexTable convertible;  ///< the bands that a layer emits in, [layer][bands]
  IndexTable convertible_count;  ///< their number, [layer]
  IndexTable
      line_of_spectral_bin;     ///< the line of a band that a photon emits in, [band][spectral_bin]
  ShortTable index;             ///< refractive index against air, [line]
  ShortTable inverse_index;     ///< 1 / index, [line]
  ShortTable group_index;       ///< [line]
  ShortPairs delay;             ///< if upside down: the air's group index less 1, [line][layer]
  IndexTable elastic_phase;     ///< table in `phases`, [line][layer]
  IndexTable conversion_phase;  ///< table in `phases`, [line]; of line 0 unused
  optics::PhaseView phases;
  SurfaceTraits surface;
  WavesView waves;
  FilmView film;
  EnvironmentsView environments;
  ShellsView shells;  ///< of spherical air; else none

  /// True if the encounters of walks at the surface, or on their way there from the instrument,
  /// count in environments.
  [[nodiscard]] bool other_entry() const {
    return surface.differs_in_environments || environments.other_outside;
  }
  template <class I>
  I at(const I& line, const I& layer) const {
    return line * I(places) + layer;
  }

  /// The line that a photon of a spectral_bin emits in, if it is the i-th band of its layer that it
  /// does.
  template <class T>
  Index<T> emitted_line(const Index<T>& layer, const Index<T>& i,
                        const Index<T>& spectral_bin) const {
    const Index<T> band = gather_index<T>(convertible, layer * Index<T>(bands) + i);
    return gather_index<T>(line_of_spectral_bin, band * Index<T>(spectral_bins) + spectral_bin);
  }

  /// The layer that ways from a place go through: of the bed the last one.
  template <class T>
  Index<T> layer_of(const Index<T>& place) const {
    if (bed_angles == 0) return place;
    return select(place == Index<T>(layers), place - Index<T>(1), place);
  }
  template <class T>
  Level<T> level(const Index<T>& place, const T& depth) const {
    const Index<T> layer = layer_of<T>(place);
    return {layer, depth, depth - gather<T>(top, layer)};
  }

  /// Optical depth from the surface straight down to a level.
  template <class T>
  T optical_depth(const Index<T>& line, const Level<T>& at) const {
    return column(c, line, at).integral;
  }

  /// Optical depth of a straight way of the given length between two levels.
  template <class T>
  T slant_optical_depth(const Index<T>& line, const Level<T>& from, const Level<T>& to,
                        const T& length) const {
    return slant(c, line, from, to, length);
  }

  /// By how much the air makes such a way longer than in a vacuum, as group path [m]; where the
  /// medium is upside down.
  template <class T>
  T air_delay(const Index<T>& line, const Level<T>& from, const Level<T>& to,
              const T& length) const {
    return slant(delay, line, from, to, length);
  }
  /// The same from the surface straight down to a level, and of a metre in a layer.
  template <class T>
  T air_delay_down(const Index<T>& line, const Level<T>& at) const {
    return column(delay, line, at).integral;
  }
  template <class T>
  T air_delay_per_metre(const Index<T>& line, const Index<T>& layer) const {
    return gather<T>(delay.first, at(line, layer));
  }

  // Rows of the environments' numbers: attenuation less the medium's [1/m], its integral from the
  // surface to a layer's top, emitted light over the medium's less 1, and a part's scattering less
  // the medium's, over all scattering of the medium.
  template <class I>
  I excess_c(const I& line, const I& layer) const {
    return at(line, layer);
  }
  template <class I>
  I excess_depth_tau(const I& line, const I& layer) const {
    return I(environments.first_depth) + line * I(places + 1) + layer;
  }
  template <class I>
  I excess_emitted(const I& line, const I& layer) const {
    return I(environments.first_emitted) + at(line, layer);
  }
  template <class I>
  I excess_part(const I& line, const I& layer, std::int32_t part) const {
    return I(environments.first_part + part) + at(line, layer) * I(environments.parts);
  }
  /// The bed's albedo less the medium's, at an angle of it.
  template <class I>
  I excess_bed(const I& line, const I& angle) const {
    return I(environments.first_bed) + line * I(bed_angles) + angle;
  }
  /// The excess depth of the column between the surface and an instrument outside: 0 is the laser.
  [[nodiscard]] std::int32_t excess_outside(std::size_t instrument) const {
    return environments.first_outside + static_cast<std::int32_t>(instrument) * lines;
  }
  /// The loss of light that goes on at a film by a way (surface/film_crossing.hpp), as an optical
  /// depth, at the end of a step.
  template <class I>
  I film_row(const I& way, const I& line, const I& step) const {
    return I(environments.first_film) + (way * I(lines) + line) * I(film_angle_steps + 1) + step;
  }

 protected:
  template <class T>
  Column<T> column(const ShortPairs& coefficient, const Index<T>& line,
                   const Level<T>& level) const {
    const auto [here, above] = gather_pair<T>(coefficient, at(line, level.layer));
    return {here, above + here * level.below_top};
  }
  template <class T>
  T slant(const ShortPairs& coefficient, const Index<T>& line, const Level<T>& from,
          const Level<T>& to, const T& length) const {
    if (all(from.layer == to.layer))
      return gather<T>(coefficient.first, at(line, from.layer)) * length;
    return across(from, column(coefficient, line, from), to, column(coefficient, line, to), length);
  }
  /// Straight between two levels, also of one layer.
  template <class T>
  static T across(const Level<T>& from, const Column<T>& first, const Level<T>& to,
                  const Column<T>& last, const T& length) {
    using std::abs;
    const Mask<T> same = from.layer == to.layer;
    const T rise = select(same, T(1), abs(from.depth - to.depth));
    const T difference = first.integral - last.integral;
    const T downwards = select(from.depth > to.depth, difference, -difference);
    return select(same, first.coefficient * length, downwards * length / rise);
  }
};

/// One wavelength of light in the water.
struct Line {
  Process process = Process::elastic;
  double wavelength_nm = 0;
  double refractive_index = 1;
  double group_index = 1;
  double photons = 1;      ///< in it, relative to others of its process
  double lifetime_ns = 0;  ///< mean time from excitation to emission
  AirDelay air_delay = {};
  std::vector<double> counted_by = {};  ///< each channel of the scene: the share of its light
};

/// The tables of the environments.
struct EnvironmentTables {
  std::int32_t count = 0, first_tangent = 0;  ///< as in EnvironmentsView
  std::int32_t parts = 0;
  std::vector<double> excess_c,  ///< attenuation less the medium's, [environment][line][layer]
      excess_emitted,            ///< emitted light over the medium's, less 1, as above
      excess_bed,                ///< the bed's albedo less the medium's, [environment][line][angle]
      excess_part;  ///< a part's scattering less the medium's, over all scattering of the medium,
                    ///< [environment][line][layer][part]
  /// The films that differ from the medium's, or none if all are as that: the loss of light that
  /// goes on, as an optical depth, [environment][way][line][angle]; and two films and what their
  /// difference counts, [environment][row]: each has the optical thickness of each line, and its
  /// yield over the medium's.
  std::vector<double> film, film_emission;
  std::vector<double> surface;  ///< [environment][row], see SurfaceRow; none: all as the medium's
  /// The excess depth of the columns between the surface and instruments outside,
  /// [environment][instrument][line]; none: clear, or as the scene's in all.
  std::vector<double> excess_outside;
  std::vector<std::int32_t> part_phase;  ///< table in the medium's phases, [line][layer][part]
};

/// A rough sea surface.
struct Waves {
  optics::SlopeLaw slopes;            ///< flat: nothing else counts
  double upwind_x = 1, upwind_y = 0;  ///< towards where the wind comes from, a unit vector
  bool conserving = false;            ///< as in WavesView
  double whitecap_fraction = 0;
  std::vector<double> whitecap_reflectance;  ///< from above, [line]; empty if there are none
};

/// A film of oil.
struct Film {
  bool exists = false;
  std::vector<double> index, optical_thickness, emission;  ///< as in FilmView, emission over all
                                                           ///< spectral bins, [line]
};

/// The film of an environment, as light of the medium's lines meets it.
struct OtherFilm {
  bool exists = false;
  std::vector<double> index, optical_thickness;  ///< as in FilmView, [line]
  double yield = 0;                              ///< over the medium's
};
/// Two films, and the factor by which their difference counts.
struct FilmChange {
  OtherFilm from, to;
  double scale = 1;
};

/// Owns what a MediumView points to.
class Medium {
 public:
  std::vector<Line> line;
  std::vector<double> top, c, albedo, conversion, absorption;
  std::vector<double> delay;  ///< of the air upside down: its group index less 1; else none
  std::vector<std::int32_t> elastic_phase, conversion_phase;
  /// The albedo of a sea bed that reflects light, at angles (surface/lambert.hpp), [line][angle];
  /// empty if it is black.
  std::vector<double> bed_albedo;
  std::int32_t beam_lobe = 0;  ///< table of a narrow lobe, for walks that look for the laser's beam
  Waves waves;
  Film film;
  std::vector<FilmChange> film_changes;  ///< of each environment; none: all have this film
  MediumKind kind = MediumKind::water;
  double air_m = 0;  ///< the air's height, below a vacuum
  /// Optical depths of the air as high up as its light counts (upside_down()).
  double scattering_to_instruments = 0, depth_to_instruments = 0;
  EnvironmentTables environments;
  std::optional<Shells> shells;  ///< of spherical air
  std::vector<Source> sources;   ///< of all that it is made of
  Absorbers absorbers;           ///< of the source's light

  /// Adds a phase function, or finds the equal one that is there already; returns its number.
  std::int32_t add_phase(const optics::PhaseTable& table);

  [[nodiscard]] std::int32_t phase_count() const;

  /// Fills in what follows from the tables above; call once they are complete.
  void finish();

  [[nodiscard]] MediumView view() const;
  [[nodiscard]] std::int32_t layers() const { return static_cast<std::int32_t>(top.size()) - 1; }
  /// The layer a depth lies in; a depth on an edge belongs to the layer below.
  [[nodiscard]] std::int32_t layer_at(double depth_m) const;
  /// Optical depth of the laser's light by scattering, through all layers.
  [[nodiscard]] double scattering() const;
  /// Scattering in an environment, of a line and layer [1/m].
  [[nodiscard]] double scattering_in(std::size_t environment, std::size_t cell) const;
  /// Integrals over depth from the surface to the layers' edges, [line][layers + 1], for as many
  /// lines as there are coefficients of.
  [[nodiscard]] std::vector<double> depth_integrals(const std::vector<double>& coefficient) const;
  /// A table [line][layer], so many numbers each, with those of a bed that reflects; none: as in
  /// the last layer.
  template <class Number>
  [[nodiscard]] std::vector<Number> with_bed(const std::vector<Number>& table,
                                             std::optional<Number> at_bed,
                                             std::size_t numbers = 1) const {
    if (bed_albedo.empty()) return table;
    const std::size_t row = static_cast<std::size_t>(layers()) * numbers;
    std::vector<Number> out;
    for (auto from = table.begin(); from != table.end(); from += static_cast<std::ptrdiff_t>(row)) {
      out.insert(out.end(), from, from + static_cast<std::ptrdiff_t>(row));
      for (std::size_t k = 0; k < numbers; ++k)
        out.push_back(at_bed ? *at_bed : *(from + static_cast<std::ptrdiff_t>(row - numbers + k)));
    }
    return out;
  }
  /// A coefficient and its integrals to the layers' tops, [line][place]; on the bed it is `at_bed`.
  [[nodiscard]] TwinPairs with_integrals(const std::vector<double>& coefficient,
                                         double at_bed) const;

 private:
  [[nodiscard]] WavesView waves_view() const;
  /// The environments' numbers, [row][environment].
  [[nodiscard]] std::vector<double> environment_rows() const;
  /// Groups the lines into bands.
  void finish_bands();

  /// The tables of the view, in both precisions.
  TwinTable bed_albedo_, top_, albedo_, conversion_, absorption_, bed_tau_, index_, inverse_index_,
      group_index_, environment_rows_, whitecap_reflectance_, film_index_, film_optical_thickness_,
      film_emission_;
  TwinPairs c_, delay_;
  IndexTableOwner convertible_, convertible_count_, line_of_spectral_bin_, elastic_phase_,
      conversion_phase_, part_phase_;
  Layering by_depth_;
  std::int32_t bands_ = 0, film_band_ = -1;
  TwinTable phase_lines_, phase_quantiles_,
      phase_cores_;  ///< of all phase functions, one behind the other
};

}  // namespace photic::medium
