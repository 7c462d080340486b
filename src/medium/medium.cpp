#include "medium/medium.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <ranges>
#include <span>

#include "core/error.hpp"

namespace photic::medium {
namespace {

using optics::PhaseView;
/// So many numbers as there are in a row for so many environments.
std::int32_t padded(std::int32_t environments) {
  return (environments + environment_padding - 1) / environment_padding * environment_padding;
}

/// Shares out the spectral_bins among the lines of a band: half of them by their photons, half of
/// them evenly, for a channel's filter may let through one line alone.
std::vector<std::int32_t> spectral_bins_of(std::span<const Line> band) {
  expect(2 * band.size() <= spectral_bins, "a band has no more lines than half the spectral_bins");
  double all = 0;
  for (const Line& line : band) all += line.photons;
  std::vector<std::int32_t> count;
  double due = 0;
  std::int32_t given = 0;
  for (const Line& line : band) {
    due += spectral_bins * 0.5 * (line.photons / all + 1 / static_cast<double>(band.size()));
    const auto upto = static_cast<std::int32_t>(std::lround(due));
    count.push_back(upto - given);
    given = upto;
  }
  return count;
}

constexpr std::size_t phase_lines = std::size_t{PhaseView::lines} * PhaseView::line_fields,
                      phase_quantiles =
                          std::size_t{PhaseView::quantiles} * PhaseView::quantile_fields;

}  // namespace

std::int32_t Medium::add_phase(const std::shared_ptr<const optics::PhaseTable>& table) {
  const auto is_table = [&](const std::weak_ptr<const optics::PhaseTable>& known) {
    return !known.owner_before(table) && !table.owner_before(known);
  };
  const auto same = std::ranges::find_if(phases_, is_table);
  if (same != phases_.end()) return static_cast<std::int32_t>(same - phases_.begin());
  const PhaseView v = table->view();
  const std::span lines{v.line.exact, phase_lines};
  const auto there = phase_lines_.numbers();
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    if (std::ranges::equal(lines, there.subspan(i * phase_lines, phase_lines)))
      return static_cast<std::int32_t>(i);
  }
  phases_.emplace_back(table);
  phase_lines_.append(lines);
  phase_quantiles_.append(std::span{v.quantile.exact, phase_quantiles});
  phase_cores_.append(std::span{v.core_per_u.exact, 1});
  return phase_count() - 1;
}

std::int32_t Medium::phase_count() const { return static_cast<std::int32_t>(phases_.size()); }

std::size_t Medium::end_of(std::size_t column) const {
  return static_cast<std::size_t>(column + 1 < columns() ? row.first_layer[column + 1] : layers());
}

double Medium::bottom_of(std::size_t layer) const {
  const auto next = static_cast<std::int32_t>(layer) + 1;
  const bool last = std::ranges::binary_search(row.first_layer, next);
  return last ? top.back() : top[layer + 1];
}

std::vector<double> Medium::depth_integrals(const std::vector<double>& coefficient) const {
  std::vector<double> out;
  const auto n_layers = static_cast<std::size_t>(layers());
  for (std::size_t first = 0; first < coefficient.size(); first += n_layers) {
    for (std::size_t column = 0, k = 0; column < columns(); ++column) {
      double sum = 0;
      out.push_back(sum);
      for (; k < end_of(column); ++k) {
        const double per_metre = coefficient[first + k];
        if (per_metre != 0) sum += per_metre * (bottom_of(k) - top[k]);  // the last may be endless
        out.push_back(sum);
      }
    }
  }
  return out;
}

std::vector<double> Medium::to_beds(const std::vector<double>& coefficient) const {
  std::vector<double> out;
  const auto integrals = depth_integrals(coefficient);
  for (std::size_t at = 0; at < integrals.size();) {
    for (std::size_t column = 0, k = 0; column < columns(); ++column) {
      at += end_of(column) - k + 1;
      k = end_of(column);
      out.push_back(integrals[at - 1]);
    }
  }
  return out;
}

std::vector<double> Medium::to_places(const std::vector<double>& coefficient) const {
  const auto integrals = depth_integrals(coefficient);
  const auto beds = to_beds(coefficient);
  std::vector<double> out;
  for (std::size_t at = 0, line = 0; at < integrals.size(); ++line) {
    for (std::size_t column = 0, k = 0; column < columns(); ++column, ++at)
      for (; k < end_of(column); ++k) out.push_back(integrals[at++]);
    if (bed_albedo.empty()) continue;
    for (std::size_t column = 0; column < columns(); ++column)
      out.push_back(beds[line * columns() + column]);
  }
  return out;
}

Layering Medium::layering_of(std::span<const double> edges, TwinTable& padded) const {
  std::size_t most = 0;
  for (std::size_t column = 0; column < columns(); ++column)
    most = std::max(most, end_of(column) - static_cast<std::size_t>(row.first_layer[column]));
  std::vector<double> out, ends;
  for (std::size_t at = 0; at < edges.size();) {
    for (std::size_t column = 0, k = 0; column < columns(); ++column) {
      const std::size_t row_end = out.size() + most + 1;
      for (; k < end_of(column); ++k) out.push_back(edges[at++]);
      ends.push_back(edges[at++]);
      out.resize(row_end, Row::endless);
    }
  }
  padded = TwinTable(out);
  return {out, static_cast<std::int32_t>(most), ends};
}

Layering Medium::layering_by(const std::vector<double>& coefficient, TwinTable& edges) const {
  return layering_of(depth_integrals(coefficient), edges);
}

Layering Medium::layering_by_depth(TwinTable& edges) const {
  std::vector<double> depths;
  for (std::size_t column = 0, k = 0; column < columns(); ++column) {
    for (; k < end_of(column); ++k) depths.push_back(top[k]);
    depths.push_back(top.back());
  }
  return layering_of(depths, edges);
}

TwinPairs Medium::with_integrals(const std::vector<double>& coefficient, double at_bed) const {
  return {with_bed<double>(coefficient, at_bed), to_places(coefficient)};
}

std::vector<double> Medium::environment_rows() const {
  const auto count = static_cast<std::size_t>(environments.count);
  const auto stride = static_cast<std::size_t>(padded(environments.count));
  std::vector<double> out;
  /// Adds the rows of a table [environment][row].
  const auto add_rows = [&](const std::vector<double>& table) {
    const std::size_t rows = count > 0 ? table.size() / count : 0;
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t e = 0; e < stride; ++e)
        out.push_back(e < count ? table[e * rows + row] : 0.0);
    }
  };
  const auto add = [&](const std::vector<double>& table, std::size_t numbers = 1) {
    add_rows(with_bed<double>(table, 0.0, numbers));
  };
  add(environments.excess_c);
  add_rows(to_places(environments.excess_c));
  add(environments.excess_emitted);
  add(environments.excess_part, static_cast<std::size_t>(environments.parts));
  add_rows(environments.excess_bed);
  add_rows(environments.surface);
  add_rows(environments.excess_outside);
  add_rows(environments.film);
  add_rows(environments.film_emission);
  return out;
}

double Medium::scattering() const {
  double sum = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(layers()); ++k)
    if (albedo[k] > 0) sum += albedo[k] * c[k] * (bottom_of(k) - top[k]);
  return sum;
}

double Medium::scattering_in(std::size_t environment, std::size_t cell) const {
  const auto parts = static_cast<std::size_t>(environments.parts);
  const auto first = environments.excess_part.begin() +
                     static_cast<std::ptrdiff_t>((environment * c.size() + cell) * parts);
  return albedo[cell] * c[cell] * std::accumulate(first, first + environments.parts, 1.0);
}

void Medium::finish() {
  const auto n_layers = static_cast<std::size_t>(layers());
  const std::size_t n_lines = line.size();
  const std::size_t cells = n_layers * n_lines;
  expect(n_layers >= 1 && n_lines >= 1 && top.front() == 0.0,
         "a medium has layers from the surface and lines");
  expect(c.size() == cells && albedo.size() == cells && conversion.size() == cells &&
             absorption.size() == cells && elastic_phase.size() == cells &&
             conversion_phase.size() == n_lines,
         "every table of the medium is complete");
  const auto of_lines = [&](auto value) {
    std::vector<double> out;
    std::ranges::transform(line, std::back_inserter(out), value);
    return TwinTable(out);
  };
  index_ = of_lines([](const Line& l) { return l.refractive_index; });
  inverse_index_ = of_lines([](const Line& l) { return 1 / l.refractive_index; });
  group_index_ = of_lines([](const Line& l) { return l.group_index; });
  top_ = TwinTable(top);
  bed_albedo_ = TwinTable(bed_albedo);
  whitecap_reflectance_ = TwinTable(waves.whitecap_reflectance);
  film_index_ = TwinTable(film.index);
  film_optical_thickness_ = TwinTable(film.optical_thickness);
  c_ = with_integrals(c, 1);
  if (kind == MediumKind::air) delay_ = with_integrals(delay, 0);
  albedo_ = TwinTable(with_bed<double>(albedo, 1.0));
  absorption_ = TwinTable(with_bed<double>(absorption, 0.0));
  bed_tau_ = TwinTable(to_beds(c));
  by_depth_ = layering_by_depth(depth_edges_);
  finish_row();
  environment_rows_ = TwinTable(environment_rows());
  part_phase_ = IndexTableOwner(with_bed<std::int32_t>(
      environments.part_phase, 0, static_cast<std::size_t>(environments.parts)));
  elastic_phase_ = IndexTableOwner(with_bed<std::int32_t>(elastic_phase, {}));
  conversion_phase_ = IndexTableOwner(conversion_phase);
  finish_bands();
}

void Medium::finish_row() { row_ = RowTables(row, layers(), !bed_albedo.empty()); }

void Medium::set_origin(double x_m, double y_m) {
  row.origin_x_m = x_m;
  row.origin_y_m = y_m;
  finish_row();
}

void Medium::finish_bands() {
  const auto n_layers = static_cast<std::size_t>(layers());
  std::vector<std::vector<std::int32_t>> convertible(n_layers);
  std::vector<std::int32_t> line_of_spectral_bin;
  std::vector<double> emitted = conversion;
  std::vector<double> film_emission = film.emission;
  bands_ = 0;
  for (std::size_t first = 1, end = 1; first < line.size(); first = end, ++bands_) {
    while (end < line.size() && line[end].process == line[first].process) ++end;
    const auto count = spectral_bins_of(std::span(line).subspan(first, end - first));
    for (std::size_t l = first; l < end; ++l) {
      line_of_spectral_bin.insert(line_of_spectral_bin.end(),
                                  static_cast<std::size_t>(count[l - first]),
                                  static_cast<std::int32_t>(l));
      for (std::size_t k = 0; k < n_layers; ++k)
        emitted[l * n_layers + k] *= static_cast<double>(spectral_bins) / count[l - first];
      if (film.exists) film_emission[l] *= static_cast<double>(spectral_bins) / count[l - first];
    }
    if (line[first].process == Process::oil) film_band_ = bands_;
    for (std::size_t k = 0; k < n_layers; ++k) {
      const auto emits = [&](std::size_t l) { return conversion[l * n_layers + k] > 0; };
      if (std::ranges::any_of(std::views::iota(first, end), emits))
        convertible[k].push_back(bands_);
    }
  }
  std::vector<std::int32_t> padded_lists, list_lengths;
  if (!bed_albedo.empty()) convertible.resize(n_layers + columns());  // none there
  for (auto& list : convertible) {
    list_lengths.push_back(static_cast<std::int32_t>(list.size()));
    list.resize(static_cast<std::size_t>(bands_));
    padded_lists.insert(padded_lists.end(), list.begin(), list.end());
  }
  conversion_ = TwinTable(with_bed<double>(emitted, 0.0));
  film_emission_ = TwinTable(film_emission);
  line_of_spectral_bin_ = IndexTableOwner(line_of_spectral_bin);
  convertible_ = IndexTableOwner(padded_lists);
  convertible_count_ = IndexTableOwner(list_lengths);
}

WavesView Medium::waves_view() const {
  const optics::SlopeLaw& s = waves.slopes;
  WavesView v;
  v.one_dimensional = s.is_one_dimensional();
  v.conserving = waves.conserving;
  v.upwind_x = waves.upwind_x;
  v.upwind_y = waves.upwind_y;
  v.upwind_deviation = std::sqrt(s.upwind_variance);
  v.crosswind_deviation = std::sqrt(s.crosswind_variance);
  v.series = s.series;
  v.per_norm = 1 / s.norm;
  v.whitecap_fraction = waves.whitecap_fraction;
  v.whitecap_reflectance = whitecap_reflectance_.view();
  return v;
}

MediumView Medium::view() const {
  MediumView v;
  v.layers = layers();
  v.lines = static_cast<std::int32_t>(line.size());
  v.bands = bands_;
  v.row = row_.view();
  v.places = v.layers + (bed_albedo.empty() ? 0 : v.row.columns);
  v.bed_angles = bed_albedo.empty()
                     ? 0
                     : static_cast<std::int32_t>(bed_albedo.size() / (line.size() * columns()));
  v.bed_albedo = bed_albedo_.view();
  v.kind = kind;
  v.top = top_.view();
  v.c = c_.view();
  v.albedo = albedo_.view();
  v.bed_tau = bed_tau_.view();
  v.by_depth = by_depth_.view(depth_edges_.view());
  v.conversion = conversion_.view();
  v.absorption = absorption_.view();
  v.convertible = convertible_.view();
  v.convertible_count = convertible_count_.view();
  v.line_of_spectral_bin = line_of_spectral_bin_.view();
  v.index = index_.view();
  v.inverse_index = inverse_index_.view();
  v.group_index = group_index_.view();
  v.delay = delay_.view();
  v.elastic_phase = elastic_phase_.view();
  v.conversion_phase = conversion_phase_.view();
  v.waves = waves_view();
  v.film = {film_band_, film_index_.view(), film_optical_thickness_.view(), film_emission_.view()};
  EnvironmentsView& e = v.environments;
  e.count = environments.count;
  e.first_tangent = environments.first_tangent;
  e.stride = padded(e.count);
  e.parts = environments.parts;
  const std::int32_t cells = v.lines * v.places;
  e.first_depth = cells;
  e.first_emitted = e.first_depth + cells;
  e.first_part = e.first_emitted + cells;
  e.first_bed = e.first_part + cells * e.parts;
  e.first_surface = e.first_bed + static_cast<std::int32_t>(bed_albedo.size());
  e.other_film = !environments.film.empty();
  e.other_waves = !environments.surface.empty();
  const bool rough = !waves.slopes.is_flat();
  v.surface = {!rough,
               rough && !waves.slopes.is_one_dimensional(),
               !rough || (waves.slopes.is_isotropic() && !e.other_waves),
               film_band_ >= 0,
               film.exists,
               e.other_waves || (rough && e.other_film),
               std::ranges::any_of(line, [](const Line& l) { return l.refractive_index < 1; })};
  e.other_outside = !environments.excess_outside.empty();
  e.first_outside = e.first_surface + (e.other_waves ? surface_rows : 0);
  e.first_film = e.first_outside;
  if (e.other_outside)
    e.first_film += static_cast<std::int32_t>(environments.excess_outside.size()) / e.count;
  e.first_emission = e.first_film + ways_at_film * v.lines * (film_angle_steps + 1);
  e.number = environment_rows_.table();
  e.part_phase = part_phase_.view();
  v.phases.line = phase_lines_.table();
  v.phases.quantile = phase_quantiles_.table();
  v.phases.core_per_u = phase_cores_.view();
  if (shells) v.shells = shells->view();
  return v;
}

std::int32_t Medium::layer_at(double depth_m, std::size_t column) const {
  const std::span tops(top.data() + row.first_layer[column], top.data() + end_of(column));
  const auto below = std::ranges::upper_bound(tops, depth_m) - tops.begin();
  return row.first_layer[column] + std::max(0, static_cast<std::int32_t>(below) - 1);
}

}  // namespace photic::medium
