#include <fmt/format.h>

#include <map>

#include "scene/checks.hpp"

namespace photic::scene {
namespace {

/// "telescope.2.key"
std::string at(std::size_t i, const char* key) { return fmt::format("telescope.{}.{}", i, key); }

template <class Named>
void check_names(const std::vector<Named>& all, const std::string& section, Findings& findings) {
  std::map<std::string, std::size_t> seen;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string path = below(below(section, i), "name");
    if (!findings.good({path})) continue;
    const auto [first, is_new] = seen.emplace(all[i].name, i);
    if (!is_new)
      findings.add(path, fmt::format("two of [[{}]] are called {}", section, quoted(all[i].name)),
                   "give each its own name");
  }
}

/// Neither on the surface nor in the sea bed.
void check_height(const std::string& path, const char* what, double z, const Scene& scene,
                  Findings& findings) {
  if (!findings.good({path})) return;
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

void check_source(const Scene& scene, Findings& findings) {
  const Source& source = scene.source;
  remark_size("source.diameter_m", source.diameter_m, findings);
  check_height("source.position_m", "source", source.position_m.z, scene, findings);
  if (!findings.good({"source.position_m", "source.direction"})) return;
  if (source.position_m.z > 0.0 && source.direction.z >= 0.0)
    findings.add("source.direction",
                 "the light never meets the sea: a source in the air must point down",
                 "make the third number negative");
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
  check_height(at(i, "position_m"), "telescope", t.position_m.z, scene, findings);
  remark_size(at(i, "diameter_m"), t.diameter_m, findings);
  remark_size(at(i, "detector_diameter_m"), t.detector_diameter_m.value_or(0), findings);
  check_lens(t, i, findings);
  if (findings.good({at(i, "position_m"), at(i, "direction")}) && t.position_m.z > 0.0 &&
      t.direction.z >= 0.0)
    findings.remark(at(i, "direction"), "this telescope in the air looks away from the sea");
}

}  // namespace

void check_instrument(const Scene& scene, Findings& findings) {
  check_source(scene, findings);
  for (std::size_t i = 0; i < scene.telescope.size(); ++i) check_telescope(scene, i, findings);
  check_names(scene.telescope, "telescope", findings);
  check_names(scene.channel, "channel", findings);
  check_names(scene.sea.layer, "sea.layer", findings);
  check_names(scene.environment, "environment", findings);
}

}  // namespace photic::scene
