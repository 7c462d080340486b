// The keys of [gates], [simulation], [[environment]] and of the scene as a whole (see
// describe_instrument.hpp).
#pragma once

#include "scene/changes.hpp"
#include "scene/describe_air.hpp"
#include "scene/describe_instrument.hpp"
#include "scene/describe_sea.hpp"
#include "scene/describe_tally.hpp"
#include "scene/environment_grid.hpp"
#include "scene/sensitivities.hpp"

namespace photic::scene {

/// Bounds the copies of a photon that wait while another one is followed.
inline constexpr double max_importance = 100;

template <class V>
void describe(V& v, Gates& g) {
  Gates::Interval depth = g.depth_m.value_or(Gates::Interval{});
  Gates::Interval range = g.range_m.value_or(Gates::Interval{});
  Gates::Interval time = g.time_ns.value_or(Gates::Interval{});
  v.one_of(option(g.depth_m.has_value(),
                  [&](auto& w) {
                    w.optional("depth_min_m", depth.min, any_number,
                               "where the first gate begins, as depth below the surface in m; "
                               "negative in the air");
                    w.required("depth_max_m", depth.max, any_number,
                               "where the last gate ends in m");
                    w.required("depth_step_m", depth.step, positive, "the depth of one gate in m");
                    w.once_read([&] { g.depth_m = depth; });
                  }),
           option(g.range_m.has_value(),
                  [&](auto& w) {
                    w.required(
                        "range_min_m", range.min, not_negative,
                        "where the first gate begins, along the axis of the first telescope, in m");
                    w.required("range_max_m", range.max, positive, "where the last gate ends in m");
                    w.required("range_step_m", range.step, positive, "the length of one gate in m");
                    w.once_read([&] { g.range_m = range; });
                  }),
           option(g.time_ns.has_value(), [&](auto& w) {
             w.required("start_ns", time.min, not_negative,
                        "when the first gate begins, after the light left the source, in ns");
             w.required("stop_ns", time.max, positive, "when the last gate ends in ns");
             w.required("step_ns", time.step, positive, "the duration of one gate in ns");
             w.once_read([&] { g.time_ns = time; });
           }));
  v.optional(expert("depth_cells"), g.depth_cells, Count{0, 10000},
             "the number of cells of depth of echo_by_depth; 0: no echo_by_depth");
}

template <class V>
void describe(V& v, Importance& i) {
  v.required("depth_m", i.depth_m, positive, "from this depth on, in m");
  v.required(expert("value"), i.value, Number{.low = 1 / max_importance, .high = max_importance},
             "the worth of a photon there, relative to 1 at the surface");
}

template <class V>
void describe(V& v, Tools& t) {
  v.optional(
      expert("forced_collisions"), t.forced_collisions, Count{0, 1'000'000},
      "this many first flights of a photon end in the water, or reflected by its surface; what "
      "would leave is taken from the weight");
  v.optional(expert("local_forced_collisions"), t.local_forced_collisions,
             ChoiceOf<LocalForcedCollisions>{},
             "which collisions are scored at points chosen in a telescope's view; the others are "
             "scored where they happen");
  v.optional(expert("weight_threshold"), t.weight_threshold,
             Number{.low = 0.0, .high = 1.0, .low_open = true},
             "of the forward estimator: the weight, without the factors from sampling, below which "
             "at_threshold decides");
  v.optional(expert("at_threshold"), t.at_threshold, ChoiceOf<AtThreshold>{},
             "what happens to photons of little weight");
  v.sections(expert("importance"), t.importance, Need::optional,
             "photons are split on their way to where they are worth more, and play Russian "
             "roulette on their way to where they are worth less");
}

template <class V>
void describe(V& v, Simulation& s) {
  v.optional("estimator", s.estimator, ChoiceOf<Estimator>{}, "how echoes are estimated");
  v.optional(expert("estimator_reason"), s.estimator_reason, Text{},
             "why auto chose this estimator; written by a run");
  v.any_of([&](auto& w) {
    w.optional("photons", s.photons, Count{}, "end after this many photons");
    w.optional("target_relative_error", s.target_relative_error, between(0.0, 1.0),
               "end when the gates have this relative standard error");
    w.optional("max_time_s", s.max_time_s, positive, "end after this many seconds");
  });
  v.optional(expert("max_order"), s.max_order, Count{1, 1'000'000},
             "end a photon after this many scatterings; no limit by default");
  v.optional("orders_kept", s.orders_kept, Count{1, 1000},
             "echoes are split by scattering order up to this one, which includes all higher ones");
  v.optional(without_unit("seed"), s.seed, Count{.low = 0}, "the seed of the random numbers");
  v.optional(expert("reception"), s.reception, ChoiceOf<Reception>{},
             "of the forward estimator: how light reaches the detector");
  v.optional(expert("directed_fraction"), s.directed_fraction,
             Number{.low = 0.0, .high = 1.0, .high_open = true},
             "of the forward estimator: the share of directions drawn towards a telescope; 0 turns "
             "that off; by default 0.5, or 0.25 where all telescopes are 200 m above the sea");
  v.optional(
      expert("scored_points"), s.scored_points, Count{1, 100},
      "of the forward estimator: the number of points of each flight, spread evenly over its "
      "free paths, at which collisions are scored; 1: only where photons collide; by default "
      "4, or 1 where all telescopes are 200 m above the sea");
  v.optional(
      expert("conversion_probability"), s.conversion_probability, between(0.0, 1.0),
      "the share of collisions followed into an inelastic process; in walks from telescopes, "
      "of free paths as long as the laser's light would have; by default 0.3, or as pilot runs of "
      "auto find best");
  v.optional(expert("walks"), s.walks, Count{1, 100},
             "of the bidirectional estimator: walks from the laser, and from each telescope, that "
             "are all connected with each other; by default 2, or as pilot runs of auto find best");
  v.optional(expert("meetings"), s.meetings, Number{.low = 0.0, .high = 1e5, .low_open = true},
             "of the bidirectional estimator: how often two rays are made to meet, over the range "
             "of the gates; an eighth and a quarter as often in paths of one vertex and of two; by "
             "default 100, or as pilot runs of auto find best");
  v.optional(expert("free_telescope_meetings"), s.free_telescope_meetings,
             Number{.low = 0.0, .high = 1e5},
             "of the bidirectional estimator: how often two rays are made to meet, per metre of "
             "depth, by free walks of telescopes; by default as pilot runs find best");
  v.optional(expert("free_laser_meetings"), s.free_laser_meetings, Number{.low = 0.0, .high = 1e5},
             "the same by free walks of the laser");
  v.optional(
      expert("connected_fraction"), s.connected_fraction,
      Number{.low = 0.0, .high = 1.0, .low_open = true},
      "of the bidirectional estimator: the share of the telescopes' walks whose vertices are "
      "connected with those of a laser's walk; the others only meet it; by default 0.3");
  v.optional(expert("walk_attenuation"), s.walk_attenuation, between(0.0, 1.0),
             "of the bidirectional estimator: the share of the water's attenuation that its free "
             "paths are drawn from; by default 0.6, or 0.9 in water that scatters more than two "
             "thirds of it");
  v.optional(expert("sampling"), s.sampling, ChoiceOf<Sampling>{},
             "how the photons or walks of a batch begin");
  v.optional(expert("batch_photons"), s.batch_photons, Count{min_batch_photons, max_batch_photons},
             "photons of a batch: errors are those of the scatter of batches; by default the most "
             "of which photons holds 40 batches, and 2000 at most of the bidirectional estimator");
  v.optional(expert("keep_groups"), s.keep_groups, YesOrNo{},
             "whether echoes are kept by groups of batches, too: errors of all that is made of "
             "several of them are made of those");
  v.section(expert("tools"), s.tools, Need::optional,
            "variance reduction by the forward estimator");
}

template <class V>
void describe(V& v, Environment& e) {
  v.optional("name", e.name, Text{},
             "what results call it; by default environment0, environment1 …");
  v.required("set", e.set, Changes{},
             "the values that differ in this water, by their paths: those of --set that begin with "
             "sea., optics., bottom., oil. or atmosphere.");
}

/// The sections that air alone does without.
template <class V>
void describe_waters(V& v, Scene& s) {
  v.section("sea", s.sea, Need::optional, "the sea: its surface and its layers of water");
  v.section("bottom", s.bottom, Need::optional,
            "the sea bed, where the last layer ends; black without this section");
  v.section("oil", s.oil, Need::optional, "a film of oil on all of the sea");
}

template <class V>
void describe(V& v, Scene& s) {
  v.optional("title", s.title, Text{.may_be_empty = true}, "what is simulated, in one line");
  v.optional(expert("sensitivity"), s.sensitivity, Parameters{},
             "the parameters of the water by which derivatives of echoes are taken, by their "
             "paths: those of --set that begin with sea., optics., bottom., oil. or atmosphere.");
  v.section("source", s.source, Need::required, "the source of light");
  v.any_of(
      [&](auto& w) {
        w.sections("telescope", s.telescope, Need::optional, "a telescope; any number of them");
        w.sections("tally", s.tally, Need::optional,
                   "a quantity of radiative transfer beside echoes; any number of them");
      },
      "add a [[telescope]] for echoes, a [[tally]] for irradiances, balances and other quantities, "
      "or both");
  v.with("telescope", !s.telescope.empty(), [&](auto& w) {
    w.sections("channel", s.channel, Need::required,
               "the light that one detector counts; any number of them");
  });
  v.section("optics", s.optics, Need::optional, "the data and models of the water's optics");
  v.unless("atmosphere", "surface", s.is_of_air_alone(), "a ground takes the place of the sea",
           [&](auto& w) { describe_waters(w, s); });
  v.section("atmosphere", s.atmosphere, Need::optional,
            "the air above the sea; a vacuum without this section");
  v.with("telescope", !s.telescope.empty(),
         [&](auto& w) { w.section("gates", s.gates, Need::required, "the range gates"); });
  v.section("simulation", s.simulation, Need::required, "how long and how to simulate");
  v.sections(expert("environment"), s.environment, Need::optional,
             "other water, whose echoes are computed from the same histories; any number of them");
  v.expanded(expert("environment_grid"), Grid{},
             "more such environments: one for each combination of the values of the paths");
}

}  // namespace photic::scene
