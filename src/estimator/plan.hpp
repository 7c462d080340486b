// The histories that make a run's echo, as sets that are followed one after the other. make_plan()
// alone says which of them a scene takes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <stop_token>
#include <vector>

#include "estimator/model.hpp"

namespace photic::estimator {

/// The light that histories score.
enum class Scored : std::int8_t {
  all,
  film,       ///< a film's and the surface's own: walks score all else
  none,       ///< none: they lead to other histories
  from_water  ///< in the air, light that has been in the water, or is a film's
};

/// The set that light which passes the surface goes on in, in the other medium.
struct PassesTo {
  std::size_t set;
  double chance;  ///< share of the light that does
  double path_m;  ///< the excess of its path there
  bool fresh;     ///< also light that has not been scattered, from a laser in the water
};

/// Histories of one kind, in a world that make_world() makes of the set.
struct HistorySet {
  enum class Kind : std::int8_t {
    histories,     ///< of the forward estimator
    walks,         ///< of the bidirectional estimator
    surface_echo,  ///< the surface's own echo, which walks leave out
    analog
  } kind;
  const Model* model;
  std::uint64_t stream = 0;  ///< of random numbers; 0: the run's own
  Scored scored = Scored::all;
  bool from_laser = true;  ///< false: all photons come from another set
  bool in_ledger = false;  ///< true: the ledger has their weights
  std::optional<PassesTo> passes_to = {};
};

/// The sets in their order. Sums of scores depend on it.
struct Plan {
  std::deque<Model> models;  ///< those of sets, besides the run's
  std::vector<HistorySet> sets;
};

/// The model must outlive the plan.
Plan make_plan(const Model& model, const std::stop_token& stop = {});

}  // namespace photic::estimator
