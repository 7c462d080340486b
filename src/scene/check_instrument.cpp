#include <fmt/format.h>

#include <cmath>
#include <map>

#include "core/constants.hpp"
#include "scene/checks.hpp"

namespace photic::scene {
namespace {

/// "telescope.2.key"
std::string at(std::size_t i, const char* key) { return fmt::format("telescope.{}.{}", i, key); }

template <class Named>
void check_names(const std::vector<Named>& all, const std::string& path_of_all,
                 const std::string& section, Findings& findings) {
  std::map<std::string, std::size_t> seen;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string path = below(below(path_of_all, i), "name");
    if (!findings.good({path})) continue;
    const auto [first, is_new] = seen.emplace(all[i].name, i);
    if (!is_new)
      findings.add(path, fmt::format("two of [[{}]] are called {}", section, quoted(all[i].name)),
                   "give each its own name");
  }
}

/// Neither on the surface nor in the sea bed or the ground.
void check_height(const std::string& path, const char* what, const Vec3<double>& position,
                  const Scene& scene, Findings& findings) {
  if (!findings.good({path})) return;
  const double z = scene.height_of(position);
  if (scene.is_of_air_alone()) {
    if (!(z > 0.0))
      findings.add(path, fmt::format("the {} is not above the ground at 0 m", what),
                   "put it into the air (z > 0)");
    return;
  }
  if (z == 0.0)
    findings.add(path, fmt::format("the {} lies on the sea surface", what),
                 "put it into the air (z > 0) or into the water (z < 0)");
  const auto bed = sea_bed_m(scene, findings);
  if (bed && -z >= *bed)
    findings.add(path,
                 fmt::format("the {} is {} m deep and the sea bed {} m", what, plain_number(-z),
                             plain_number(*bed)),
                 "raise it, or lower the last layer's bottom_depth_m");
}

/// Remarks on the size of a disc, a lens or a detector. From memory: the largest mirrors have 10 m.
void remark_size(const std::string& path, double diameter_m, Findings& findings) {
  constexpr double largest_m = 20;
  if (findings.good({path}) && diameter_m > largest_m)
    findings.remark(path,
                    fmt::format("a diameter of {} m is more than a lidar has (mirrors have up "
                                "to 10 m): are the units right?",
                                plain_number(diameter_m)));
}

/// Wings of a Gaussian beam stay below a quarter turn, which the plane across the axis asks.
void check_wings(const Source& source, Findings& findings) {
  constexpr double widest_mrad = 500 * pi / gaussian_cut;
  if (!findings.good({"source.half_divergence_mrad", "source.profile"}) ||
      source.profile == SourceProfile::disc || source.half_divergence_mrad < widest_mrad)
    return;
  findings.add("source.half_divergence_mrad",
               fmt::format("the wings of a Gaussian beam go out to {} times its half divergence, "
                           "and {} mrad is a quarter turn or more",
                           plain_number(gaussian_cut),
                           plain_number(gaussian_cut * source.half_divergence_mrad)),
               fmt::format("take at most {} mrad, or profile = \"disc\"",
                           plain_number(std::floor(widest_mrad))));
}

/// All light of a disc sets out on one side of the surface.
void check_rim(const Source& source, Findings& findings) {
  if (!findings.good({"source.position_m", "source.direction", "source.diameter_m"})) return;
  const Vec3<double> axis = normalised(source.direction);
  const double rise = source.diameter_m / 2 * std::hypot(axis.x, axis.y);
  const double z = source.position_m.z;
  if (z == 0 || std::abs(z) >= rise) return;
  findings.add("source.diameter_m",
               fmt::format("the laser's disc reaches {} m above and below its centre, and through "
                           "the sea surface",
                           plain_number(rise)),
               "make it smaller, or move it farther from the surface");
}

void check_laser(const Scene& scene, Findings& findings) {
  const Source& source = scene.source;
  check_wings(source, findings);
  remark_size("source.diameter_m", source.diameter_m, findings);
  check_height("source.position_m", "source", source.position_m, scene, findings);
  if (!findings.good({"source.position_m", "source.direction"}) || scene.is_of_air_alone()) return;
  check_rim(source, findings);
  if (source.position_m.z > 0.0 && source.direction.z >= 0.0)
    findings.add("source.direction",
                 "the light never meets the sea: a source in the air must point down",
                 "make the third number negative");
}

/// Parallel light comes from above all that scatters.
void check_beam(const Scene& scene, Findings& findings) {
  const Source& source = scene.source;
  if (findings.good({"source.direction"}) && source.direction.z >= 0.0 &&
      !scene.is_of_spherical_air())
    findings.add("source.direction", "the light of a beam comes from above and must point down",
                 "make the third number negative");
  if (source.is_everywhere || !findings.good({"source.position_m"})) return;
  const double z = scene.height_of(source.position_m);
  const auto top = top_of_air_m(scene, findings);
  if (top && z < *top)
    findings.add("source.position_m",
                 fmt::format("the beam begins at {} m, below the top of the air at {} m",
                             plain_number(z), plain_number(*top)),
                 "raise it, or take kind = \"point\", which may be in the air");
  else if (!top && z <= 0.0)
    findings.add("source.position_m",
                 fmt::format("the beam begins at {} m and not above the sea", plain_number(z)),
                 "raise it, or take kind = \"point\", which may be in the water");
}

/// A source inside the water or the air.
void check_place(const Scene& scene, Findings& findings) {
  const double z = scene.height_of(scene.source.position_m);
  check_height("source.position_m", "source", scene.source.position_m, scene, findings);
  const auto top = top_of_air_m(scene, findings);
  if (top && z > *top && findings.good({"source.position_m"}))
    findings.add("source.position_m",
                 fmt::format("the source is at {} m, above the top of the air at {} m",
                             plain_number(z), plain_number(*top)),
                 "lower it, or take kind = \"beam\", which comes from outside");
}

/// Refuses telescopes and walks, which take a laser.
void check_without_laser(const Scene& scene, Findings& findings) {
  const std::string word = word_of(scene.source.kind);
  if (!scene.telescope.empty() && findings.good({"telescope"}))
    findings.add("telescope.0",
                 fmt::format("telescopes see light by its time, and a {} has no pulses", word),
                 "take source.kind = \"laser\", or a [[tally]] in place of telescopes");
  if (scene.simulation.estimator == Estimator::bidirectional && scene.tally.empty() &&
      findings.good({"simulation.estimator"}))
    findings.add("simulation.estimator", "the bidirectional estimator is for lasers alone",
                 "write estimator = \"forward\"");
}

void check_source(const Scene& scene, Findings& findings) {
  if (!findings.good({"source.kind"})) return;
  switch (scene.source.kind) {
    case SourceKind::laser:
      return check_laser(scene, findings);
    case SourceKind::beam:
      check_beam(scene, findings);
      break;
    case SourceKind::point:
    case SourceKind::cone:
      check_place(scene, findings);
      break;
  }
  check_without_laser(scene, findings);
}

void check_lens(const Telescope& t, std::size_t i, Findings& findings) {
  if (findings.good({at(i, "obstruction_diameter_m"), at(i, "diameter_m")}) &&
      t.obstruction_diameter_m >= t.diameter_m)
    findings.add(at(i, "obstruction_diameter_m"),
                 fmt::format("the obstruction of {} m covers the whole lens of {} m",
                             plain_number(t.obstruction_diameter_m), plain_number(t.diameter_m)),
                 "it must be smaller than diameter_m");
  if (findings.good({at(i, "focus_m"), at(i, "focal_length_m")}) && t.focus_m &&
      !(*t.focus_m > t.focal_length_m))
    findings.add(at(i, "focus_m"),
                 fmt::format("what is {} m from a lens of focal length {} m has no sharp image",
                             plain_number(*t.focus_m), plain_number(t.focal_length_m)),
                 "focus_m must be greater than focal_length_m");
  if (findings.good({at(i, "detector_shift_m"), at(i, "focal_length_m")}) &&
      !(t.focal_length_m + t.detector_shift_m > 0.0))
    findings.add(
        at(i, "detector_shift_m"),
        fmt::format(
            "a shift of {} m puts the detector into or before the lens of focal length {} m",
            plain_number(t.detector_shift_m), plain_number(t.focal_length_m)),
        "focal_length_m + detector_shift_m must be greater than 0");
}

void check_telescope(const Scene& scene, std::size_t i, Findings& findings) {
  const Telescope& t = scene.telescope[i];
  check_height(at(i, "position_m"), "telescope", t.position_m, scene, findings);
  remark_size(at(i, "diameter_m"), t.diameter_m, findings);
  remark_size(at(i, "detector_diameter_m"), t.detector_diameter_m.value_or(0), findings);
  check_lens(t, i, findings);
  if (findings.good({at(i, "position_m"), at(i, "direction")}) && !scene.is_of_air_alone() &&
      t.position_m.z > 0.0 && t.direction.z >= 0.0)
    findings.remark(at(i, "direction"), "this telescope in the air looks away from the sea");
}

}  // namespace

void check_instrument(const Scene& scene, Findings& findings) {
  check_source(scene, findings);
  for (std::size_t i = 0; i < scene.telescope.size(); ++i) check_telescope(scene, i, findings);
  check_names(scene.telescope, "telescope", "telescope", findings);
  check_names(scene.channel, "channel", "channel", findings);
  check_names(scene.sea.column, "sea.column", "sea.column", findings);
  for (const Stack& stack : stacks_of(scene.sea))
    check_names(stack.layer, stack.path, stack.section, findings);
  check_names(scene.environment, "environment", "environment", findings);
}

}  // namespace photic::scene
