#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/constants.hpp"
#include "scene/checks.hpp"
#include "scene/tally_memory.hpp"

namespace photic::scene {
namespace {

constexpr double max_gates = 1e6;

/// The names of the keys of an interval, and their unit.
struct Keys {
  std::string min, max, step;
  const char* unit;
};

Keys keys_of(const Gates& gates) {
  if (gates.depth_m) return {"gates.depth_min_m", "gates.depth_max_m", "gates.depth_step_m", "m"};
  if (gates.range_m) return {"gates.range_min_m", "gates.range_max_m", "gates.range_step_m", "m"};
  return {"gates.start_ns", "gates.stop_ns", "gates.step_ns", "ns"};
}

void remark_uneven(const Gates::Interval& interval, const Keys& keys, Findings& findings) {
  const double extent = interval.max - interval.min;
  const double steps = extent / interval.step;
  if (std::fabs(steps - std::round(steps)) <= 1e-6) return;
  findings.remark(
      keys.step,
      fmt::format("steps of {0} {6} do not fill the {1} {6} from {2} to {3} {6}: the {4:.0f} gates "
                  "are {5:.6g} {6} long instead",
                  plain_number(interval.step), plain_number(extent), plain_number(interval.min),
                  plain_number(interval.max), interval.steps(), extent / interval.steps(),
                  keys.unit));
}

/// Returns whether the interval itself makes sense.
bool check_interval(const Gates::Interval& interval, const Keys& keys, Findings& findings) {
  const double extent = interval.max - interval.min;
  if (!(extent > 0.0)) {
    findings.add(keys.max,
                 fmt::format("the gates end at {0} {2}, not beyond {1} {2} where they begin",
                             plain_number(interval.max), plain_number(interval.min), keys.unit),
                 "");
  } else if (interval.step > extent) {
    findings.add(keys.step,
                 fmt::format("a gate of {0} {2} is longer than all gates together, {1} {2}",
                             plain_number(interval.step), plain_number(extent), keys.unit),
                 "");
  } else if (!(interval.steps() <= max_gates)) {
    findings.add(keys.step, fmt::format("these are {:.7g} gates", interval.steps()),
                 fmt::format("at most {} are possible: take longer ones", plain_number(max_gates)));
  } else {
    remark_uneven(interval, keys, findings);
    return true;
  }
  return false;
}

/// Remarks on gates by depth over a bed that reflects: light that goes straight there and back all
/// comes at one time.
void remark_on_bed(const Gates::Interval& depth, double bed, const Keys& keys, Findings& findings) {
  const std::string at = fmt::format("the sea bed at {} m", plain_number(bed));
  if (depth.max <= bed)
    return findings.remark(keys.max, "the last gate ends before the light of " + at +
                                         " arrives: end the gates below it to see it");
  if (depth.min > bed)
    return findings.remark(keys.min, "the gates begin below " + at +
                                         ": of its light they hold only what arrives late");
  const double length = (depth.max - depth.min) / depth.steps();
  const double from_edge = std::remainder(bed - depth.min, length);
  if (std::abs(from_edge) < 1e-4)
    findings.remark(keys.step, "a gate begins at " + at +
                                   ": rounding may put some of its light into the gate before; let "
                                   "no gate begin within 0.1 mm of the bed");
}

/// Depth gates need a path that goes down along the axis of the source and comes back up along
/// that of telescope 0.
void check_depth_gates(const Scene& scene, const Keys& keys, Findings& findings) {
  const Gates::Interval& depth = *scene.gates.depth_m;
  const double highest = std::max(-scene.source.position_m.z, -scene.telescope[0].position_m.z);
  if (scene.source.direction.z >= 0.0 || scene.telescope[0].direction.z >= 0.0)
    return findings.add(keys.max,
                        "gates by depth need a source and a first telescope that look down",
                        "give the gates by range_… or by …_ns");
  if (depth.min < highest)
    findings.add(keys.min,
                 fmt::format("the gates begin at the depth {} m, above the source or the "
                             "first telescope",
                             plain_number(depth.min)),
                 fmt::format("begin at {} m or deeper", plain_number(highest)));
  if (depth.max <= 0.0 && !scene.atmosphere)
    findings.add(keys.max, "all gates lie in the air",
                 "end them below the sea surface, at depth 0, or give the scene an [atmosphere]");
  for (std::size_t t = 1; t < scene.telescope.size(); ++t) {
    if (scene.telescope[t].direction.z >= 0.0)
      findings.remark(fmt::format("telescope.{}.direction", t),
                      fmt::format("telescope \"{}\" does not look down: its gates have times, but "
                                  "no depths",
                                  scene.telescope[t].name));
  }
  const auto bed = sea_bed_m(scene, findings);
  if (!bed) return;
  if (has_bed(scene)) return remark_on_bed(depth, *bed, keys, findings);
  if (depth.min >= *bed)
    findings.add(keys.min,
                 fmt::format("all gates lie below the sea bed at {} m", plain_number(*bed)), "");
}

/// Range gates along an axis that starts in clear air must get as far as the water.
void check_range_gates(const Scene& scene, const Keys& keys, Findings& findings) {
  const Telescope& t = scene.telescope[0];
  if (t.position_m.z < 0.0) return;
  if (t.direction.z >= 0.0)
    return findings.add(keys.max, "the axis of the first telescope never meets the water",
                        "make it look down, or give the gates by …_ns");
  const double to_water = t.position_m.z * length(t.direction) / -t.direction.z;
  if (scene.gates.range_m->max <= to_water && !scene.atmosphere)
    findings.add(keys.max,
                 fmt::format("all gates lie in the air: the axis of the first telescope meets "
                             "the water at {:.4g} m",
                             to_water),
                 "end them beyond that, or give the scene an [atmosphere]");
}

/// A time before which no light can have been in the water and come to the telescope: by way of the
/// surface from air to air, else straight; at the speed of light in vacuum.
double earliest_ns(const Source& source, const Telescope& telescope) {
  Vec3<double> path = telescope.position_m - source.position_m;
  if (source.position_m.z > 0.0 && telescope.position_m.z > 0.0)
    path.z = telescope.position_m.z + source.position_m.z;
  return length(path) / metre_per_nanosecond;
}

void check_time_gates(const Scene& scene, const Keys& keys, Findings& findings) {
  if (scene.atmosphere) return;  // light comes back at once
  double earliest = earliest_ns(scene.source, scene.telescope[0]);
  for (const Telescope& t : scene.telescope)
    earliest = std::min(earliest, earliest_ns(scene.source, t));
  if (scene.gates.time_ns->max <= earliest)
    findings.add(keys.max,
                 fmt::format("all gates end before light can come back from the water, after "
                             "{:.4g} ns",
                             earliest),
                 "");
}

void check_tools(const Scene& scene, Findings& findings) {
  const Simulation& s = scene.simulation;
  if (!findings.good({"simulation.tools", "simulation.estimator"})) return;
  if ((s.estimator == Estimator::bidirectional || s.estimator == Estimator::analog) &&
      s.tools.any()) {
    findings.add("simulation.estimator",
                 fmt::format("the {} estimator cannot use simulation.tools", word_of(s.estimator)),
                 "write estimator = \"forward\", or leave the tools out");
  }
  for (std::size_t i = 1; i < s.tools.importance.size(); ++i) {
    if (s.tools.importance[i].depth_m > s.tools.importance[i - 1].depth_m) continue;
    findings.add(fmt::format("simulation.tools.importance.{}.depth_m", i),
                 "importances must be listed from the surface down",
                 fmt::format("a depth below {} m", s.tools.importance[i - 1].depth_m));
  }
}

/// The path of what takes most, and the advice.
std::pair<std::string, std::string> what_to_lessen(const TallyMemory& memory, const Scene& scene) {
  const Keys keys = keys_of(scene.gates);
  const bool more_environments = scene.environment.size() >= scene.sensitivity.size();
  const double most =
      std::max({memory.depths, memory.orders, memory.other_waters, memory.rest, memory.tallies});
  if (memory.bytes() - memory.groups <= max_tally_memory)
    return {"simulation.keep_groups",
            "keep_groups = false leaves echoes by groups of batches out; or take fewer gates"};
  if (memory.tallies == most) return {"tally", "take fewer levels, directions or edges"};
  if (memory.other_waters == most)
    return {more_environments ? "environment" : "sensitivity",
            fmt::format("take fewer {}, or fewer gates",
                        more_environments ? "environments" : "parameters")};
  if (memory.depths == most)
    return {"gates.depth_cells", "take fewer, 0 leaves echo_by_depth out, or fewer gates"};
  if (memory.orders == most) return {"simulation.orders_kept", "keep fewer orders: orders_kept"};
  return {keys.step, "take fewer gates"};
}

/// The mean over a lens takes the whole of it at one angle of scattering.
void check_reception(const Scene& scene, Findings& findings) {
  if (scene.simulation.reception != Reception::overlap) return;
  const Estimator asked = scene.simulation.estimator;
  if (asked != Estimator::forward && asked != Estimator::automatic) return;  // it has no effect
  if (std::ranges::any_of(scene.telescope, [](const auto& t) { return t.position_m.z < 0; }) &&
      findings.good({"simulation.reception", "telescope"}))
    findings.remark("simulation.reception",
                    "the mean over a lens in the water takes light scattered close to it at one "
                    "angle: echoes are low, without a flag (3 m from a lens of 0.3 m a gate by 3 "
                    "%, its third order by 20 %); reception = \"ray\" is exact");
}

/// A remark if echoes by groups of batches are left out though the scene asks for them.
void check_groups(const Scene& scene, Findings& findings) {
  if (!scene.simulation.keep_groups || keeps_groups(scene)) return;
  findings.remark(
      "simulation.keep_groups",
      fmt::format("echoes by groups of batches would take up to {:.0f} MB in the result, more than "
                  "{:.0f}, and are left out: errors of what is made of several echoes will not be "
                  "known (take fewer gates, channels or environments, or keep_groups = false)",
                  group_echoes(scene) / 1e6, max_group_echoes / 1e6));
}

}  // namespace

void check_gates(const Scene& scene, Findings& findings) {
  const Gates& gates = scene.gates;
  const Keys keys = keys_of(gates);
  if (!findings.good({keys.min, keys.max, keys.step})) return;
  if (!gates.depth_m && !gates.range_m && !gates.time_ns) return;
  if (!check_interval(gates.interval(), keys, findings)) return;
  if (!scene.source.is_pulsed()) return;  // it has no telescopes
  const bool source_good = findings.good({"source.position_m", "source.direction"});
  const bool axis_good = findings.good({"telescope.0.position_m", "telescope.0.direction"});
  if (gates.depth_m && source_good && axis_good) check_depth_gates(scene, keys, findings);
  if (gates.range_m && axis_good) check_range_gates(scene, keys, findings);
  if (gates.time_ns && findings.good({"source.position_m", "telescope"}))
    check_time_gates(scene, keys, findings);
}

void check_estimator(const Scene& scene, Findings& findings) {
  check_tools(scene, findings);
  check_reception(scene, findings);
  if (scene.has_environments() && scene.simulation.estimator == Estimator::analog &&
      findings.good({"simulation.estimator"})) {
    findings.add("simulation.estimator",
                 fmt::format("the analog estimator cannot use {}: its photons have no weights",
                             scene.environment.empty() ? "sensitivities" : "environments"),
                 fmt::format("write estimator = \"forward\", or leave {} out",
                             scene.environment.empty() ? "sensitivity" : "[[environment]]"));
  }
}

void check_memory(const Scene& scene, Findings& findings) {
  if (!findings.good({"telescope", "channel", "gates", "simulation.orders_kept", "environment",
                      "sensitivity", "tally", "simulation.keep_groups"}))
    return;
  check_groups(scene, findings);
  const TallyMemory memory = tally_memory(scene);
  if (memory.bytes() <= max_tally_memory) return;
  const auto [path, suggestion] = what_to_lessen(memory, scene);
  const auto count = [](const char* what, std::size_t number) {
    return number == 0 ? "" : fmt::format(", {} {}", what, number);
  };
  findings.add(
      path,
      fmt::format(
          "the tallies (telescopes {}, channels {}, gates {}, orders {}{}{}{}{}) would take "
          "{:.3g} GiB; the limit is 2 GiB",
          scene.telescope.size(), scene.channel.size(), scene.gates.count(),
          scene.simulation.orders_kept,
          count("cells of depth", static_cast<std::size_t>(scene.gates.depth_cells)),
          count("environments", scene.environment.size()),
          count("parameters", scene.sensitivity.size()),
          count("cells of [[tally]]", static_cast<std::size_t>(cells_of_tallies(scene))),
          memory.bytes() / (max_tally_memory / 2.0)),
      suggestion);
}

}  // namespace photic::scene
