#include "estimator/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <tuple>
#include <utility>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/stop.hpp"
#include "estimator/focus.hpp"
#include "estimator/nested_views.hpp"
#include "estimator/origin.hpp"
#include "estimator/random_blocks.hpp"
#include "estimator/round_earth.hpp"
#include "estimator/strategies.hpp"
#include "estimator/tallies/grids.hpp"
#include "estimator/unused_settings.hpp"
#include "estimator/walk_attenuation.hpp"
#include "estimator/walk_cones.hpp"
#include "medium/air_alone.hpp"
#include "medium/build.hpp"
#include "medium/check.hpp"
#include "medium/environments.hpp"
#include "medium/film.hpp"
#include "medium/outside_column.hpp"
#include "medium/upside_down.hpp"
#include "scene/environment_values.hpp"
#include "scene/forward_settings.hpp"
#include "scene/tally_memory.hpp"
#include "scene/walk_settings.hpp"
#include "transport/touched.hpp"

namespace photic::estimator {
namespace {

constexpr std::uint64_t max_batch_photons_of_walks = 2000;
constexpr std::uint64_t enough_batches = 40;  // to know errors by their scatter

/// The process of a line's light that has touched something.
std::string process_of(const medium::Line& line, transport::Touched touched) {
  if (line.process == medium::Process::elastic) {
    if (touched == transport::Touched::bed) return "bottom";
    if (touched == transport::Touched::surface) return "surface";
    if (touched == transport::Touched::air) return "air";
  }
  return std::string(scene::word_of(line.process));
}

/// The places that light touches in a medium under air.
std::vector<transport::Touched> touched_in(const medium::Medium& medium, bool air) {
  std::vector<transport::Touched> out{transport::Touched::water};
  if (!medium.bed_albedo.empty()) out.push_back(transport::Touched::bed);
  if (!medium.waves.slopes.is_flat()) out.push_back(transport::Touched::surface);
  if (air) out.push_back(transport::Touched::air);
  return out;
}

/// The processes of all light, in the order of medium::Process, each once.
std::vector<std::string> processes_in(const medium::Medium& medium, bool air) {
  auto lines = medium.line;
  std::ranges::stable_sort(lines, {}, &medium::Line::process);
  std::vector<std::string> out;
  for (const auto& line : lines)
    for (const auto touched : touched_in(medium, air)) out.push_back(process_of(line, touched));
  out.erase(std::ranges::unique(out).begin(), out.end());
  return out;
}

tally::Shape make_shape(const scene::Scene& scene, const medium::Medium& medium,
                        const std::optional<medium::Air>& air, const tally::Gates& gates) {
  tally::Shape shape;
  const auto processes = processes_in(medium, air.has_value());
  shape.grids = tally::echo_grids(static_cast<std::size_t>(scene.simulation.orders_kept) + 1,
                                  processes, gates.depth_edges(scene.gates.depth_cells));
  for (const std::string& process : processes)
    shape.grid("echo_by_process")
        .beside_walks.push_back(process == "surface" ||
                                process == scene::word_of(medium::Process::oil));
  shape.telescopes = scene.telescope.size();
  shape.channels = scene.channel.size();
  shape.gates = static_cast<std::size_t>(gates.count());
  shape.max_order = static_cast<std::int32_t>(scene.simulation.max_order.value_or(0));
  shape.tallies = tally_grids(scene, medium, air);
  if (scene.simulation.estimator == scene::Estimator::bidirectional)
    shape.techniques = tally::kinds_of_technique;
  shape.keeps_groups = scene::keeps_groups(scene);
  shape.tangents = scene.sensitivity.size();
  shape.environments = scene.environment.size() + shape.tangents;
  shape.wider.resize(shape.telescopes);
  for (const NestedViews& views : nested_views(scene))
    for (std::size_t i = 1; i < views.size(); ++i) shape.wider[views[i - 1]] = views[i];
  for (const auto& line : medium.line) {
    std::vector<tally::Counting> counted_by;
    for (std::size_t c = 0; c < line.counted_by.size(); ++c) {
      if (line.counted_by[c] > 0)
        counted_by.push_back({static_cast<std::int32_t>(c), line.counted_by[c]});
    }
    shape.channels_of_line.push_back(std::move(counted_by));
  }
  const auto last_touched = static_cast<std::int32_t>(touched_in(medium, air.has_value()).back());
  for (std::int32_t touched = 0; touched <= last_touched; ++touched)
    for (const auto& line : medium.line) {
      const auto at =
          std::ranges::find(processes, process_of(line, static_cast<transport::Touched>(touched)));
      shape.process_of_light.push_back(  // no light touches a black bed
          at == processes.end() ? 0 : static_cast<std::int32_t>(at - processes.begin()));
    }
  if (std::ranges::any_of(medium.line, [](const auto& line) { return line.lifetime_ns > 0; }))
    for (const auto& line : medium.line) shape.decay_of_line.emplace_back(line.lifetime_ns, gates);
  return shape;
}

/// The light channel number c stands for: the mean over the lines it counts, else the laser's or
/// its filter's centre.
medium::Line channel_line(const scene::Channel& channel, std::size_t c,
                          const std::vector<medium::Line>& lines) {
  medium::Line mean = lines.front();
  double all = 0;
  double wavelength = 0;
  double refractive_index = 0, group_index = 0;
  std::vector<double> delay_m(mean.air_delay.delay_m.size());
  for (const auto& line : lines) {
    const double counted = line.photons * line.counted_by[c];
    all += counted;
    wavelength += counted * line.wavelength_nm;
    refractive_index += counted * line.refractive_index;
    group_index += counted * line.group_index;
    for (std::size_t i = 0; i < delay_m.size(); ++i)
      delay_m[i] += counted * line.air_delay.delay_m[i];
  }
  if (all > 0) {
    mean.wavelength_nm = wavelength / all;
    mean.refractive_index = refractive_index / all;
    mean.group_index = group_index / all;
    for (std::size_t i = 0; i < delay_m.size(); ++i) mean.air_delay.delay_m[i] = delay_m[i] / all;
  } else if (channel.centre_nm) {
    mean.wavelength_nm = *channel.centre_nm;
  }
  return mean;
}

/// The values of an environment that its name does not state: "sea.layer.0.chlorophyll_mg_m3 = 2".
std::string unnamed_values(const scene::Environment& environment) {
  std::string out;
  for (const auto& [path, value] : environment.set) {
    const std::string key = path.substr(path.find_last_of('.') + 1);
    if (environment.name.find(fmt::format("{} = {}", key, value)) != std::string::npos) continue;
    out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", path, value);
  }
  return out;
}

}  // namespace

std::uint64_t batch_photons(const scene::Simulation& simulation) {
  if (simulation.batch_photons) return *simulation.batch_photons;
  std::uint64_t photons = simulation.estimator == scene::Estimator::bidirectional
                              ? max_batch_photons_of_walks
                              : scene::max_batch_photons;
  if (!simulation.photons) return photons;
  while (photons > scene::min_batch_photons && *simulation.photons / photons < enough_batches)
    photons /= 2;
  return photons;
}

scene::Check optics_check(std::shared_ptr<const optics::Library> library) {
  return [library = std::move(library)](const scene::Scene& scene, scene::Findings& findings,
                                        scene::Asked asked) {
    check_walk_attenuation(scene, medium::check_medium(scene, *library, findings), findings);
    medium::check_environments(scene, *library, findings);
    check_focus(scene, findings);
    if (!scene.is_of_spherical_air()) check_round_earth(scene, findings);
    // Environments have the settings of the scene.
    if (asked == scene::Asked::of_scene) check_unused_settings(scene, *library, findings);
  };
}

namespace {

/// Walks of each telescope and process draw random numbers of their own.
void check_instruments(const scene::Scene& scene, const medium::Medium& medium) {
  std::size_t processes = 0;
  for (std::size_t l = 0; l < medium.line.size(); ++l)
    processes += l == 0 || medium.line[l].process != medium.line[l - 1].process ? 1 : 0;
  const std::size_t views = nested_views(scene).size();
  if (views * processes < max_instruments) return;
  throw InputError({{.file = {},
                     .reason = fmt::format("telescopes (those inside each other count once) times "
                                           "processes are {}; random numbers are kept for {}",
                                           views * processes, max_instruments - 1),
                     .suggestion = "run some of the telescopes in a scene of their own"}});
}

/// Names the settings of an estimator that a scene leaves open, and leaves out those that it does
/// not use.
void name_settings(const scene::Scene& scene, const medium::Medium& medium,
                   scene::Scene& effective) {
  scene::Simulation& s = effective.simulation;
  if (s.estimator == scene::Estimator::automatic) return;
  const auto name = [](auto& setting, auto usual) { setting = setting.value_or(usual); };
  s.batch_photons = batch_photons(scene.simulation);
  if (s.estimator != scene::Estimator::analog)
    name(s.conversion_probability, scene::usual_conversion_probability);
  if (s.estimator == scene::Estimator::bidirectional) {
    s.walk_attenuation = walk_attenuation_in(medium, scene.simulation);
    name(s.walks, scene::usual_walks);
    name(s.meetings, scene::usual_meetings);
    name(s.connected_fraction, scene::usual_connected_fraction);
  }
  if (s.estimator == scene::Estimator::forward) {
    s.directed_fraction = scene::directed_fraction_in(scene);
    s.scored_points = scene::scored_points_in(scene);
  }
  s = without_unused_settings(effective, medium);
}

/// A height above all that scatters, and all that is tallied [m].
double above_all(const scene::Scene& scene, const std::optional<medium::Air>& air) {
  double highest = air ? air->height_m.back() : 0;
  for (const scene::Tally& tally : scene.tally)
    for (const double height : tally.height_m) highest = std::max(highest, height);
  constexpr double ample_m = 1;
  return highest + ample_m;
}

/// Has a beam without a place light all of a planet and its air: it passes a disc about the centre.
void light_planet(const medium::ShellsView& shells, scene::Source& source) {
  const double radius = shells.planet_m + shells.top_m();
  source.position_m = {0, 0, -radius};
  source.diameter_m = 2 * radius;
}

/// The optical depths of the levels of a radiance in the source's light, from the surface.
std::vector<double> radiance_depths(const Model& model) {
  std::vector<double> out;
  const auto sea = model.medium.view();
  for (const scene::Tally& tally : model.scene.tally) {
    if (tally.kind != scene::TallyKind::radiance) continue;
    for (const TallyLevel& level : levels_of(tally)) {
      const double distance = model.from_surface(level);
      if (level.in_air && !model.is_air_alone())
        out.push_back(model.air ? medium::column_to(*model.air, distance).optical_depth.front()
                                : 0);
      else
        out.push_back(sea.optical_depth<double>(
            0, sea.level<double>(model.medium.layer_at(distance), distance)));
    }
  }
  return out;
}

/// Fills in what depends on the simulation of a scene; the medium does not.
void settle(const scene::Scene& scene, Model& model, const std::stop_token& stop) {
  model.shape = make_shape(scene, model.medium, model.air, model.gates);
  name_settings(scene, model.medium, model.scene);
  model.paths = free_paths(model.medium, scene.simulation);
  model.averaged = averaged_phases(scene, model.medium, stop);
}

}  // namespace

Model make_model(const scene::Scene& scene, const optics::Library& library,
                 const std::stop_token& stop) {
  const bool air_alone = scene.is_of_air_alone();
  auto medium = air_alone ? medium::build_air_alone(scene, library, stop)
                          : medium::build_medium(scene, library, stop);
  check_instruments(scene, medium);
  auto air = air_alone ? std::nullopt : medium::build_air(scene, library, medium.line, stop);
  scene::Scene effective = scene;
  if (air_alone) effective.source.position_m.z -= medium.top.back();
  if (scene.source.is_everywhere && scene.is_of_spherical_air())
    light_planet(medium.view().shells, effective.source);
  else if (scene.source.is_everywhere)
    effective.source.position_m.z = above_all(scene, air);
  auto columns = air ? columns_to(*air, heights_of(effective)) : std::vector<ColumnTables>{};
  auto others = air && scene.has_environments()
                    ? medium::other_airs(scene, library, medium.line, stop)
                    : std::vector<medium::OtherAir>{};
  if (!others.empty()) {
    medium.environments.excess_outside = medium::excess_depths(others, heights_of(effective));
    medium.finish();
  }
  for (std::size_t l = 0; air && l < medium.line.size(); ++l)
    medium.line[l].air_delay = medium::delay_of(*air, l);
  geometry::ApparentPath apparent_path;
  if (air && scene.atmosphere->refraction) {
    apparent_path = put_where_they_seem(*air, effective);
    medium::count_against_vacuum(*air, medium);
  }
  tally::Gates gates(effective, medium.line, apparent_path);
  Model model{std::move(effective),
              std::move(medium),
              {},
              std::move(gates),
              {},
              {},
              std::move(air),
              std::move(columns),
              std::move(others),
              std::move(apparent_path),
              {scene.source, scene.telescope},
              {}};
  const auto origin = origin_of(model.scene.source, model.medium.kind);
  model.medium.set_origin(origin.x, origin.y);
  model.level_depth = radiance_depths(model);
  settle(scene, model, stop);
  return model;
}

scene::Scene reported_scene(const Model& model) {
  scene::Scene scene = model.scene;
  scene.source = model.as_given.source;
  scene.telescope = model.as_given.telescope;
  return scene;
}

Model with_simulation(Model model, const scene::Simulation& simulation,
                      const std::stop_token& stop) {
  scene::Scene scene = reported_scene(model);
  scene.simulation = model.scene.simulation = simulation;
  settle(scene, model, stop);
  return model;
}

Model simulated_by(const Model& model, const scene::Simulation& simulation,
                   const std::stop_token& stop) {
  break_off_if(stop);
  Model out = model;
  out.scene.simulation = simulation;
  out.paths = free_paths(out.medium, simulation);
  out.averaged = averaged_phases(out.scene, out.medium, stop);
  return out;
}

tally::Result describe(const Model& model) {
  const scene::Scene& scene = model.scene;
  const auto& [medium, gates, shape, air] =
      std::tie(model.medium, model.gates, model.shape, model.air);
  tally::Result result;
  for (const auto& t : scene.telescope) result.telescope_name.push_back(t.name);
  for (const auto& e : scene.environment) {
    result.environment_name.push_back(e.name);
    result.environment_changes.push_back(unnamed_values(e));
  }
  auto numbers = scene::environment_values(scene);
  result.environment_path = std::move(numbers.path);
  result.environment_value = std::move(numbers.value);
  for (const auto& s : scene.sensitivity) {
    result.parameter_name.push_back(s.path);
    result.parameter_value.push_back(s.value);
  }
  result.gate_depth_is_range = gates.depth_is_range();
  for (std::int32_t edge = 0; edge <= gates.count(); ++edge) {
    result.gate_time_edge_ns.push_back(gates.edge_time_ns(edge));
  }
  for (std::size_t c = 0; c < scene.channel.size(); ++c) {
    const auto line = channel_line(scene.channel[c], c, medium.line);
    result.channel_name.push_back(scene.channel[c].name);
    result.channel_wavelength_nm.push_back(line.wavelength_nm);
  }
  for (std::size_t t = 0; t < scene.telescope.size(); ++t) {
    for (std::size_t c = 0; c < scene.channel.size(); ++c) {
      const auto line = channel_line(scene.channel[c], c, medium.line);
      for (std::int32_t edge = 0; edge <= gates.count(); ++edge)
        result.gate_depth_edge_m.push_back(gates.edge_depth(edge, t, line));
    }
  }
  if (medium.film.exists)
    for (std::size_t t = 0; t < scene.telescope.size(); ++t)
      for (std::size_t c = 0; c < scene.channel.size(); ++c) {
        const auto ways = medium::film_both_ways(scene, medium, t, c);
        result.film_attenuation_per_m.push_back(ways.attenuation_per_m);
        result.film_interface_ratio.push_back(ways.interface_ratio);
      }
  if (const auto strength = strength_of(scene.source)) {
    result.source_strength = strength->value;
    result.source_strength_units = strength->units;
  }
  result.title = scene.title;
  result.scene_toml = scene::write_scene(reported_scene(model));
  result.estimator = scene::word_of(scene.simulation.estimator);
  result.estimator_reason = scene.simulation.estimator_reason.value_or("");
  result.seed = scene.simulation.seed;
  if (!scene.telescope.empty()) {
    result.strategies = reported_strategies(scene, medium);
    std::ranges::move(reported_aimed_walks(scene, medium), std::back_inserter(result.strategies));
  }
  for (const auto& source : medium.sources) result.sources.push_back(medium::source_line(source));
  if (air)
    for (const auto& source : air->sources) result.sources.push_back(medium::source_line(source));
  return result;
}

}  // namespace photic::estimator
