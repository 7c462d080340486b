#include "estimator/tallies/fluence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace photic::estimator {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// The cell of a place between edges: -1 before the first, as many as there are beyond the last. On
/// an edge it is the one that light comes to.
std::ptrdiff_t cell_of(const std::vector<double>& edges, double place, bool ascends) {
  const auto beyond =
      ascends ? std::ranges::upper_bound(edges, place) : std::ranges::lower_bound(edges, place);
  return beyond - edges.begin() - 1;
}
/// The edge of a cell that light comes to next.
double edge_ahead(const std::vector<double>& edges, std::ptrdiff_t cell, bool ascends) {
  const std::ptrdiff_t edge = ascends ? cell + 1 : cell;
  if (edge < 0 || edge >= std::ssize(edges)) return never;
  return edges[static_cast<std::size_t>(edge)];
}

/// Light along x.
class AlongX {
 public:
  AlongX(const std::vector<double>& edges, double x, double per_length)
      : edges_(edges), x_(x), per_length_(per_length) {}

  [[nodiscard]] bool misses(double begin, double end) const {
    const double from = x_ + begin * per_length_, to = x_ + end * per_length_;
    return std::max(from, to) < edges_.front() || std::min(from, to) >= edges_.back();
  }
  [[nodiscard]] std::ptrdiff_t column_at(double length) const {
    return cell_of(edges_, x_ + length * per_length_, per_length_ >= 0);
  }
  /// The length at which it leaves a column, and what that adds to the column's number.
  [[nodiscard]] std::pair<double, std::ptrdiff_t> next(double, std::ptrdiff_t column) const {
    if (per_length_ == 0) return {never, 0};
    const bool ascends = per_length_ > 0;
    const double edge = edge_ahead(edges_, column, ascends);
    return {edge == never ? never : (edge - x_) / per_length_, ascends ? 1 : -1};
  }

 private:
  const std::vector<double>& edges_;
  double x_, per_length_;
};

/// Light across rings: it comes nearer to the vertical up to a length, and then goes away from it.
class AcrossRings {
 public:
  /// `squares`: of radii. From a place aside of the vertical, along a direction.
  AcrossRings(const std::vector<double>& squares, const Vec3<double>& from,
              const Vec3<double>& along)
      : squares_(squares), across_(along.x * along.x + along.y * along.y) {
    const double square = from.x * from.x + from.y * from.y;
    if (across_ == 0) {
      least_ = square;
      return;
    }
    nearest_ = -(from.x * along.x + from.y * along.y) / across_;
    least_ = std::max(0.0, square - nearest_ * nearest_ * across_);
  }

  [[nodiscard]] bool misses(double begin, double end) const {
    return square_at(std::clamp(nearest_, begin, end)) >= squares_.back();
  }
  [[nodiscard]] std::ptrdiff_t column_at(double length) const {
    return cell_of(squares_, square_at(length), length >= nearest_);
  }
  [[nodiscard]] std::pair<double, std::ptrdiff_t> next(double length, std::ptrdiff_t column) const {
    if (across_ == 0) return {never, 0};
    if (length < nearest_) {
      const double inner = edge_ahead(squares_, column, false);
      if (inner != never && inner > least_) return {nearest_ - half_chord(inner), -1};
    }
    const double outer = edge_ahead(squares_, column, true);
    return {outer == never ? never : nearest_ + half_chord(outer), 1};
  }

 private:
  [[nodiscard]] double square_at(double length) const {
    const double rest = length - nearest_;
    return least_ + rest * rest * across_;
  }
  [[nodiscard]] double half_chord(double square) const {
    return std::sqrt(std::max(0.0, square - least_) / across_);
  }

  const std::vector<double>& squares_;
  double across_;  ///< square of the direction's level part
  double nearest_ = 0, least_ = 0;
};

}  // namespace

Fluence::Fluence(Edges edges, const Vec3<double>& axis, ContinuousAbsorption absorption,
                 std::size_t first_cell)
    : edges_(std::move(edges)),
      columns_(edges_.aside),
      descends_(edges_.distance.front() > edges_.distance.back()),
      axis_(axis),
      absorption_(std::move(absorption)),
      first_cell_(first_cell) {
  if (descends_) std::ranges::reverse(edges_.distance);
  if (!edges_.rings) return;
  for (double& radius : columns_) radius *= radius;
}

std::size_t Fluence::cell(std::ptrdiff_t row, std::ptrdiff_t column) const {
  const std::ptrdiff_t rows = std::ssize(edges_.distance) - 1, columns = std::ssize(columns_) - 1;
  return first_cell_ +
         static_cast<std::size_t>((descends_ ? rows - 1 - row : row) * columns + column);
}

Fluence::Part Fluence::within(const Flight& flight) const {
  const double first = edges_.distance.front(), last = edges_.distance.back();
  if (flight.from == flight.to)
    return flight.from >= first && flight.from < last ? Part{0, flight.length} : Part{};
  const double near = std::max(flight.near(), first), far = std::min(flight.far(), last);
  if (near >= far) return {};
  const double begin = flight.leads_away() ? near : far, end = flight.leads_away() ? far : near;
  return {flight.length_to(begin), flight.length_to(end)};
}

template <class Aside>
void Fluence::add(const Flight& flight, const Part& part, Aside aside,
                  tally::TallyScores& scores) const {
  if (aside.misses(part.begin, part.end)) return;
  const bool level = flight.from == flight.to, away = level || flight.leads_away();
  const double slope = level ? 0 : (flight.to - flight.from) / flight.length;
  const double distance = flight.from + slope * part.begin;
  const auto length_to = [&](double edge) {
    return level || edge == never ? never : (edge - flight.from) / slope;
  };
  const std::ptrdiff_t step = away ? 1 : -1, columns = std::ssize(columns_) - 1;
  std::ptrdiff_t row = cell_of(edges_.distance, distance, away),
                 column = aside.column_at(part.begin);
  row = std::clamp<std::ptrdiff_t>(row, 0, std::ssize(edges_.distance) - 2);
  std::ptrdiff_t layer = part.begin > 0 ? absorption_.layer_ahead(distance, away)
                                        : static_cast<std::ptrdiff_t>(flight.layer);
  double weight = absorption_.weight_at(flight, distance);
  for (double length = part.begin; length < part.end;) {
    const double row_ends = length_to(edge_ahead(edges_.distance, row, away));
    const double layer_ends = length_to(absorption_.edge_ahead(layer, away));
    const auto [column_ends, onward] = aside.next(length, column);
    const double end = std::max(length, std::min({row_ends, layer_ends, column_ends, part.end}));
    const double depth = absorption_.per_m(static_cast<std::size_t>(layer)) * (end - length);
    const Decay decay = decay_over(depth);
    if (column >= 0 && column < columns)
      scores.add(cell(row, column), weight * (end - length) * decay.mean);
    if (end >= part.end) return;
    weight *= decay.there;
    length = end;
    if (column_ends <= end) column += onward;
    if (layer_ends <= end) layer += step;
    if (row_ends <= end) row += step;
    if (row < 0 || row + 1 >= std::ssize(edges_.distance)) return;
  }
}

void Fluence::add(const Flight& flight, tally::TallyScores& scores) const {
  const Part part = within(flight);
  if (part.begin >= part.end) return;
  const Vec3<double> from = flight.start - axis_;
  if (edges_.rings)
    add(flight, part, AcrossRings(columns_, from, flight.direction), scores);
  else
    add(flight, part, AlongX(columns_, from.x, flight.direction.x), scores);
}

}  // namespace photic::estimator
