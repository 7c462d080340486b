#include "medium/environments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "medium/build.hpp"
#include "medium/layer_optics.hpp"
#include "medium/lines.hpp"
#include "medium/other_airs.hpp"
#include "medium/variations.hpp"

namespace photic::medium {
namespace {

bool is(const EmittedLine& emitted, const Line& line) {
  return emitted.process == line.process && emitted.wavelength_nm == line.wavelength_nm;
}

[[noreturn]] void refuse(const std::string& who, const scene::PlacedLayer& layer,
                         const std::string& what) {
  throw InputError(
      {{"", 0, 0,
        fmt::format("{}: layer \"{}\" {}, but not in the scene itself", who, layer.name, what),
        "no history of the scene goes that way: give the scene a little of it, too"}});
}

/// Light that only an environment emits has no line in the medium.
void check_emitted(const std::string& who, const scene::Scene& scene, const Medium& medium,
                   const std::vector<EmittedLine>& emitted) {
  for (const EmittedLine& e : emitted) {
    if (std::ranges::any_of(medium.line, [&](const Line& line) { return is(e, line); })) continue;
    for (std::size_t k = 0; k < e.coefficient_per_m.size(); ++k) {
      if (e.coefficient_per_m[k] > 0)
        refuse(who, scene::layers_of(scene.sea)[k],
               fmt::format("emits {} light", scene::word_of(e.process)));
    }
  }
}

double emitted_into(const Line& line, std::size_t layer, const std::vector<EmittedLine>& emitted) {
  for (const EmittedLine& e : emitted) {
    if (is(e, line)) return e.coefficient_per_m[layer];
  }
  return 0;
}

LayerCoefficients waters_of(const std::string& who, const scene::Scene& scene,
                            const optics::Library& library, const PhaseNumbers& number_of,
                            const Medium& medium, const std::stop_token& stop) {
  const LayerOptics optics_of(scene, library, stop);
  const auto layers = scene::layers_of(scene.sea);
  std::vector<WaterOptics> at_laser;
  for (const auto& at : layers) at_laser.push_back(optics_of(at.layer, scene.source.wavelength_nm));
  const auto emitted = emitted_light(scene, library, at_laser).lines;
  check_emitted(who, scene, medium, emitted);
  for (std::size_t k = 0; k < at_laser.size(); ++k)
    emitted_per_m(emitted, scene, k, at_laser[k].a_per_m);
  LayerCoefficients out;
  for (const Line& line : medium.line) {
    for (std::size_t k = 0; k < layers.size(); ++k) {
      const scene::Layer& layer = layers[k].layer;
      const WaterOptics water = optics_of(layer, line.wavelength_nm);
      Coefficients w{
          water.a_per_m + water.b_per_m, water.b_per_m, emitted_into(line, k, emitted), {}};
      for (const auto& part : optics_of.scattering(layer, line.wavelength_nm, water))
        w.part.push_back({part.b_per_m, number_of(part.phase)});
      out.push_back(std::move(w));
    }
  }
  return out;
}

std::vector<Variation> variations_of(const scene::Scene& scene, const LayerCoefficients& reference,
                                     const optics::Library& library, const PhaseNumbers& number_of,
                                     const Medium& medium, const std::stop_token& stop) {
  std::vector<Variation> out;
  for (const auto& environment : scene.environment) {
    const std::string name = fmt::format("environment \"{}\"", environment.name);
    out.push_back(
        {name, reference,
         waters_of(name, scene::scene_in(scene, environment), library, number_of, medium, stop)});
  }
  for (const auto& s : scene.sensitivity) {
    const std::string name = fmt::format("sensitivity \"{}\"", s.path);
    const auto waters = [&](const scene::Environment& side) {
      return waters_of(name, scene::scene_in(scene, side), library, number_of, medium, stop);
    };
    out.push_back({name, waters(s.below), waters(s.above), s.value / (2 * s.step)});
  }
  return out;
}

}  // namespace

void add_environments(const scene::Scene& scene, const optics::Library& library,
                      const PhaseNumbers& number_of, Medium& medium, const std::stop_token& stop) {
  if (!scene.has_environments()) return;
  const LayerCoefficients reference = waters_of("", scene, library, number_of, medium, stop);
  const auto variations = variations_of(scene, reference, library, number_of, medium, stop);
  const auto layers = scene::layers_of(scene.sea);
  for (const Variation& v : variations) {
    for (std::size_t i = 0; i < reference.size(); ++i) {
      const Coefficients& here = reference[i];
      const scene::PlacedLayer& layer = layers[i % layers.size()];
      if (here.b_per_m == 0 && v.to[i].b_per_m > 0) refuse(v.name, layer, "scatters light");
      if (here.emitted_per_m == 0 && v.to[i].emitted_per_m > 0)
        refuse(
            v.name, layer,
            fmt::format("emits {} light", scene::word_of(medium.line[i / layers.size()].process)));
    }
  }
  add_variations(reference, variations, scene.environment.size(), medium.environments);
}

void check_environments(const scene::Scene& scene, const optics::Library& library,
                        scene::Findings& findings) {
  const auto known = [](const auto& list, auto sea) {
    return list.empty() || !scene::layers_of(sea(list.front())).empty();
  };
  if (!scene.has_environments() ||
      !known(scene.environment, [](const auto& e) -> auto& { return e.sea; }) ||
      !known(scene.sensitivity, [](const auto& s) -> auto& { return s.above.sea; }))
    return;
  try {
    const Medium medium = build_medium(scene, library, {}, optics::Phases::left_out);
    if (scene.atmosphere && !scene.atmosphere->layer.empty())
      other_airs(scene, library, medium.line);
  } catch (const InputError& error) {
    for (const Diagnostic& d : error.diagnostics())
      findings.add(scene.environment.empty() ? "sensitivity" : "environment", d.reason,
                   d.suggestion);
  }
}

}  // namespace photic::medium
