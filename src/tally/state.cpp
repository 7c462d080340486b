#include "tally/state.hpp"

#include <algorithm>
#include <bit>

#include "tally/shape.hpp"

namespace photic::tally {

void TailSums::add(double score, double batch_photons) {
  low.add(score, batch_photons);
  const double mean = score / batch_photons;
  if (photons == 0) origin = mean;
  photons += batch_photons;
  double weighted = batch_photons;
  for (double& sum : power) sum += weighted *= mean - origin;
}

TailSums::Moments TailSums::central(double all_photons) const {
  std::array<double, 4> about_origin{};
  double missed = all_photons - photons;
  for (std::size_t k = 0; k < about_origin.size(); ++k)
    about_origin[k] = (power[k] + (missed *= -origin)) / all_photons;
  const auto& [m1, m2, m3, m4] = about_origin;
  return {std::max(0.0, m2 - m1 * m1), m4 - 4 * m1 * m3 + 6 * m1 * m1 * m2 - 3 * m1 * m1 * m1 * m1};
}

TotalsState::TotalsState(const Shape& shape)
    : row(shape.rows()),
      echo(shape.cells()),
      cut_order(shape.cells()),
      largest(shape.cells()),
      octaves(shape.cells() * shape.techniques),
      environment(shape.cells() * shape.environments),
      tallies(cells_of(shape.tallies)),
      tally_octaves(cells_of(shape.tallies)) {
  for (const Grid& grid : shape.grids) grids.emplace_back(shape.cells() * grid.size());
}

std::size_t snapshots_at(std::uint64_t batches) {
  return static_cast<std::size_t>(std::bit_width(batches));
}

}  // namespace photic::tally
