// A layer in which constituents change with depth, cut into homogeneous ones.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "scene/profile.hpp"

namespace photic::scene {

using Profile = std::variant<LinearProfile, GaussianProfile>;

[[nodiscard]] double mean(const Profile& profile, double a_m, double b_m);
[[nodiscard]] double greatest(const Profile& profile, double a_m, double b_m);
/// The most by which a profile departs from its mean over a - b.
[[nodiscard]] double departure(const Profile& profile, double a_m, double b_m);

/// A profile to be cut, and what its departures are measured against.
struct Varying {
  Profile profile;
  std::optional<double> scale = std::nullopt;  ///< none: its greatest value in its layer
};

/// Between two depths.
struct Span {
  double top_m, bottom_m;
};

/// The most by which a profile may depart from its mean in what its layer, `span`, is cut into.
[[nodiscard]] double allowed_departure(const Varying& varying, const Span& span, double tolerance);

/// More are refused.
inline constexpr std::size_t max_cuts = 500;

/// The lower ends of as few layers as it takes, from the top down, for no profile to depart from
/// its mean within a layer by more than allowed_departure. Depths are round where the tolerance
/// lets them. None if that is more than max_cuts.
[[nodiscard]] std::optional<std::vector<double>> cut(const std::vector<Varying>& profiles,
                                                     const Span& span, double tolerance);

/// The least of 1, 2 and 5 times powers of ten, above `tolerance` and at most 1, that cut() can
/// keep; none where values are too large to be added up.
[[nodiscard]] std::optional<double> tolerance_to_keep(const std::vector<Varying>& profiles,
                                                      const Span& span, double tolerance);

}  // namespace photic::scene
