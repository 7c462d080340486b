#include "medium/check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

#include "core/error.hpp"
#include "medium/air_profile.hpp"
#include "medium/film.hpp"
#include "medium/layer_optics.hpp"
#include "medium/lines.hpp"
#include "medium/surface.hpp"
#include "scene/bed_albedo.hpp"

namespace photic::medium {
namespace {

using scene::below;

/// A wavelength that light has: where the scene asks for it, and why, as stated there or elsewhere.
struct Wavelength {
  double nm;
  std::string path, why_here, why_there;
};

class Checker {
 public:
  Checker(const scene::Scene& scene, const optics::Library& library, scene::Findings& findings)
      : scene_(scene),
        layers_(scene::layers_of(scene_.sea)),
        library_(library),
        findings_(findings),
        optics_of_(scene_, library) {
    drop_bad_channels();
    for (const auto& at : layers_) readable_.push_back(findings.good({below(at.path, "iop")}));
    for (const auto& bed : scene::beds_of(scene_.sea, scene_.bottom))
      beds_readable_ &= findings.good({bed.path});
    surface_readable_ = findings.good({"sea.surface"});
    if (scene_.oil && findings.good({"oil"}))
      if (const auto oil = ask(oil_path(), [&] { return oil_of(scene_, library_); })) oil_ = *oil;
    if (oil_) remark_placeholders();
    if (scene_.atmosphere && scene_.atmosphere->layer.empty()) read_air();
  }

  void check_tables();
  void check_light();
  /// The highest albedo for the laser's light in any layer, once that is checked.
  [[nodiscard]] double highest_albedo() const { return highest_albedo_; }

 private:
  void drop_bad_channels();
  void check_phase_function(const scene::PhaseFunction& function, const std::string& path);
  void check_spheres(const scene::PhaseFunction& function, const std::string& path,
                     const Wavelength& light);
  void check_inelastic_light(const std::vector<std::optional<WaterOptics>>& at_laser);
  void check_index(Process process, const Wavelength& light);
  void check_beds(const Wavelength& light);
  void check_whitecaps(const Wavelength& light);
  void read_air();
  void check_air(const Wavelength& light);
  void check_air_layers(const Wavelength& light);
  void check_film(const Wavelength& light);
  void remark_placeholders();
  /// The key that says which oil it is.
  [[nodiscard]] std::string oil_path() const {
    return below("oil", scene_.oil->of_class ? "class" : "file");
  }
  std::vector<std::optional<WaterOptics>> check_layers(const Wavelength& light);
  std::optional<WaterOptics> check_layer(std::size_t k, const Wavelength& light);
  [[nodiscard]] Wavelength asked_by_channel(const EmittedLine& line) const;
  void remark_dark_channels(const std::vector<EmittedLine>& lines);

  /// Returns the result of an action; none if it refuses, which is reported at `path`.
  template <class Action>
  auto ask(const std::string& path, const Action& action, const std::string& why = "")
      -> std::optional<decltype(action())> {
    try {
      return action();
    } catch (const InputError& error) {
      for (const Diagnostic& d : error.diagnostics()) report(path, d, why);
      return std::nullopt;
    }
  }
  void report(const std::string& path, const Diagnostic& d, const std::string& why);

  scene::Scene scene_;  ///< without the channels that are bad
  std::vector<scene::PlacedLayer> layers_;
  std::vector<std::string> channel_path_;
  std::vector<bool> readable_;  ///< the layers whose optics can be asked for
  bool beds_readable_ = true, surface_readable_ = false;
  /// The profile of the air up to its top, if there is one and nothing is wrong with it.
  std::optional<optics::AirProfile> air_profile_;
  std::optional<optics::Oil> oil_;  ///< if there is a film, and it is known
  const optics::Library& library_;
  scene::Findings& findings_;
  LayerOptics optics_of_;
  std::set<std::string> reported_;
  double highest_albedo_ = 0;
};

/// A problem of a line of another file keeps its place. Several layers may have the same problem.
void Checker::report(const std::string& path, const Diagnostic& d, const std::string& why) {
  const bool elsewhere = d.line > 0;
  const bool named = elsewhere || d.file.empty() || d.file == findings_.place_of(path).file;
  const std::string reason =
      (named ? "" : d.file + " ") + d.reason + (why.empty() ? "" : "; " + why);
  if (!reported_.insert((elsewhere ? d.text() : path) + reason).second) return;
  if (elsewhere)
    findings_.add(path, {d.file, d.line, d.column}, reason, d.suggestion);
  else
    findings_.add(path, reason, d.suggestion);
}

void Checker::drop_bad_channels() {
  std::vector<scene::Channel> good;
  for (std::size_t i = 0; i < scene_.channel.size(); ++i) {
    const scene::Channel& channel = scene_.channel[i];
    const std::string path = below("channel", i);
    const bool whole =
        channel.process || channel.transmission || (channel.centre_nm && channel.fwhm_nm);
    if (!whole || !findings_.good({path})) continue;
    const std::string key = below(path, channel.process     ? "process"
                                        : channel.centre_nm ? "centre_nm"
                                                            : "transmission_file");
    if (!ask(key, [&] { return filter_of(channel).has_value() || channel.process; })) continue;
    good.push_back(channel);
    channel_path_.push_back(key);
  }
  scene_.channel = std::move(good);
}

void Checker::check_phase_function(const scene::PhaseFunction& function, const std::string& path) {
  for (std::size_t i = 0; i < function.components.size(); ++i)
    check_phase_function(function.components[i], below(below(path, "components"), i));
  if (!function.components.empty() || !findings_.good({path})) return;
  if (function.model == scene::PhaseModel::table) {
    const std::string file = below(path, "file");
    const auto table = ask(file, [&] { return optics::phase_from_table(function.table.data()); });
    if (table && !table->remark.empty()) findings_.remark(file, table->remark);
  } else if (function.model != scene::PhaseModel::mie) {
    ask(path, [&] { return optics_of_.shape(function, scene_.source.wavelength_nm); });
  }
}

/// The one model that depends on the wavelength; what its index lacks has been reported.
void Checker::check_spheres(const scene::PhaseFunction& function, const std::string& path,
                            const Wavelength& light) {
  for (std::size_t i = 0; i < function.components.size(); ++i)
    check_spheres(function.components[i], below(below(path, "components"), i), light);
  if (function.model != scene::PhaseModel::mie || !findings_.good({path})) return;
  const auto index = [&] { return refractive_index(scene_.sea, light.nm); };
  if (!ask(light.path, index, light.why_here)) return;
  ask(
      path, [&] { return optics_of_.shape(function, light.nm); },
      fmt::format("at {:.6g} nm: {}", light.nm, light.why_there));
}

void Checker::check_tables() {
  const std::string path = "optics.phytoplankton_file";
  if (scene_.optics.phytoplankton == "table" && findings_.good({"optics.phytoplankton", path}))
    ask(path,
        [&] { return optics::phytoplankton_table(scene_.optics.phytoplankton_table.data()); });
  for (const auto& at : layers_)
    if (at->phase_function)
      check_phase_function(*at->phase_function, below(at.path, "phase_function"));
  if (!scene_.atmosphere) return;
  for (std::size_t k = 0; k < scene_.atmosphere->layer.size(); ++k)
    if (const auto& function = scene_.atmosphere->layer[k].phase_function)
      check_phase_function(*function, below(below("atmosphere.layer", k), "phase_function"));
}

void Checker::check_index(Process process, const Wavelength& light) {
  if (findings_.good({"sea.refractive_index", "sea.group_index"}))
    ask(
        light.path, [&] { return make_line(scene_.sea, process, light.nm); }, light.why_here);
}

/// Checks that their albedo is known, and no environment's reflects where the scene's does not.
void Checker::check_beds(const Wavelength& light) {
  for (const auto& [bed, path] : scene::beds_of(scene_.sea, scene_.bottom)) {
    const auto known = [&] { return !bed || albedo_of(*bed, light.nm, 0) >= 0; };
    if (!beds_readable_ || !ask(path + ".albedo", known, light.why_there)) return;
  }
  for (std::size_t i = 0; i < scene_.environment.size(); ++i) {
    const std::string set = below(below("environment", i), "set");
    const auto lit = [&] { return angle_lit_there_alone(scene_.environment[i], scene_, light.nm); };
    const auto deg = ask(set, lit, light.why_there);
    if (!deg || !*deg || !reported_.insert("bed of " + set).second) continue;
    const auto& changes = scene_.environment[i].set;
    const auto change = std::ranges::find_if(
        changes, [](const auto& c) { return c.path.find("bottom.") != std::string::npos; });
    findings_.add(set, findings_.place_in(set, change == changes.end() ? "" : change->path),
                  fmt::format("in environment {}: the sea bed reflects light of {:.6g} nm and a "
                              "zenith angle of {:g} degrees, but not in the scene itself",
                              scene::quoted(scene_.environment[i].name), light.nm, **deg),
                  "no history of the scene goes that way: give its bed a little albedo, too");
  }
}

void Checker::check_whitecaps(const Wavelength& light) {
  const scene::Surface& surface = scene_.sea.surface;
  if (!surface_readable_ || whitecap_fraction_of(surface).value == 0) return;
  ask(
      "sea.surface.whitecap_reflectance",
      [&] { return whitecap_reflectance_of(surface, library_, light.nm); }, light.why_there);
}

/// Remarks on the properties that are still placeholders.
void Checker::remark_placeholders() {
  std::vector<std::string> items;
  for (const auto& property : oil_->properties)
    if (property.source.ends_with("[placeholder]")) items.push_back(property.item);
  if (!items.empty())
    findings_.remark(oil_path(), fmt::format("for the oil \"{}\" these are placeholders, not data: "
                                             "{}; give your own oil as file = \"….csv\"",
                                             oil_->name, fmt::join(items, ", ")));
}

/// Reads the air, and reports what is wrong with it at any wavelength.
void Checker::read_air() {
  const std::string profile = "atmosphere.profile", aerosol = "atmosphere.aerosol";
  if (!findings_.good({"atmosphere"})) return;
  const scene::Atmosphere& air = *scene_.atmosphere;
  const optics::AirLibrary& library = library_.air();
  constexpr double known_nm = 550, any_humidity = 0;  // of all aerosols
  const bool known = !air.has_aerosols() || ask(aerosol, [&] {
    return optics::aerosol_optics(library, air.aerosol, known_nm, any_humidity,
                                  optics::Phases::left_out)
        .g;
  });
  const auto whole = ask(profile, [&] { return whole_profile(air, library); });
  if (!whole) return;
  for (const std::string& doubt : doubts_about_levels(air)) findings_.remark(profile, doubt);
  const auto to_top = ask("atmosphere.top_km", [&] { return profile_to_top(air, *whole); });
  if (!to_top) return;
  const auto deep =
      ask("atmosphere.aerosol_optical_depth_550", [&] { return as_deep_as_given(air, *to_top); });
  if (known) air_profile_ = deep;
}

/// The problems of layers are reported at the layer, with a profile of the wavelength.
void Checker::check_air(const Wavelength& light) {
  if (!scene_.atmosphere) return;
  if (!scene_.atmosphere->layer.empty()) return check_air_layers(light);
  if (!air_profile_) return;
  if (findings_.good({"atmosphere.gases"}))
    ask(
        "atmosphere.gases", [&] { return gas_depths(*scene_.atmosphere, light.nm).size(); },
        light.why_there);
  const auto known = [&] {
    const auto aerosols = aerosols_of(*scene_.atmosphere);
    return optics::air_at(library_.air(), *air_profile_, aerosols, light.nm,
                          optics::Phases::left_out)
        .depolarisation;
  };
  ask(light.path, known, light.why_here);
}

void Checker::check_air_layers(const Wavelength& light) {
  for (std::size_t k = 0; k < scene_.atmosphere->layer.size(); ++k) {
    const scene::AirLayer& layer = scene_.atmosphere->layer[k];
    const std::string iop = below(below("atmosphere.layer", k), "iop");
    if (findings_.good({iop}))
      ask(
          iop, [&] { return optics_of_(as_layer(layer), light.nm); }, light.why_there);
  }
}

void Checker::check_film(const Wavelength& light) {
  if (!oil_) return;
  const auto known = [&] {
    return oil_->refractive_index(light.nm) + oil_->absorption_per_m(light.nm);
  };
  ask(oil_path(), known, light.why_there);
}

std::optional<WaterOptics> Checker::check_layer(std::size_t k, const Wavelength& light) {
  const scene::Layer& layer = layers_[k].layer;
  const auto all = [&] { return optics_of_(layer, light.nm); };
  if (layer.phase_function)
    check_spheres(*layer.phase_function, below(layers_[k].path, "phase_function"), light);
  if (!readable_[k]) return std::nullopt;
  if (!layer.iop.empty()) return ask(below(layers_[k].path, "iop"), all, light.why_there);
  const std::string type = below(layers_[k].path, "jerlov");
  if (!layer.jerlov.empty() && findings_.good({type})) return ask(type, all, light.why_there);
  if (!findings_.good({type, "optics.set", "optics.water_absorption", "optics.water_scattering",
                       "optics.phytoplankton", "optics.phytoplankton_file", "optics.minerals",
                       "sea.salinity_psu", "sea.temperature_c"}))
    return std::nullopt;
  bool good = true;
  const auto ask_for = [&](const auto& part) {
    good = ask(light.path, part, light.why_here).has_value() && good;
  };
  ask_for([&] { return optics_of_.water_absorption(layer, light.nm); });
  ask_for([&] { return optics_of_.water_scattering(layer, light.nm); });
  ask_for([&] { return optics_of_.phytoplankton(layer, light.nm); });
  ask_for([&] { return optics_of_.minerals(layer, light.nm); });
  return good ? ask(layers_[k].path, all, light.why_there) : std::nullopt;
}

std::vector<std::optional<WaterOptics>> Checker::check_layers(const Wavelength& light) {
  std::vector<std::optional<WaterOptics>> out;
  for (std::size_t k = 0; k < layers_.size(); ++k) out.push_back(check_layer(k, light));
  return out;
}

Wavelength Checker::asked_by_channel(const EmittedLine& line) const {
  const auto counts = std::ranges::find_if(line.counted_by, [](double share) { return share > 0; });
  expect(counts != line.counted_by.end(), "a line is emitted because a channel counts it");
  const auto i = static_cast<std::size_t>(counts - line.counted_by.begin());
  const auto why = fmt::format("channel {} counts {} light there",
                               scene::quoted(scene_.channel[i].name), scene::word_of(line.process));
  return {line.wavelength_nm, channel_path_[i], why, why};
}

void Checker::remark_dark_channels(const std::vector<EmittedLine>& lines) {
  for (std::size_t i = 0; i < scene_.channel.size(); ++i) {
    const auto& process = scene_.channel[i].process;
    if (!process || *process == Process::elastic) continue;
    if (*process == Process::oil && scene_.oil) continue;  // a film of 0 um is no oversight
    bool emitted = false;
    for (const EmittedLine& line : lines) emitted |= *process == line.process;
    if (!emitted)
      findings_.remark(
          channel_path_[i],
          fmt::format("channel {} will count nothing: {} emits {} light",
                      scene::quoted(scene_.channel[i].name),
                      *process == Process::oil ? "no film" : "no layer", scene::word_of(*process)));
  }
}

void Checker::check_inelastic_light(const std::vector<std::optional<WaterOptics>>& at_laser) {
  std::vector<WaterOptics> known;
  bool complete = true;
  for (const auto& water : at_laser) {
    known.push_back(water.value_or(WaterOptics{}));
    complete = complete && water;
  }
  const std::string table = "optics.cdom_fluorescence_file";
  if (scene_.optics.cdom_fluorescence == scene::CdomFluorescence::table &&
      findings_.good({table}) && !ask(table, [&] { return cdom_emission(scene_, library_); }))
    return;
  auto light = ask("channel", [&] { return emitted_light(scene_, library_, known); });
  if (!light) return;
  if (oil_) {
    const auto lines = ask("channel", [&] { return oil_lines(scene_, *oil_); });
    if (lines) light->lines.insert(light->lines.end(), lines->begin(), lines->end());
  }
  std::optional<Process> reported;  // of a process's light one wavelength is enough
  for (const EmittedLine& line : light->lines) {
    if (reported == line.process) continue;
    const std::size_t before = reported_.size();
    const Wavelength asked = asked_by_channel(line);
    check_index(line.process, asked);
    check_beds(asked);
    check_whitecaps(asked);
    check_film(asked);
    check_air(asked);
    check_layers(asked);
    if (reported_.size() > before) reported = line.process;
  }
  for (std::size_t k = 0; k < at_laser.size(); ++k) {
    const std::string yield = below(layers_[k].path, "chlorophyll_yield");
    if (at_laser[k] && findings_.good({yield}))
      ask(layers_[k]->iop.empty() ? yield : below(layers_[k].path, "iop"),
          [&] { return emitted_per_m(light->lines, scene_, k, at_laser[k]->a_per_m); });
  }
  if (complete) remark_dark_channels(light->lines);
}

void Checker::check_light() {
  const std::string path = "source.wavelength_nm";
  if (!findings_.good({path}) || layers_.empty()) return;
  const Wavelength laser{scene_.source.wavelength_nm, path, "", "the source emits there"};
  check_index(Process::elastic, laser);
  check_beds(laser);
  check_whitecaps(laser);
  check_film(laser);
  check_air(laser);
  const auto at_laser = check_layers(laser);
  for (const auto& water : at_laser)
    if (water) highest_albedo_ = std::max(highest_albedo_, water->albedo());
  // A laser's wavelength that is of no use does not settle the inelastic light either.
  if (findings_.good({path, "optics"})) check_inelastic_light(at_laser);
}

}  // namespace

double check_medium(const scene::Scene& scene, const optics::Library& library,
                    scene::Findings& findings) {
  Checker checker(scene, library, findings);
  checker.check_tables();
  checker.check_light();
  return checker.highest_albedo();
}

}  // namespace photic::medium
