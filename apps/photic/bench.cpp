#include "run/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "estimator/model.hpp"
#include "io/netcdf_variable.hpp"
#include "io/table_parts.hpp"
#include "photic/beside.hpp"
#include "photic/commands.hpp"
#include "photic/interrupt.hpp"
#include "photic/output.hpp"
#include "photic/tables.hpp"
#include "photic/terminal.hpp"

namespace photic::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t max_columns = 6;

/// The lines of [simulation] that set an estimator and the options that candidates differ in.
Json settings_of(const scene::Simulation& s) {
  if (s.estimator == scene::Estimator::forward)
    return {{"estimator", scene::word_of(s.estimator)},
            {"reception", scene::word_of(s.reception)},
            {"directed_fraction", s.directed_fraction.value()},
            {"scored_points", s.scored_points.value()}};
  Json out = {{"estimator", scene::word_of(s.estimator)},
              {"walk_attenuation", s.walk_attenuation.value()},
              {"meetings", s.meetings.value()},
              {"free_telescope_meetings", s.free_telescope_meetings.value_or(0)},
              {"free_laser_meetings", s.free_laser_meetings.value_or(0)},
              {"walks", s.walks.value()},
              {"connected_fraction", s.connected_fraction.value()},
              {"sampling", scene::word_of(s.sampling)}};
  if (s.conversion_probability) out["conversion_probability"] = *s.conversion_probability;
  return out;
}

std::string as_toml(const Json& settings) {
  std::string out;
  for (const auto& [key, value] : settings.items())
    out += fmt::format("  {} = {}\n", key, value.dump());
  return out;
}

std::string merit_text(const std::optional<double>& merit) {
  return merit ? fmt::format("{:.3g}", *merit) : "-";
}

std::string name_of(const run::Candidate& candidate) {
  return candidate.name + (candidate.exact ? "" : " (approximate)");
}

/// Gates [begin, end) of one telescope and channel in one column.
struct Column {
  std::size_t begin, end;
};

std::vector<Column> columns(std::size_t gates) {
  const std::size_t count = std::min(max_columns, gates);
  std::vector<Column> out;
  for (std::size_t i = 0; i < count; ++i)
    out.push_back({i * gates / count, (i + 1) * gates / count});
  return out;
}

/// The names of candidates, below a heading for the place of gates.
io::TextColumn names(const run::Comparison& comparison, std::vector<std::string> heading) {
  io::TextColumn out{heading.front(), {}, true};
  out.cells.assign(heading.begin() + 1, heading.end());
  for (const run::Candidate& candidate : comparison.candidates)
    out.cells.push_back(name_of(candidate));
  return out;
}

/// One telescope's and channel's gates: columns of depths, a row for each candidate.
std::string block(const run::Comparison& comparison, std::size_t telescope, std::size_t channel) {
  const tally::Result& result = comparison.reference;
  const double depth_m = result.gate_depth_m(telescope, channel, 0);
  const std::size_t first = (telescope * result.channels() + channel) * result.gates();
  const std::size_t first_edge = (telescope * result.channels() + channel) * (result.gates() + 1);
  const auto edge = [&](std::size_t gate) {
    return std::isnan(depth_m) ? result.gate_time_edge_ns[gate]
                               : result.gate_depth_edge_m[first_edge + gate];
  };
  std::vector<io::TextColumn> table{
      names(comparison, {io::place_heading(result, depth_m), "gates compared"})};
  for (const auto& [begin, end] : columns(result.gates())) {
    const auto compared = comparison.compared.begin() + static_cast<std::ptrdiff_t>(first);
    table.push_back({fmt::format("{:.3g}-{:.3g}", edge(begin), edge(end)), {}});
    auto& cells = table.back().cells;
    cells.push_back(fmt::format("{}/{}",
                                std::count(compared + static_cast<std::ptrdiff_t>(begin),
                                           compared + static_cast<std::ptrdiff_t>(end), true),
                                end - begin));
    for (const run::Candidate& candidate : comparison.candidates)
      cells.push_back(merit_text(
          run::merit_in(comparison, candidate, first + begin, first + end, run::Aim::all_gates)));
  }
  return fmt::format("\nchannel {}, telescope {}\n", result.channel_name[channel],
                     result.telescope_name[telescope]) +
         io::side_by_side(table);
}

/// Why gates were left out of the comparison.
struct GateCounts {
  std::size_t all = 0, not_converged = 0, compared = 0;
  [[nodiscard]] std::size_t uncertain() const { return all - not_converged - compared; }
};

GateCounts count_gates(const run::Comparison& comparison) {
  const auto& flags = comparison.reference.convergence_flags;
  GateCounts out;
  out.all = flags.size();
  out.not_converged =
      flags.size() - static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 0));
  out.compared = static_cast<std::size_t>(
      std::count(comparison.compared.begin(), comparison.compared.end(), true));
  return out;
}

std::optional<double> merit_of_all(const run::Comparison& comparison,
                                   const run::Candidate& candidate, run::Aim aim) {
  return run::merit_in(comparison, candidate, 0, comparison.compared.size(), aim);
}

std::string summary(const run::Comparison& comparison) {
  std::vector<io::TextColumn> columns{names(comparison, {""}),
                                      {"all gates", {}},
                                      {"worst fifth", {}},
                                      {"photons", {}},
                                      {"CPU s", {}}};
  for (const run::Candidate& c : comparison.candidates) {
    columns[1].cells.push_back(merit_text(merit_of_all(comparison, c, run::Aim::all_gates)));
    columns[2].cells.push_back(merit_text(merit_of_all(comparison, c, run::Aim::worst_gates)));
    columns[3].cells.push_back(fmt::format("{}", c.photons));
    columns[4].cells.push_back(fmt::format("{:.3g}", c.cpu_s));
  }
  std::string out = '\n' + io::side_by_side(columns);
  const GateCounts gates = count_gates(comparison);
  out += fmt::format(
      "\n{} of {} gates compared; left out: {} not converged in the reference, {} where it is too "
      "uncertain\nA figure of merit from {} repeats is uncertain by about {:.0f} %.\n",
      gates.compared, gates.all, gates.not_converged, gates.uncertain(), comparison.repeats,
      100 * run::relative_uncertainty(comparison.repeats));
  return out;
}

std::string recommendation(const run::Comparison& comparison) {
  std::string out = "\nrecommended: ";
  if (const run::Candidate* best = run::best_of(comparison)) {
    const char* over = comparison.aim == run::Aim::worst_gates
                           ? "in the worst fifth of the gates, since all are to meet a target"
                           : "over all gates, since there is no target";
    out += fmt::format("{}, by these lines of [simulation] (best {})\n{}", best->name, over,
                       as_toml(settings_of(best->simulation)));
  } else {
    out += "nothing, since no gate can be compared (give more --time)\n";
  }
  const scene::Simulation& chosen = comparison.candidates.front().simulation;
  return out + "estimator = \"auto\" would take\n" + as_toml(settings_of(chosen)) +
         "  because of " + chosen.estimator_reason.value_or("") + '\n';
}

std::string table(const run::Comparison& comparison) {
  const tally::Result& reference = comparison.reference;
  std::string out = fmt::format(
      "Figure of merit: 1 / (relative variance * CPU time) [1/s], geometric means over gates;\n"
      "reference: {}, {} photons in {:.3g} CPU s; each below: {} repeats\n",
      comparison.reference_name, reference.photons, comparison.reference_cpu_s, comparison.repeats);
  for (std::size_t t = 0; t < reference.telescopes(); ++t) {
    for (std::size_t c = 0; c < reference.channels(); ++c) out += block(comparison, t, c);
  }
  return out + summary(comparison) + recommendation(comparison);
}

Json gates_json(const run::Comparison& comparison, const run::Candidate& candidate) {
  const tally::Result& result = comparison.reference;
  Json out = Json::array();
  for (std::size_t cell = 0; cell < candidate.merit.size(); ++cell) {
    if (!candidate.merit[cell].known) continue;
    const std::size_t gate = cell % result.gates();
    const std::size_t channel = cell / result.gates() % result.channels();
    const std::size_t telescope = cell / result.gates() / result.channels();
    out.push_back({{"telescope", result.telescope_name[telescope]},
                   {"channel", result.channel_name[channel]},
                   {"gate", gate},
                   {"depth_m", result.gate_depth_m(telescope, channel, gate)},
                   {"relative_variance", candidate.merit[cell].relative_variance},
                   {"figure_of_merit_per_s", candidate.merit[cell].figure_of_merit},
                   {"compared", static_cast<bool>(comparison.compared[cell])}});
  }
  return out;
}

std::string json(const run::Comparison& comparison, const std::string& scene) {
  const GateCounts gates = count_gates(comparison);
  const tally::Result& reference = comparison.reference;
  const scene::Simulation& chosen = comparison.candidates.front().simulation;
  Json out = {
      {"scene", scene},
      {"repeats", comparison.repeats},
      {"relative_uncertainty", run::relative_uncertainty(comparison.repeats)},
      {"reference", {{"photons", reference.photons}, {"cpu_s", comparison.reference_cpu_s}}},
      {"depth_is_range", reference.gate_depth_is_range},
      {"gates",
       {{"all", gates.all},
        {"not_converged", gates.not_converged},
        {"uncertain", gates.uncertain()},
        {"compared", gates.compared}}},
      {"candidates", Json::array()},
      {"recommended", nullptr},
      {"recommended_by", comparison.aim == run::Aim::worst_gates ? "worst fifth" : "all gates"},
      {"auto", settings_of(chosen)}};
  for (const run::Candidate& c : comparison.candidates) {
    const auto mean = merit_of_all(comparison, c, run::Aim::all_gates);
    const auto worst = merit_of_all(comparison, c, run::Aim::worst_gates);
    out["candidates"].push_back({{"name", c.name},
                                 {"exact", c.exact},
                                 {"settings", settings_of(c.simulation)},
                                 {"photons", c.photons},
                                 {"cpu_s", c.cpu_s},
                                 {"figure_of_merit_per_s", mean ? Json(*mean) : Json()},
                                 {"worst_fifth_per_s", worst ? Json(*worst) : Json()},
                                 {"gates", gates_json(comparison, c)}});
  }
  if (const run::Candidate* best = run::best_of(comparison))
    out["recommended"] = settings_of(best->simulation);
  out["auto_reason"] = chosen.estimator_reason.value_or("");
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

int run(const BenchCommand& command) {
  const scene::Reading reading =
      scene::read_scene(command.scene, command.overrides, optics_check(), io::netcdf_files());
  for (const std::string& remark : reading.remarks) print_warning(remark + '\n');
  if (reading.scene.telescope.empty())
    throw InputError(
        {{.file = command.scene,
          .reason = "bench compares estimators by echoes, and there is no telescope",
          .suggestion = "add a [[telescope]]; what tallies cost, `photic run` reports"}});
  run::BenchOptions options;
  options.time_s = command.time_s;
  options.threads = command.threads;
  run::Monitor monitor;
  options.monitor = &monitor;
  if (is_terminal(Stream::error))
    options.report = [](const std::string& line) { print_error("measuring " + line + '\n'); };
  listen_for_interrupts();
  const auto comparison =
      beside(monitor, [&] { return run::compare_estimators(reading.scene, *tables(), options); });
  if (!comparison) return interrupt_exit_code();
  print_out(command.json ? json(*comparison, command.scene) : table(*comparison));
  return done;
}

}  // namespace photic::app
