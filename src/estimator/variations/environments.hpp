// A path's weight in other waters than those it was drawn in: the ratio of the path's density there
// to that here (docs/theory.md, "Environments").
//
// Along a path two numbers are kept for each environment: the product of the ratios of its
// collisions, and the excess optical depth. A flight or a collision adds a sum of rows of the
// medium's tables, with factors that are the same for all environments. The factors are worked out
// for the photons of all lanes at once; the sums then, photon by photon, for so many environments
// at once as there are lanes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "core/elementary.hpp"
#include "estimator/variations/other_films.hpp"
#include "estimator/variations/other_surfaces.hpp"
#include "estimator/variations/terms.hpp"
#include "geometry/region.hpp"
#include "geometry/segment.hpp"
#include "medium/medium.hpp"
#include "optics/phase_table.hpp"
#include "surface/flat.hpp"
#include "surface/lambert.hpp"

namespace photic::estimator {

/// Calls act(first) for groups of environments, so many at a time as there are lanes.
template <class T, class Act>
void each_group(const medium::EnvironmentsView& environments, Act act) {
  for (std::int32_t e = 0; e < environments.count; e += static_cast<std::int32_t>(lanes_of<T>))
    act(e);
}

/// The environments of a group that are tangents.
template <class T>
Mask<T> tangents(const medium::EnvironmentsView& environments, std::int32_t first) {
  return Index<T>(first) + lane_numbers<T>() >= Index<T>(environments.first_tangent);
}

/// A product with another ratio, of which `sum` is what it is more than 1, for environments from
/// `first` on.
template <class T>
T times(const medium::EnvironmentsView& environments, const T& product, const T& sum,
        std::int32_t first) {
  return product + select(tangents<T>(environments, first), sum, product * sum);
}
/// With another collision in a lane.
template <class T>
T collided(const medium::EnvironmentsView& environments, const T& product,
           const Terms<T>& collision, std::size_t lane, std::int32_t first) {
  return times(environments, product, collision.sum(environments, lane, first), first);
}

/// Product and depth of two walks that are one path, for environments from `first` on.
template <class T>
std::array<T, 2> joined(const medium::EnvironmentsView& environments, std::int32_t first,
                        const std::array<T, 2>& a, const std::array<T, 2>& b) {
  return {select(tangents<T>(environments, first), a[0] + b[0], a[0] * b[0]), a[1] + b[1]};
}

/// The numbers of one path, [environment].
template <class T>
struct PathRatio {
  Element<T>* product = nullptr;     ///< of the ratios of its collisions; of tangents their sum
  Element<T>* excess_tau = nullptr;  ///< optical depth of its flights less that in the medium

  void begin(const medium::EnvironmentsView& environments) const {
    each_group<T>(environments, [&](std::int32_t e) {
      store(select(tangents<T>(environments, e), T(0), T(1)), product + e);
      store(T(0), excess_tau + e);
    });
  }
  /// The path has gone ways.
  void pass(const medium::EnvironmentsView& environments, const Terms<T>& ways,
            std::size_t lane) const {
    each_group<T>(environments, [&](std::int32_t e) {
      store(load<T>(excess_tau + e) + ways.sum(environments, lane, e), excess_tau + e);
    });
  }
  /// The path has had a collision.
  void collide(const medium::EnvironmentsView& environments, const Terms<T>& collision,
               std::size_t lane) const {
    each_group<T>(environments, [&](std::int32_t e) {
      const T old = load<T>(product + e);
      store(collided(environments, old, collision, lane, e), product + e);
    });
  }
  /// Another part of the path belongs to it.
  void join(const medium::EnvironmentsView& environments, const PathRatio& part) const {
    each_group<T>(environments, [&](std::int32_t e) {
      const std::array<T, 2> own{load<T>(product + e), load<T>(excess_tau + e)};
      const auto both =
          joined(environments, e, own, {load<T>(part.product + e), load<T>(part.excess_tau + e)});
      store(both[0], product + e);
      store(both[1], excess_tau + e);
    });
  }
  /// The path has met the surface, or a film has emitted its light.
  template <class Met>
  void meet(const medium::MediumView& sea, const Met& met, std::size_t lane) const {
    each_group<T>(sea.environments, [&](std::int32_t e) {
      const T old = load<T>(product + e);
      store(times(sea.environments, old, met.sum(sea, lane, e), e), product + e);
    });
  }
};

/// The numbers of many paths; none where there are no environments.
template <class T>
class PathRatios {
 public:
  PathRatios(const medium::EnvironmentsView& environments, std::size_t paths)
      : blocks_(static_cast<std::size_t>(environments.stride) / block),
        number_(2 * blocks_ * paths) {}

  [[nodiscard]] PathRatio<T> of(std::size_t path) {
    auto* product = &number_[2 * blocks_ * path];
    return {product->number.data(), product[blocks_].number.data()};
  }
  void begin(const medium::EnvironmentsView& environments, std::size_t path) {
    if (blocks_ > 0) of(path).begin(environments);
  }
  /// Makes a path, perhaps a new one, like another.
  void copy(const medium::EnvironmentsView& environments, std::size_t from, std::size_t to) {
    copy(environments, *this, from, to);
  }
  /// The same of one that is kept with others.
  void copy(const medium::EnvironmentsView& environments, PathRatios& others, std::size_t from,
            std::size_t to) {
    if (blocks_ == 0) return;
    number_.resize(std::max(number_.size(), 2 * blocks_ * (to + 1)));
    const PathRatio<T> source = others.of(from), copy = of(to);
    each_group<T>(environments, [&](std::int32_t e) {
      store(load<T>(source.product + e), copy.product + e);
      store(load<T>(source.excess_tau + e), copy.excess_tau + e);
    });
  }
  /// Product and depth of a path, for environments from `first` on.
  [[nodiscard]] std::array<T, 2> at(std::size_t path, std::int32_t first) const {
    const auto* product = &number_[2 * blocks_ * path];
    return {load<T>(product->number.data() + first),
            load<T>(product[blocks_].number.data() + first)};
  }
  /// Bytes for each path.
  static std::size_t size(const medium::EnvironmentsView& environments) {
    return 2 * sizeof(Element<T>) * static_cast<std::size_t>(environments.stride);
  }

 private:
  static constexpr std::size_t block = medium::environment_padding;
  struct alignas(64) Block {
    std::array<Element<T>, block> number{};
  };
  std::size_t blocks_;
  std::vector<Block> number_;
};

/// Adds the excess optical depth of a straight segment.
template <class T>
void add_straight(const medium::MediumView& sea, const geometry::Segment<T>& s, Terms<T>& ways) {
  using std::abs;
  const auto& [from, to] = std::tie(s.from, s.to);
  const Mask<T> same = from.layer == to.layer;
  const T fall = abs(from.depth - to.depth);
  const T rise = select(same | (fall == T(0)), T(1), fall);
  const T per_depth = select(from.depth > to.depth, s.length, -s.length) / rise;
  ways.add(sea.excess_c(s.line, from.layer), select(same, s.length, per_depth * from.below_top));
  if (all(same)) return;
  const T apart = select(same, T(0), per_depth);
  ways.add(sea.excess_depth_tau(s.line, from.layer), apart);
  ways.add(sea.excess_depth_tau(s.line, to.layer), -apart);
  ways.add(sea.excess_c(s.line, to.layer), -apart * to.below_top);
}
/// The same of any segment in one column.
template <class T>
void add_in_column(const medium::MediumView& sea, const geometry::Segment<T>& s, Terms<T>& ways) {
  if (s.course == geometry::Course::straight) return add_straight(sea, s, ways);
  const medium::Level<T> top{};
  if (s.course == geometry::Course::to_surface)
    return add_straight(sea, {s.line, s.from, top, s.length}, ways);
  const auto up = [&](const medium::Level<T>& at) {
    add_straight(sea, {s.line, at, top, at.depth * s.slant.length / s.slant.depth}, ways);
  };
  up(s.from), up(s.to);
}
/// The same of any segment.
template <class T>
void add_segment(const medium::MediumView& sea, const geometry::Segment<T>& s, Terms<T>& ways) {
  if (!sea.row.has_faces) [[likely]]
    return add_in_column(sea, s, ways);
  geometry::each_piece(sea, s, [&](const Mask<T>& on, geometry::Segment<T> piece) {
    piece.length = select(on, piece.length, T(0));
    add_in_column(sea, piece, ways);
  });
}

/// A film that such a segment, in a direction, comes through or is reflected by.
template <class T>
void add_flat_film(const medium::MediumView& sea, const geometry::Segment<T>& s,
                   const Vec3<T>& direction, Terms<T>& ways) {
  using std::abs;
  if (s.course == geometry::Course::to_surface)
    add_flat_film(sea, {s.line, Index<T>(through_film), direction.z}, ways);
  if (s.course == geometry::Course::by_surface)
    add_flat_film(sea, {s.line, Index<T>(back_into_water), T(abs(direction.z))}, ways);
}

/// The column between the surface and a point of an instrument in a region, stretched so much;
/// `cosine`: of the light's direction there to the vertical, above 0.
template <class T>
void add_column(const geometry::Region<T>& region, const Index<T>& line, const T& cosine,
                const T& stretch, Terms<T>& ways) {
  if (region.column.excess < 0) return;
  ways.add(Index<T>(region.column.excess) + line, stretch / cosine);
}
/// The same of light that goes through the flat surface, by its direction in the water.
template <class T>
void add_column_by_flat_surface(const medium::MediumView& sea, const geometry::Region<T>& region,
                                const Index<T>& line, const Vec3<T>& direction, const T& stretch,
                                Terms<T>& ways) {
  using std::abs;
  if (region.column.excess < 0) return;
  const Vec3<T> rising{direction.x, direction.y, T(abs(direction.z))};
  const auto split = surface::flat_surface<T>(sea, line).from_below(rising);
  add_column(region, line, split.transmitted.z, stretch, ways);
}

/// A collision of light of a line: it is converted into another line, or from it on the way back
/// (`converted`), or scattered at an angle.
template <class T>
struct Encounter {
  Index<T> line{};  ///< of light that is scattered
  Index<T> layer{};
  Mask<T> converted{};
  Index<T> emitted{};  ///< line of emitted light, where that is what happens
  T x{};               ///< 1 - cos of the scattering angle
  T cosine{1};         ///< on the bed: to the vertical, of the light that comes down to it
};

/// Adds the excess reflection of the bed, over that in the medium.
template <class T>
void add_reflection(const medium::MediumView& sea, const Encounter<T>& c, Terms<T>& collision) {
  const T albedo = surface::bed_albedo(sea, c.line, c.layer, c.cosine);
  const Mask<T> reflects = surface::on_bed<T>(sea, c.layer) & (albedo > T(0));
  if (!any(reflects)) return;
  const auto [first, rest] = surface::bed_angle(sea, c.cosine);
  const T per_albedo = select(reflects, T(1), T(0)) / select(reflects, albedo, T(1));
  collision.add(sea.template excess_bed<T>(c.line, c.layer, first), (T(1) - rest) * per_albedo);
  if (sea.bed_angles > 1)
    collision.add(sea.template excess_bed<T>(c.line, c.layer, first + Index<T>(1)),
                  rest * per_albedo);
}

/// Adds the excess of an encounter's coefficient there, over that in the medium.
template <class T>
void add_encounter(const medium::MediumView& sea, const Encounter<T>& c, Terms<T>& collision) {
  if (any(c.converted))
    collision.add(sea.excess_emitted(c.emitted, c.layer), select(c.converted, T(1), T(0)));
  if (all(c.converted)) return;
  if (sea.bed_angles > 0) add_reflection(sea, c, collision);
  const Index<T> here = sea.at(c.line, c.layer);
  const T whole = sea.phases.template value<T>(c.x, gather_index<T>(sea.elastic_phase, here));
  const Mask<T> scatters = (whole > T(0)) & !c.converted;
  const T per_whole = select(scatters, T(1), T(0)) / select(scatters, whole, T(1));
  for (std::int32_t k = 0; k < sea.environments.parts; ++k) {
    const auto phase = gather_index<T>(sea.environments.part_phase,
                                       here * Index<T>(sea.environments.parts) + Index<T>(k));
    collision.add(sea.excess_part(c.line, c.layer, k),
                  per_whole * sea.phases.template value<T>(c.x, phase));
  }
}

/// The completion of a path beyond its walks' numbers: the ways still to go, and the collisions at
/// their ends.
template <class T>
struct Completion {
  Terms<T> ways;
  std::array<Terms<T>, 2> collision;
  std::size_t collisions = 0;
  OtherSurfaces<T> surface;
  OtherEmission<T> emission;  ///< by a film
  bool meets = false;         ///< the walks' rays have met, before what ends their legs
  Index<T> sent_back{};       ///< of those, by facets: 1 the laser's, 2 the telescope's, 3 both

  void clear() {
    meets = false;
    sent_back = Index<T>(0);
    ways.clear();
    collisions = 0;
    surface.clear();
    emission.clear();
  }
  void pass(const medium::MediumView& sea, const geometry::Segment<T>& segment) {
    add_segment(sea, segment, ways);
  }
  /// The same of one in a direction that may come to a flat film.
  void pass_flat(const medium::MediumView& sea, const geometry::Segment<T>& segment,
                 const Vec3<T>& direction) {
    add_flat_film(sea, segment, direction, ways);
    add_segment(sea, segment, ways);
  }
  void collide(const medium::MediumView& sea, const Encounter<T>& encounter) {
    Terms<T>& terms = collision[collisions++];
    terms.clear();
    add_encounter(sea, encounter, terms);
  }
};

/// The ratios of a completed path in a lane, from product and depth of its walks, to where there is
/// room for a whole row. Returns how many are not finite, and put down as 0.
template <class T, class Walks>
std::uint64_t complete(const medium::MediumView& sea, const Completion<T>& completion,
                       std::size_t lane, Walks walks, Element<T>* to) {
  // No more than a number can say: the light itself is gone by then.
  const T least(sizeof(Element<T>) == sizeof(double) ? -600 : -80);
  const T most(std::numeric_limits<Element<T>>::max());
  const medium::EnvironmentsView& environments = sea.environments;
  std::uint64_t lost = 0;
  each_group<T>(environments, [&](std::int32_t first) {
    using std::abs;
    auto [product, excess_tau] = walks(first);
    excess_tau = excess_tau + completion.ways.sum(environments, lane, first);
    for (std::size_t k = 0; k < completion.collisions; ++k)
      product = collided(environments, product, completion.collision[k], lane, first);
    product = times(environments, product, completion.surface.sum(sea, lane, first), first);
    product = times(environments, product, completion.emission.sum(sea, lane, first), first);
    const T of_other_water = product * exp_minus(select(excess_tau > least, excess_tau, least));
    const T ratio =
        select(tangents<T>(environments, first), T(1) + product - excess_tau, of_other_water);
    const Mask<T> finite = abs(ratio) <= most;
    lost += lanes_of<T> - count(finite);
    store(select(finite, ratio, T(0)), to + first);
  });
  return lost;
}

}  // namespace photic::estimator
