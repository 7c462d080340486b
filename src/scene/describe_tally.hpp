// The keys of [[tally]] (see describe_instrument.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/rules.hpp"
#include "scene/scene.hpp"
#include "scene/visitor.hpp"

namespace photic::scene {

/// Edges of the angles of light that escapes, by default.
inline const std::vector<double> every_ten_degrees{0, 10, 20, 30, 40, 50, 60, 70, 80, 90};

/// Depths, or heights: lists of so many or more.
inline NumberList depths_rule(std::size_t least) {
  return {{.low = 0.0, .advice = "places above the sea have a height_m"}, least};
}
inline NumberList heights_rule(std::size_t least) {
  return {{.low = 0.0, .advice = "places below the surface have a depth_m"}, least};
}

template <class V>
void describe_levels(V& v, Tally& t) {
  v.any_of(
      [&](auto& w) {
        w.optional("depth_m", t.depth_m, depths_rule(1),
                   "depths, ascending, in m: levels, 0 just below the surface; of a fluence the "
                   "edges of its cells");
        w.optional("height_m", t.height_m, heights_rule(1),
                   "heights above the sea or the ground, ascending, in m: levels, 0 just above; of "
                   "a fluence the edges of its cells");
      },
      "give levels in the water, in the air or both");
}

template <class V>
void describe_fluence(V& v, Tally& t) {
  std::optional<std::string> name;
  if (!t.name.empty()) name = t.name;
  v.optional("name", name, Text{}, "what results call it; needed where there are several");
  v.once_read([&] { t.name = name.value_or(""); });
  v.one_of(option(!t.depth_m.empty(),
                  [&](auto& w) {
                    w.required("depth_m", t.depth_m, depths_rule(2),
                               "the edges of its cells, as depths in m");
                  }),
           option(!t.height_m.empty(), [&](auto& w) {
             w.required("height_m", t.height_m, heights_rule(2),
                        "the edges of its cells, as heights in m");
           }));
  v.one_of(option(!t.radius_m.empty(),
                  [&](auto& w) {
                    w.required("radius_m", t.radius_m, NumberList{not_negative, 2},
                               "the edges of rings about the vertical through the source, in m");
                  }),
           option(!t.x_m.empty(), [&](auto& w) {
             w.required("x_m", t.x_m, NumberList{any_number, 2},
                        "the edges of cells along x in m, each as long as the world in y");
           }));
}

template <class V>
void describe_boundaries(V& v, Tally& t) {
  std::vector<double> edges = t.zenith_deg.empty() ? every_ten_degrees : t.zenith_deg;
  v.optional("zenith_deg", edges,
             NumberList{{.low = 0.0, .high = 90.0, .advice = "90 is along the horizon"}, 2},
             "the edges of the angles from straight up at which light escapes, ascending from 0 to "
             "90, in degrees");
  v.once_read([&] { t.zenith_deg = edges; });
}

template <class V>
void describe(V& v, Tally& t) {
  using enum TallyKind;
  v.required("kind", t.kind, ChoiceOf<TallyKind>{}, "the quantity");
  v.by_choice(
      "kind", t.kind,
      for_choice(
          irradiance,
          [&](auto& w) {
            describe_levels(w, t);
            w.optional(
                expert("zone_deg"), t.zone_deg,
                NumberList{
                    {.low = 0.0, .high = 180.0, .advice = "180 is the far side of the planet"}, 2},
                "in spherical air under a beam as wide as the planet: the edges of "
                "zones, as angles at the planet's centre from the point under the "
                "source, ascending, in degrees");
            w.optional(
                expert("slab_m"), t.slab_m,
                Number{.low = 0.0,
                       .low_open = true,
                       .advice = "without it slabs are a twentieth of an attenuation length"},
                "the thickness of the slabs about the levels in which "
                "scalar irradiances are taken, in m; by default a twentieth "
                "of an attenuation length");
          }),
      for_choice(boundaries, [&](auto& w) { describe_boundaries(w, t); }),
      for_choice(fluence, [&](auto& w) { describe_fluence(w, t); }),
      for_choice(radiance, [&](auto& w) {
        describe_levels(w, t);
        w.required("direction_deg", t.direction_deg, TravelDirections{},
                   "the directions in which the light travels, [[zenith, azimuth], …] in degrees: "
                   "[0, 0] is straight up, azimuths are from +x to +y");
      }));
}

}  // namespace photic::scene
