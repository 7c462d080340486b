// The best estimator for a scene, as measured: repeated short runs of each against a long one. A
// run's own error bar would flatter estimators whose large scores are rare.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/isa.hpp"
#include "optics/library.hpp"
#include "run/monitor.hpp"
#include "run/rule.hpp"
#include "scene/scene.hpp"
#include "tally/result.hpp"

namespace photic::run {

/// The performance of an estimator in one gate.
struct Merit {
  double relative_variance = 0;  ///< of the mean over one repeat, squared bias included
  double figure_of_merit = 0;    ///< 1 / (relative variance * CPU time) [1/s]
  bool known = false;  ///< false: the reference is too uncertain here, and the two are bounds
};

/// An echo and its standard error; both in the same unit, the echo above 0.
struct ReferenceEcho {
  double mean = 0, standard_error = 0;
};

/// Merit by the squared distance of independent repeats from the reference. The reference's own
/// squared error is taken off; where it is more than a quarter of that distance, the merit is not
/// known. `cpu_s` is the time of one repeat [s].
Merit merit_of(const std::vector<double>& repeats, const ReferenceEcho& reference, double cpu_s);

/// Relative standard deviation of a variance known from so many repeats (of normal estimates).
double relative_uncertainty(int repeats);

/// One way to simulate the scene, as it was measured.
struct Candidate {
  std::string name;
  bool exact = true;             ///< false: has a bias by construction
  scene::Simulation simulation;  ///< its estimator and options
  std::optional<Isa> lanes{};    ///< none: the scalar engine
  std::uint64_t photons = 0;     ///< of one repeat
  double cpu_s = 0;              ///< of one repeat, mean
  std::vector<Merit> merit{};    ///< [telescope][channel][gate]; not known where not compared
};

struct Comparison {
  tally::Result reference;  ///< names and gates too
  std::string reference_name;
  double reference_cpu_s = 0;
  int repeats = 0;                    ///< of each candidate
  std::vector<Candidate> candidates;  ///< first the choice of estimator = "auto", with its reason
  std::vector<bool> compared;  ///< gates converged in the reference and known of all candidates
  Aim aim = Aim::all_gates;    ///< of the scene, by which one is recommended
};

/// A candidate's figure of merit [1/s] over the compared gates [first, last) of the flat cells, by
/// the rule for this aim (rule.hpp); none if there are no such gates.
std::optional<double> merit_in(const Comparison& comparison, const Candidate& candidate,
                               std::size_t first, std::size_t last, Aim aim);

/// The exact candidate of the largest one over all compared gates, by the aim of the comparison;
/// none if there are no such gates.
const Candidate* best_of(const Comparison& comparison);

struct BenchOptions {
  double time_s = 60;          ///< wall time: half for the reference, the rest for the candidates
  int threads = 0;             ///< 0: all cores
  Monitor* monitor = nullptr;  ///< that may stop it
  std::function<void(const std::string&)> report;  ///< called with the step that begins, one line
};

/// Measures all candidates; none if stopped. The amount of simulation goes by the clock, so no
/// two answers are alike. Throws what run() throws.
std::optional<Comparison> compare_estimators(const scene::Scene& scene,
                                             const optics::Library& library,
                                             const BenchOptions& options);

}  // namespace photic::run
