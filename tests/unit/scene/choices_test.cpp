// Every value of every choice: read from its word, and written as it.
#include "scene/choices.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

constexpr auto nothing = [](auto) { return std::vector<Override>{}; };

/// Of the base scene with `path` set to the word of each value `member` is that value, and the
/// scene is the same once written and read. `more(value)`: what else the value needs.
template <class E, class Member, class More>
void expect_round_trips(const std::string& path, const Member& member, const More& more) {
  std::set<E> values;
  for (const auto& [value, word, meaning] : alternatives(E{})) {
    SCOPED_TRACE(path + "=" + word);
    std::vector<Override> overrides = more(value);
    overrides.push_back(path + "=" + word);
    const Scene scene = base_scene(overrides);
    EXPECT_EQ(member(scene), value);
    const std::string text = write_scene(scene);
    EXPECT_NE(text.find(path.substr(path.rfind('.') + 1) + " = \"" + word + '"'), std::string::npos)
        << text;
    EXPECT_EQ(read_text(text), scene);
    EXPECT_TRUE(values.insert(value).second) << "listed twice";
  }
  EXPECT_EQ(values.size(), static_cast<std::size_t>(*values.rbegin()) + 1) << "a value has no word";
}

template <class E>
void expect_in_simulation(const std::string& key, E Simulation::*member) {
  expect_round_trips<E>(
      "simulation." + key, [&](const Scene& s) { return s.simulation.*member; }, nothing);
}

template <class E>
void expect_in_tools(const std::string& key, E Tools::*member) {
  expect_round_trips<E>(
      "simulation.tools." + key, [&](const Scene& s) { return s.simulation.tools.*member; },
      nothing);
}

template <class E, class Member>
void expect_in_optics(const std::string& key, Member Optics::*member) {
  expect_round_trips<E>(
      "optics." + key, [&](const Scene& s) { return s.optics.*member; }, nothing);
}

// These were seen red: with each value read, or written, as the first of its choice.
TEST(Choices, OfTheSimulationAreReadAndWrittenByTheirWords) {
  expect_in_simulation("estimator", &Simulation::estimator);
  expect_in_simulation("reception", &Simulation::reception);
  expect_in_simulation("sampling", &Simulation::sampling);
  expect_in_tools("at_threshold", &Tools::at_threshold);
  expect_in_tools("local_forced_collisions", &Tools::local_forced_collisions);
}

TEST(Choices, OfTheSourceAreReadAndWrittenByTheirWords) {
  expect_round_trips<SourceProfile>(
      "source.profile", [](const Scene& s) { return s.source.profile; }, nothing);
}

TEST(Choices, OfChannelsAreReadAndWrittenByTheirWords) {
  expect_round_trips<Process>(
      "channel.0.process", [](const Scene& s) { return s.channel[0].process; }, nothing);
  expect_round_trips<FilterShape>(
      "channel.0.filter", [](const Scene& s) { return s.channel[0].filter; },
      [](FilterShape) {
        return std::vector<Override>{
            R"(channel=[{ name = "green", centre_nm = 532, fwhm_nm = 3 }])"};
      });
}

TEST(Choices, OfTheOpticsAreReadAndWrittenByTheirWords) {
  expect_in_optics<OpticsSet>("set", &Optics::set);
  expect_in_optics<ParticlePhase>("phytoplankton_phase", &Optics::phytoplankton_phase);
  expect_in_optics<MineralOptics>("minerals", &Optics::minerals);
  expect_in_optics<ParticlePhase>("minerals_phase", &Optics::minerals_phase);
  expect_in_optics<Emission>("emission", &Optics::emission);
  expect_round_trips<CdomFluorescence>(
      "optics.cdom_fluorescence", [](const Scene& s) { return s.optics.cdom_fluorescence; },
      [](CdomFluorescence value) {
        return value == CdomFluorescence::table
                   ? std::vector<Override>{"optics.cdom_fluorescence_file={ excitation_nm = [400, "
                                           "400], emission_nm = [500, 600], yield_per_nm = [0, "
                                           "0.001] }"}
                   : std::vector<Override>{};
      });
}

/// A surface with what the model needs.
std::vector<Override> surface_to_be(SurfaceModel model) {
  std::string keys;
  if (model == SurfaceModel::cox_munk || model == SurfaceModel::paper)
    keys = ", wind_speed_m_s = 5";
  if (model == SurfaceModel::gaussian)
    keys = ", upwind_slope_variance = 0.1, crosswind_slope_variance = 0.2";
  return {"sea.surface={ model = \"none\"" + keys + " }"};
}

TEST(Choices, OfTheSurfaceAreReadAndWrittenByTheirWords) {
  const auto under_waves = [](auto) {
    return std::vector<Override>{R"(sea.surface={ model = "cox-munk", wind_speed_m_s = 5 })"};
  };
  expect_round_trips<SurfaceModel>(
      "sea.surface.model", [](const Scene& s) { return s.sea.surface.model; }, surface_to_be);
  expect_round_trips<WhitecapLaw>(
      "sea.surface.whitecap_law", [](const Scene& s) { return s.sea.surface.whitecap_law; },
      under_waves);
  expect_round_trips<WhitecapReflectance>(
      "sea.surface.whitecap_reflectance",
      [](const Scene& s) { return s.sea.surface.whitecap_reflectance; }, under_waves);
}

/// What a phase function of the model needs, as keys of an inline table.
std::string keys_of(PhaseModel model) {
  switch (model) {
    case PhaseModel::henyey_greenstein:
      return ", g = 0.9";
    case PhaseModel::fournier_forand:
      return ", refractive_index = 1.1, slope = 3.6";
    case PhaseModel::rayleigh:
      return ", depolarisation = 0.04";
    case PhaseModel::table:
      return ", file = { angle_deg = [0, 180], phase_function_per_sr = [0.1, 0.06] }";
    case PhaseModel::mixture:
      return R"(, components = [{ fraction = 1.0, model = "petzold" }])";
    default:
      return "";
  }
}

TEST(Choices, OfPhaseFunctionsAreReadAndWrittenByTheirWords) {
  expect_round_trips<PhaseModel>(
      "sea.layer.1.phase_function.model",
      [](const Scene& s) { return s.sea.layer[1].phase_function->model; },
      [](PhaseModel model) {
        return std::vector<Override>{"sea.layer.1.phase_function={ model = \"none\"" +
                                     keys_of(model) + " }"};
      });
}

}  // namespace
}  // namespace photic::scene
