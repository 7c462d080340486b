// The medium: everything a walk needs to know of the water, as flat immutable tables.
//
// Lines are the wavelengths light can have: line 0 is the laser's, the others those that inelastic
// processes emit. Layers run from the surface (0) down. A value of line l in layer k stands at
// l * layers + k. Where there are columns side by side, the layers are those of one column after
// the other. Where the sea bed reflects light, it stands in the view's tables as one more layer
// behind the last, without thickness; below each column, if there are several.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/twin_table.hpp"
#include "medium/absorbers.hpp"
#include "medium/air_delay.hpp"
#include "medium/layering.hpp"
#include "medium/medium_view.hpp"
#include "medium/row.hpp"
#include "medium/shells.hpp"
#include "medium/sources.hpp"
#include "optics/phase_table.hpp"
#include "optics/sea_slopes.hpp"
#include "scene/choices.hpp"

namespace photic::medium {

using scene::Process;

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
      excess_bed,                ///< the beds' albedo less the medium's, [environment]
                                 ///< [line][column][angle]
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
  Row row;
  std::vector<Line> line;
  std::vector<double> top;  ///< depths of layers' upper edges, and the sea bed's
  std::vector<double> c, albedo, conversion, absorption;
  std::vector<double> delay;  ///< of the air upside down: its group index less 1; else none
  std::vector<std::int32_t> elastic_phase, conversion_phase;
  /// The albedo of sea beds that reflect light, at angles (surface/lambert.hpp),
  /// [line][column][angle];
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
  std::int32_t add_phase(const std::shared_ptr<const optics::PhaseTable>& table);
  /// The tables that were added, in the order of their numbers. The medium has copies of them, and
  /// does not keep them.
  [[nodiscard]] const std::vector<std::weak_ptr<const optics::PhaseTable>>& phases() const {
    return phases_;
  }

  [[nodiscard]] std::int32_t phase_count() const;

  /// Fills in what follows from the tables above; call once they are complete.
  void finish();

  [[nodiscard]] MediumView view() const;
  [[nodiscard]] std::int32_t layers() const { return static_cast<std::int32_t>(top.size()) - 1; }
  [[nodiscard]] std::size_t columns() const { return row.first_layer.size(); }
  /// The layer a depth lies in, in a column; a depth on an edge belongs to the layer below.
  [[nodiscard]] std::int32_t layer_at(double depth_m, std::size_t column = 0) const;
  /// The depth of a layer's lower edge.
  [[nodiscard]] double bottom_of(std::size_t layer) const;
  /// Has places in views be relative to a point.
  void set_origin(double x_m, double y_m);
  /// Optical depth of the laser's light by scattering, through all layers.
  [[nodiscard]] double scattering() const;
  /// Scattering in an environment, of a line and layer [1/m].
  [[nodiscard]] double scattering_in(std::size_t environment, std::size_t cell) const;
  /// The layering by the integrals of a coefficient from the surface, in a row for each line and
  /// column. `edges`: keeps what its view points to.
  [[nodiscard]] Layering layering_by(const std::vector<double>& coefficient,
                                     TwinTable& edges) const;
  /// A table [line][layer], so many numbers each, with those of beds that reflect; none: as in the
  /// last layer of the column.
  template <class Number>
  [[nodiscard]] std::vector<Number> with_bed(const std::vector<Number>& table,
                                             std::optional<Number> at_bed,
                                             std::size_t numbers = 1) const {
    if (bed_albedo.empty()) return table;
    const std::size_t of_line = static_cast<std::size_t>(layers()) * numbers;
    std::vector<Number> out;
    for (std::size_t first = 0; first < table.size(); first += of_line) {
      const auto from = table.begin() + static_cast<std::ptrdiff_t>(first);
      out.insert(out.end(), from, from + static_cast<std::ptrdiff_t>(of_line));
      for (std::size_t column = 0; column < columns(); ++column)
        for (std::size_t k = 0; k < numbers; ++k)
          out.push_back(at_bed ? *at_bed : table[first + (end_of(column) - 1) * numbers + k]);
    }
    return out;
  }
  /// A coefficient and its integrals to the places, [line][place]; on the bed it is `at_bed`.
  [[nodiscard]] TwinPairs with_integrals(const std::vector<double>& coefficient,
                                         double at_bed) const;

 private:
  /// The layer behind the last one of a column.
  [[nodiscard]] std::size_t end_of(std::size_t column) const;
  /// Integrals over depth from the surface, [line]: of each column, to its layers' tops, and to the
  /// bed.
  [[nodiscard]] std::vector<double> depth_integrals(const std::vector<double>& coefficient) const;
  /// The same to places, [line][place].
  [[nodiscard]] std::vector<double> to_places(const std::vector<double>& coefficient) const;
  /// The same to the beds, [line][column].
  [[nodiscard]] std::vector<double> to_beds(const std::vector<double>& coefficient) const;
  /// The layering by such integrals, or by depths; `padded`: for its view.
  [[nodiscard]] Layering layering_of(std::span<const double> edges, TwinTable& padded) const;
  [[nodiscard]] Layering layering_by_depth(TwinTable& edges) const;
  [[nodiscard]] WavesView waves_view() const;
  /// The environments' numbers, [row][environment].
  [[nodiscard]] std::vector<double> environment_rows() const;
  /// Groups the lines into bands.
  void finish_bands();
  void finish_row();

  /// The tables of the view, in both precisions.
  TwinTable bed_albedo_, top_, albedo_, conversion_, absorption_, bed_tau_, index_, inverse_index_,
      group_index_, environment_rows_, whitecap_reflectance_, film_index_, film_optical_thickness_,
      film_emission_;
  TwinPairs c_, delay_;
  IndexTableOwner convertible_, convertible_count_, line_of_spectral_bin_, elastic_phase_,
      conversion_phase_, part_phase_;
  TwinTable depth_edges_;
  Layering by_depth_;
  RowTables row_;
  std::int32_t bands_ = 0, film_band_ = -1;
  std::vector<std::weak_ptr<const optics::PhaseTable>> phases_;
  TwinTable phase_lines_, phase_quantiles_,
      phase_cores_;  ///< of all phase functions, one behind the other
};

}  // namespace photic::medium
