// The medium as a walk sees it.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/lanes.hpp"
#include "core/twin_table.hpp"
#include "medium/layering.hpp"
#include "medium/row.hpp"
#include "medium/shells.hpp"
#include "medium/surface_traits.hpp"
#include "medium/waves.hpp"
#include "optics/phase_table.hpp"

namespace photic::medium {

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
  std::int32_t places = 0;      ///< places of scattering: the layers, and beds that reflect
  std::int32_t bed_angles = 0;  ///< 0: the sea bed is black
  MediumKind kind = MediumKind::water;
  RowView row;
  ShortTable bed_albedo;  ///< [line][column][bed_angles], see surface/lambert.hpp
  ShortTable top;         ///< depth of a layer's upper edge, and that of the bed, which may be inf
  ShortTable albedo;      ///< b / c, [line][layer]
  // Coefficients and their integrals from the surface to a layer's top, [line][layer]:
  ShortPairs c;            ///< attenuation
  ShortTable bed_tau;      ///< the integral of c to the sea bed, [line][column]
  LayeringView by_depth;   ///< in a row for each column
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
    if (row.columns == 1) return select(place == Index<T>(layers), place - Index<T>(1), place);
    const Mask<T> on_bed = place >= Index<T>(layers);
    const Index<T> column = select(on_bed, place - Index<T>(layers), Index<T>(0));
    const Index<T> next = gather_index<T>(row.first_layer, column + Index<T>(1));
    return select(on_bed, next - Index<T>(1), place);
  }
  /// The bed below a layer.
  template <class T>
  Index<T> bed_below(const Index<T>& layer) const {
    return Index<T>(layers) + row.column<T>(layer);
  }
  /// The layer of a depth in the column of `from`; on an edge `from`, if that is one of the two,
  /// else the upper one.
  template <class T>
  Index<T> layer_at(const Index<T>& from, const T& depth) const {
    return row.layer_of(by_depth, Index<T>(0), from, depth);
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
    return I(environments.first_depth) + at(line, layer);
  }
  template <class I>
  I excess_emitted(const I& line, const I& layer) const {
    return I(environments.first_emitted) + at(line, layer);
  }
  template <class I>
  I excess_part(const I& line, const I& layer, std::int32_t part) const {
    return I(environments.first_part + part) + at(line, layer) * I(environments.parts);
  }
  /// The first number in a table of the beds' albedo, in the column of a place.
  template <class T>
  Index<T> bed_row(const Index<T>& line, const Index<T>& place) const {
    return row.layering_row<T>(line, place) * Index<T>(bed_angles);
  }
  /// The bed's albedo less the medium's, at an angle of it.
  template <class T>
  Index<T> excess_bed(const Index<T>& line, const Index<T>& place, const Index<T>& angle) const {
    return Index<T>(environments.first_bed) + bed_row<T>(line, place) + angle;
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

}  // namespace photic::medium
