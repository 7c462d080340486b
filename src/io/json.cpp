#include "io/json.hpp"

#include <nlohmann/json.hpp>

#include "io/echo_rows.hpp"
#include "io/tally_rows.hpp"

namespace photic::io {
namespace {

using Json = nlohmann::ordered_json;

Json ledger(const tally::Ledger& shares) {
  Json out;
  tally::Ledger::each([&](const char* name, double share) { out[name] = share; }, shares);
  return out;
}

Json echo(const tally::Result& result, const EchoRow& row) {
  return {{"telescope", result.telescope_name[row.telescope]},
          {"channel", result.channel_name[row.channel]},
          {"gate", row.gate},
          {"time_start_ns", row.time_start_ns},
          {"time_end_ns", row.time_end_ns},
          {"depth_m", row.depth_m},
          {"echo", row.echo},
          {"standard_error", row.standard_error},
          {"relative_error", row.relative_error},
          {"converged", row.converged()},
          {"reasons", flag_names(row.flags)}};
}

/// The name of an environment, and its numbers by their paths.
Json environment(const tally::Result& result, std::size_t index) {
  Json values = Json::object();
  const std::size_t paths = result.environment_path.size();
  for (std::size_t p = 0; p < paths; ++p)
    values[result.environment_path[p]] = result.environment_value[index * paths + p];
  return {{"name", result.environment_name[index]}, {"values", values}};
}

/// An object for each row of an environment, with its name.
Json environment_echoes(const tally::Result& result, std::size_t environment) {
  Json all = Json::array();
  for (const EchoRow& row : environment_rows(result, environment)) {
    Json one = {{"environment", result.environment_name[environment]}};
    one.update(echo(result, row));
    one["difference"] = row.difference;
    one["difference_standard_error"] = row.difference_standard_error;
    all.push_back(std::move(one));
  }
  return all;
}

/// An object for each gate's derivatives with respect to a parameter.
Json sensitivities(const tally::Result& result, std::size_t parameter) {
  Json all = Json::array();
  for (const EchoRow& row : sensitivity_rows(result, parameter)) {
    Json one = {{"parameter", result.parameter_name[parameter]},
                {"value", result.parameter_value[parameter]}};
    one.update(echo(result, row));
    one["sensitivity"] = row.sensitivity;
    one["sensitivity_standard_error"] = row.sensitivity_standard_error;
    one["logarithmic_sensitivity"] = row.logarithmic_sensitivity;
    one["logarithmic_sensitivity_standard_error"] = row.logarithmic_sensitivity_standard_error;
    all.push_back(std::move(one));
  }
  return all;
}

/// A quantity beside echoes with an object for each cell.
Json tally(const tally::TallyEstimates& one) {
  const tally::TallyGrid& grid = one.grid;
  Json out = {{"quantity", grid.name},
              {"long_name", grid.long_name},
              {"units", grid.units},
              {"normalisation", grid.normalisation}};
  if (grid.by_strength) {
    out["strength_scale"] = grid.by_strength->scale;
    out["strength_units"] = grid.by_strength->units;
  }
  out["cells"] = Json::array();
  for (const TallyRow& row : tally_rows(one)) {
    Json cell = Json::object();
    for (const auto& [name, value] : place_of(row))
      std::visit([&](const auto& each) { cell[name] = each; }, value);
    cell.update({{"value", row.value},
                 {"standard_error", row.standard_error},
                 {"relative_error", row.relative_error},
                 {"converged", row.converged()},
                 {"reasons", flag_names(row.flags)}});
    out["cells"].push_back(std::move(cell));
  }
  return out;
}

}  // namespace

std::string echo_json(const tally::Result& result) {
  Json json = {{"title", result.title},
               {"version", result.version},
               {"engine", result.engine},
               {"estimator", result.estimator},
               {"seed", result.seed},
               {"photons", result.photons},
               {"channel_photons", result.channel_photons},
               {"batches", result.batches},
               {"collisions", result.collisions},
               {"stopped_by", result.stopped_by},
               {"partial", result.partial},
               {"lost_too_many_events", result.lost_too_many_events},
               {"lost_not_finite", result.lost_not_finite},
               {"wall_time_s", result.wall_time_s},
               {"threads", result.threads},
               {"ledger", ledger(result.ledger)},
               {"warnings", result.warnings},
               {"depth_is_range", result.gate_depth_is_range},
               {"echoes", Json::array()}};
  for (const EchoRow& row : echo_rows(result)) json["echoes"].push_back(echo(result, row));
  for (std::size_t e = 0; e < result.environment_name.size(); ++e) {
    json["environments"].push_back(environment(result, e));
    for (Json& one : environment_echoes(result, e))
      json["environment_echoes"].push_back(std::move(one));
  }
  for (std::size_t p = 0; p < result.parameter_name.size(); ++p)
    for (Json& one : sensitivities(result, p)) json["sensitivities"].push_back(std::move(one));
  if (result.source_strength) {
    json["source_strength"] = *result.source_strength;
    json["source_strength_units"] = result.source_strength_units;
  }
  for (const tally::TallyEstimates& one : result.tallies) json["tallies"].push_back(tally(one));
  // Names may hold bytes that are not UTF-8: shown as U+FFFD, not a reason to lose the rest.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace photic::io
