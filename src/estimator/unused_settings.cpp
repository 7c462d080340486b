#include "estimator/unused_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "estimator/nested_views.hpp"
#include "estimator/strategies.hpp"
#include "medium/build.hpp"
#include "scene/waves.hpp"

namespace photic::estimator {
namespace {

using scene::Estimator;
using scene::Simulation;

/// Why a setting has no effect, and what to do.
struct Unused {
  std::string why, advice = "leave it out";
};

/// The medium of a scene, made where a rule asks for it.
using MediumOfScene = std::function<const medium::Medium&()>;

/// What a scene's simulation does not use: each rule returns the reason, or nothing.
class Rules {
 public:
  Rules(const scene::Scene& scene, MediumOfScene medium)
      : scene_(scene), asked_(scene.simulation), medium_(std::move(medium)) {}

  /// The settings of walks.
  [[nodiscard]] std::optional<Unused> walks() const {
    const auto lacks = scene::bidirectional_lacks(scene_);
    const bool has_tools = asked_.tools.any();
    switch (asked_.estimator) {
      case Estimator::bidirectional:
        return {};
      case Estimator::automatic:
        if (has_tools)
          return Unused{"auto takes the forward estimator, the only one with simulation.tools",
                        "leave it or the tools out"};
        if (lacks) return Unused{"auto takes the forward estimator, the only one for " + *lacks};
        return {};
      case Estimator::forward:
      case Estimator::analog:
        break;
    }
    Unused out{fmt::format("the {} estimator has no walks", word_of(asked_.estimator))};
    if (!lacks && !has_tools) out.advice += ", or write estimator = \"bidirectional\"";
    return out;
  }

  /// The settings of one kind of free walks. Those in air are ruled by other symmetries.
  [[nodiscard]] std::optional<Unused> free_walks(const std::optional<double>& per_metre,
                                                 Strategy Strategies::*kind) const {
    if (auto unused = walks()) return unused;
    if (per_metre.value_or(0) == 0 || scene_.atmosphere) return {};
    const Strategy strategy = make_strategies(scene_, medium_()).*kind;
    if (strategy.used) return {};
    return Unused{fmt::format("there are no {}: {}", strategy.name, strategy.reason),
                  "leave it out, or write 0"};
  }

  /// The settings of the forward estimator. Its histories run beside walks where these leave out
  /// light (plan.cpp).
  [[nodiscard]] std::optional<Unused> histories() const {
    const char* const advice = "leave it out, or write estimator = \"forward\"";
    if (asked_.estimator == Estimator::analog)
      return Unused{"analog photons are followed by chance alone", advice};
    if (asked_.estimator == Estimator::bidirectional && !scene_.oil && !scene_.atmosphere)
      return Unused{"it is a setting of the forward estimator", advice};
    return {};
  }

  /// Where telescopes could share light, any way of reception but by rays keeps them from it.
  [[nodiscard]] std::optional<Unused> reception() const {
    if (asked_.reception == scene::Reception::ray) return {};
    auto unused = histories();
    if (!unused || asked_.estimator == Estimator::analog) return unused;
    scene::Scene by_rays = scene_;
    by_rays.simulation.reception = scene::Reception::ray;
    if (nested_views(by_rays).size() < scene_.telescope.size()) return {};
    return unused;
  }

  [[nodiscard]] std::optional<Unused> scored_points() const {
    if (auto unused = histories()) return unused;
    if (asked_.tools.local_forced_collisions != scene::LocalForcedCollisions::all ||
        scene_.atmosphere)
      return {};
    return Unused{"local_forced_collisions = \"all\" chooses the points that are scored",
                  "leave one of them out"};
  }

  [[nodiscard]] std::optional<Unused> conversions() const {
    if (!asked_.conversion_probability) return {};
    if (asked_.estimator == Estimator::analog)
      return Unused{"analog photons are converted as often as the water converts them"};
    if (converts_light(medium_())) return {};
    return Unused{"no light that a channel counts is converted in the water"};
  }

 private:
  const scene::Scene& scene_;
  const Simulation& asked_;
  const MediumOfScene medium_;
};

/// Puts in place of each unused setting what is in effect, and calls found(key, Unused).
template <class Found>
Simulation replaced(const scene::Scene& scene, const MediumOfScene& medium, const Found& found) {
  const Rules rules(scene, medium);
  const Simulation usual;
  Simulation s = scene.simulation;
  const auto look_at = [&](const char* key, auto setting, const std::optional<Unused>& unused,
                           const auto& in_effect) {
    auto& value = std::invoke(setting, s);
    if (!unused || value == std::invoke(setting, usual) || value == in_effect) return;
    value = in_effect;
    found(key, *unused);
  };
  const auto look = [&](const char* key, auto setting, const std::optional<Unused>& unused) {
    look_at(key, setting, unused, std::invoke(setting, usual));
  };
  const auto threshold = [](auto& of) -> auto& { return of.tools.weight_threshold; };
  const auto no_free_walks = rules.walks() ? std::optional<double>{} : 0.0;
  look("walks", &Simulation::walks, rules.walks());
  look("meetings", &Simulation::meetings, rules.walks());
  look("connected_fraction", &Simulation::connected_fraction, rules.walks());
  look("walk_attenuation", &Simulation::walk_attenuation, rules.walks());
  look_at("free_telescope_meetings", &Simulation::free_telescope_meetings,
          rules.free_walks(s.free_telescope_meetings, &Strategies::free_telescope), no_free_walks);
  look_at("free_laser_meetings", &Simulation::free_laser_meetings,
          rules.free_walks(s.free_laser_meetings, &Strategies::free_laser), no_free_walks);
  look("conversion_probability", &Simulation::conversion_probability, rules.conversions());
  look("directed_fraction", &Simulation::directed_fraction, rules.histories());
  look("scored_points", &Simulation::scored_points, rules.scored_points());
  look("reception", &Simulation::reception, rules.reception());
  look("tools.weight_threshold", threshold, rules.histories());
  return s;
}

}  // namespace

bool converts_light(const medium::Medium& medium) {
  return std::ranges::any_of(medium.line, [](const medium::Line& line) {
    return line.process != medium::Process::elastic && line.process != medium::Process::oil;
  });
}

void check_unused_settings(const scene::Scene& scene, const optics::Library& library,
                           scene::Findings& findings) {
  if (!findings.problems().empty()) return;
  const scene::Scene alone = scene_alone(scene);
  std::optional<medium::Medium> medium;
  const MediumOfScene medium_of = [&]() -> const medium::Medium& {
    if (!medium) medium = medium::build_medium(alone, library);
    return *medium;
  };
  replaced(alone, medium_of, [&](const char* key, const Unused& unused) {
    findings.remark(scene::below("simulation", key),
                    fmt::format("'{}' has no effect: {}; {}", key, unused.why, unused.advice));
  });
}

scene::Simulation without_unused_settings(const scene::Scene& scene, const medium::Medium& medium) {
  return replaced(
      scene, [&]() -> const medium::Medium& { return medium; }, [](auto...) {});
}

}  // namespace photic::estimator
