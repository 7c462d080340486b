#include "medium/environments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "medium/build.hpp"
#include "medium/layer_optics.hpp"
#include "medium/lines.hpp"

namespace photic::medium {
namespace {

/// What light meets in one layer at one line.
struct Water {
  double c_per_m = 0, b_per_m = 0;
  double emitted_per_m = 0;  ///< into this line, of the laser's light
  struct Part {
    double b_per_m = 0;
    std::int32_t phase = 0;  ///< table of the medium
  };
  std::vector<Part> part;  ///< of the scattering
};
using Waters = std::vector<Water>;  ///< [line][layer]

/// Tables of phase functions, each made once: many environments have the same.
class PhaseTables {
 public:
  explicit PhaseTables(Medium& medium) : medium_(medium) {}

  /// Of a part of a layer's scattering at a wavelength.
  std::int32_t number(const scene::Scene& scene, const scene::Layer& layer,
                      const WaterOptics& water, double wavelength_nm, const ScatteringPart& part) {
    Key key{layer.phase_function, water.backscatter_fraction, scene.optics, wavelength_nm, part.of};
    const auto known = std::ranges::find(known_, key, &std::pair<Key, std::int32_t>::first);
    if (known != known_.end()) return known->second;
    known_.emplace_back(std::move(key), medium_.add_phase(optics::PhaseTable(part.phase)));
    return known_.back().second;
  }

 private:
  struct Key {
    std::optional<scene::PhaseFunction> function;
    std::optional<double> backscatter_fraction;
    scene::Optics optics;
    double wavelength_nm;
    Scatterer of;
    friend bool operator==(const Key&, const Key&) = default;
  };
  Medium& medium_;
  std::vector<std::pair<Key, std::int32_t>> known_;
};

bool is(const EmittedLine& emitted, const Line& line) {
  return emitted.process == line.process && emitted.wavelength_nm == line.wavelength_nm;
}

[[noreturn]] void refuse(const std::string& who, const scene::Layer& layer,
                         const std::string& what) {
  throw InputError(
      {{"", 0, 0,
        fmt::format("{}: layer \"{}\" {}, and not in the scene itself", who, layer.name, what),
        "no history of the scene goes that way: give the scene a little of it, too"}});
}

/// Light that only an environment emits has no line in the medium.
void check_emitted(const std::string& who, const scene::Scene& scene, const Medium& medium,
                   const std::vector<EmittedLine>& emitted) {
  for (const EmittedLine& e : emitted) {
    if (std::ranges::any_of(medium.line, [&](const Line& line) { return is(e, line); })) continue;
    for (std::size_t k = 0; k < e.coefficient_per_m.size(); ++k) {
      if (e.coefficient_per_m[k] > 0)
        refuse(who, scene.sea.layer[k], fmt::format("emits {} light", scene::word_of(e.process)));
    }
  }
}

double emitted_into(const Line& line, std::size_t layer, const std::vector<EmittedLine>& emitted) {
  for (const EmittedLine& e : emitted) {
    if (is(e, line)) return e.coefficient_per_m[layer];
  }
  return 0;
}

Waters waters_of(const std::string& who, const scene::Scene& scene, const optics::Library& library,
                 const Medium& medium, PhaseTables& tables) {
  const LayerOptics optics_of(scene, library);
  std::vector<WaterOptics> at_laser;
  for (const auto& layer : scene.sea.layer)
    at_laser.push_back(optics_of(layer, scene.source.wavelength_nm));
  const auto emitted = emitted_light(scene, library, at_laser).lines;
  check_emitted(who, scene, medium, emitted);
  for (std::size_t k = 0; k < at_laser.size(); ++k)
    emitted_per_m(emitted, scene, k, at_laser[k].a_per_m);
  Waters out;
  for (const Line& line : medium.line) {
    for (std::size_t k = 0; k < scene.sea.layer.size(); ++k) {
      const auto& layer = scene.sea.layer[k];
      const WaterOptics water = optics_of(layer, line.wavelength_nm);
      Water w{water.a_per_m + water.b_per_m, water.b_per_m, emitted_into(line, k, emitted), {}};
      for (const auto& part : optics_of.scattering(layer, line.wavelength_nm, water))
        w.part.push_back(
            {part.b_per_m, tables.number(scene, layer, water, line.wavelength_nm, part)});
      out.push_back(std::move(w));
    }
  }
  return out;
}

/// How much of the scattering has a phase function.
double scattered_by(const Water& water, std::int32_t phase) {
  double sum = 0;
  for (const auto& part : water.part) sum += part.phase == phase ? part.b_per_m : 0.0;
  return sum;
}

/// Of an environment, or a tangent: what changes, in units of `scale`.
struct Variation {
  std::string name;  ///< as users know it
  Waters from, to;
  double scale = 1;
};

/// The phase functions that some variation has more or less of.
std::vector<std::int32_t> varied_phases(const std::vector<Variation>& variations,
                                        std::size_t cell) {
  std::vector<std::int32_t> out;
  const auto look_at = [&](const Water& one) {
    for (const auto& part : one.part) {
      const auto differs = [&](const Variation& v) {
        return scattered_by(v.from[cell], part.phase) != scattered_by(v.to[cell], part.phase);
      };
      if (std::ranges::find(out, part.phase) == out.end() &&
          std::ranges::any_of(variations, differs))
        out.push_back(part.phase);
    }
  };
  for (const Variation& v : variations) {
    look_at(v.from[cell]);
    look_at(v.to[cell]);
  }
  return out;
}

std::vector<Variation> variations_of(const scene::Scene& scene, const Waters& reference,
                                     const optics::Library& library, const Medium& medium,
                                     PhaseTables& tables) {
  std::vector<Variation> out;
  for (const auto& environment : scene.environment) {
    const std::string name = fmt::format("environment \"{}\"", environment.name);
    out.push_back({name, reference,
                   waters_of(name, scene::scene_in(scene, environment), library, medium, tables)});
  }
  for (const auto& s : scene.sensitivity) {
    const std::string name = fmt::format("sensitivity \"{}\"", s.path);
    const auto waters = [&](const scene::Environment& side) {
      return waters_of(name, scene::scene_in(scene, side), library, medium, tables);
    };
    out.push_back({name, waters(s.below), waters(s.above), s.value / (2 * s.step)});
  }
  return out;
}

/// Adds a variation's numbers of a cell, where there is `here` in the medium.
void add_numbers(const Variation& v, const Water& here, std::size_t cell,
                 const std::vector<std::int32_t>& phases, EnvironmentTables& out) {
  const Water& from = v.from[cell];
  const Water& to = v.to[cell];
  out.excess_c.push_back(v.scale * (to.c_per_m - from.c_per_m));
  out.excess_emitted.push_back(here.emitted_per_m > 0
                                   ? v.scale * (to.emitted_per_m - from.emitted_per_m) /
                                         here.emitted_per_m
                                   : 0.0);
  for (std::size_t p = 0; p < static_cast<std::size_t>(out.parts); ++p) {
    const bool counts = p < phases.size() && here.b_per_m > 0;
    out.excess_part.push_back(
        counts
            ? v.scale * (scattered_by(to, phases[p]) - scattered_by(from, phases[p])) / here.b_per_m
            : 0.0);
  }
}

}  // namespace

void add_environments(const scene::Scene& scene, const optics::Library& library, Medium& medium) {
  if (!scene.compares()) return;
  PhaseTables tables(medium);
  const Waters reference = waters_of("", scene, library, medium, tables);
  const auto variations = variations_of(scene, reference, library, medium, tables);
  const std::size_t layers = scene.sea.layer.size();
  const std::size_t cells = reference.size();
  std::vector<std::vector<std::int32_t>> varied;
  for (std::size_t i = 0; i < cells; ++i) varied.push_back(varied_phases(variations, i));
  EnvironmentTables& out = medium.environments;
  out.count = static_cast<std::int32_t>(variations.size());
  out.first_tangent = static_cast<std::int32_t>(scene.environment.size());
  for (const auto& phases : varied)
    out.parts = std::max(out.parts, static_cast<std::int32_t>(phases.size()));
  for (const auto& phases : varied) {
    for (std::size_t p = 0; p < static_cast<std::size_t>(out.parts); ++p)
      out.part_phase.push_back(p < phases.size() ? phases[p] : 0);
  }
  for (const Variation& v : variations) {
    for (std::size_t i = 0; i < cells; ++i) {
      const Water& here = reference[i];
      const scene::Layer& layer = scene.sea.layer[i % layers];
      if (here.b_per_m == 0 && v.to[i].b_per_m > 0) refuse(v.name, layer, "scatters light");
      if (here.emitted_per_m == 0 && v.to[i].emitted_per_m > 0)
        refuse(v.name, layer,
               fmt::format("emits {} light", scene::word_of(medium.line[i / layers].process)));
      add_numbers(v, here, i, varied[i], out);
    }
  }
}

void check_environments(const scene::Scene& scene, const optics::Library& library,
                        scene::Findings& findings) {
  const auto known = [](const auto& list, auto sea) {
    return list.empty() || !sea(list.front()).layer.empty();
  };
  if (!scene.compares() ||
      !known(scene.environment, [](const auto& e) -> auto& { return e.sea; }) ||
      !known(scene.sensitivity, [](const auto& s) -> auto& { return s.above.sea; }))
    return;
  try {
    build_medium(scene, library);
  } catch (const InputError& error) {
    for (const Diagnostic& d : error.diagnostics())
      findings.add(scene.environment.empty() ? "sensitivity" : "environment", d.reason,
                   d.suggestion);
  }
}

}  // namespace photic::medium
