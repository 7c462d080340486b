#include "io/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cstring>
#include <fstream>
#include <vector>

#include "io/atomic_file.hpp"
#include "io/csv_field.hpp"
#include "io/echo_rows.hpp"
#include "io/table.hpp"
#include "io/table_parts.hpp"
#include "io/tally_csv.hpp"

namespace photic::io {
namespace {

constexpr const char* estimator_word = ", estimator ";
constexpr const char* photons_word = ", photons ";

const char* const columns =
    "telescope,channel,gate,time_start_ns,time_end_ns,depth_m,echo,standard_error,relative_error,"
    "converged,reasons";

bool has_environments(const tally::Result& result) { return !result.environment_name.empty(); }
bool has_parameters(const tally::Result& result) { return !result.parameter_name.empty(); }

/// The first lines of a file of text, which photons_in_text looks for.
std::string whose(const tally::Result& result) {
  return fmt::format("# {}\n# Photic {}{}{}, engine {}, seed {}{}{}{}\n", one_line(result.title),
                     result.version, estimator_word, result.estimator, result.engine, result.seed,
                     photons_word, result.photons, result.partial ? " (partial: interrupted)" : "");
}

/// The run, and what went wrong in it.
std::string head(const tally::Result& result) {
  std::string out = whose(result);
  if (const std::string rested = rested_channels(result); !rested.empty())
    out += fmt::format("# photons of channels that met the target before others: {}\n",
                       one_line(rested));
  for (const auto& warning : result.warnings)
    out += fmt::format("# warning: {}\n", one_line(warning));
  return out;
}

/// The contents of the columns, and their names.
std::string head_of_columns(const tally::Result& result) {
  std::string out =
      "# echo: expected photons detected in the gate per photon emitted; standard_error: of the "
      "echo\n";
  out += fmt::format(
      "# gate: from 0; time: from laser to telescope; depth_m: {}, centre of the gate\n",
      result.gate_depth_is_range
          ? "range along the axis of the telescope"
          : "vertical, down from the sea level, along the axes of laser and telescope");
  std::string more;
  if (has_environments(result)) {
    out +=
        "# environment: none for the scene itself; difference: echo in the environment minus the "
        "scene's, from the same photons\n";
    more += ",environment,difference,difference_standard_error";
    if (!result.environment_path.empty())
      out += "# columns called by paths: the values there in the environment\n";
    for (const std::string& path : result.environment_path)
      more.append(1, ',').append(csv_field(path));
  }
  if (has_parameters(result)) {
    out +=
        "# parameter: none for echoes themselves; sensitivity: derivative of the scene's echo with "
        "respect to it; logarithmic_sensitivity: times parameter over echo\n";
    more +=
        ",parameter,sensitivity,sensitivity_standard_error,logarithmic_sensitivity,"
        "logarithmic_sensitivity_standard_error";
  }
  if (!result.tallies.empty())
    more += ',' + fmt::format("{}", fmt::join(tally_columns(result), ","));
  return out + about_tallies(result) + columns + more + '\n';
}

std::string line(const tally::Result& result, const EchoRow& row) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}",
                     csv_field(result.telescope_name[row.telescope]),
                     csv_field(result.channel_name[row.channel]), row.gate, row.time_start_ns,
                     row.time_end_ns, row.depth_m, row.echo, row.standard_error, row.relative_error,
                     row.converged() ? "yes" : "no", fmt::join(flag_names(row.flags), " "));
}

/// The fields of the environment of this number; without one all but the difference are empty.
std::string environment_part(const tally::Result& result, std::optional<std::size_t> environment,
                             const EchoRow& row) {
  if (!has_environments(result)) return "";
  const std::size_t paths = result.environment_path.size();
  const std::string name = environment ? csv_field(result.environment_name[*environment]) : "";
  std::string out = fmt::format(",{},{},{}", name, row.difference, row.difference_standard_error);
  for (std::size_t p = 0; p < paths; ++p)
    out +=
        environment ? fmt::format(",{}", result.environment_value[*environment * paths + p]) : ",";
  return out;
}

std::string parameter_part(const tally::Result& result, const std::string& name,
                           const EchoRow& row) {
  if (!has_parameters(result)) return "";
  return fmt::format(",{},{},{},{},{}", csv_field(name), row.sensitivity,
                     row.sensitivity_standard_error, row.logarithmic_sensitivity,
                     row.logarithmic_sensitivity_standard_error);
}

/// Rows whose columns of echoes are empty, but for those that both have.
std::string tallies_beside_echoes(const tally::Result& result) {
  const std::size_t before = 7;  // columns of echoes before standard_error
  const std::size_t between = (has_environments(result) ? 3 + result.environment_path.size() : 0) +
                              (has_parameters(result) ? 5 : 0);
  std::string out;
  for (const TallyLine& line : tally_lines(result))
    out += fmt::format("{}{}{},{}\n", std::string(before, ','), line.quality,
                       std::string(between, ','), fmt::join(line.fields, ","));
  return out;
}

/// All rows of the scene, an environment or a parameter.
std::string lines(const tally::Result& result, const std::vector<EchoRow>& rows,
                  std::optional<std::size_t> environment, const std::string& parameter) {
  const std::size_t empty = result.tallies.empty() ? 0 : tally_columns(result).size();
  std::string out;
  for (const EchoRow& row : rows)
    out += line(result, row) + environment_part(result, environment, row) +
           parameter_part(result, parameter, row) + std::string(empty, ',') + '\n';
  return out;
}

std::string echoes(const tally::Result& result) {
  std::string out = head_of_columns(result) + lines(result, echo_rows(result), std::nullopt, "");
  for (std::size_t e = 0; e < result.environment_name.size(); ++e)
    out += lines(result, environment_rows(result, e), e, "");
  for (std::size_t p = 0; p < result.parameter_name.size(); ++p)
    out += lines(result, sensitivity_rows(result, p), std::nullopt, result.parameter_name[p]);
  return out + tallies_beside_echoes(result);
}

}  // namespace

std::string echo_csv(const tally::Result& result) {
  return head(result) + (result.has_echoes() ? echoes(result) : tally_csv(result));
}

void write_csv(const tally::Result& result, const std::string& path, const std::string& keep_as) {
  write_atomically(path, echo_csv(result), keep_as);
}

void write_table(const tally::Result& result, const std::string& path, const std::string& keep_as) {
  const TableLayout full{.max_rows = all_rows, .all_columns = true};
  write_atomically(path, whose(result) + '\n' + echo_table(result, full), keep_as);
}

std::optional<std::uint64_t> photons_in_text(const std::string& path) {
  std::ifstream file(path);
  std::string title, about;
  std::getline(file, title);
  std::getline(file, about);
  const bool ours = title.starts_with("# ") && about.starts_with("# Photic ");
  if (!ours || about.find(", ") != about.find(estimator_word)) return std::nullopt;
  const auto found = about.find(photons_word);
  if (found == std::string::npos) return std::nullopt;
  std::uint64_t photons = 0;
  const char* digits = about.data() + found + std::strlen(photons_word);
  if (std::from_chars(digits, about.data() + about.size(), photons).ec != std::errc{})
    return std::nullopt;
  return photons;
}

}  // namespace photic::io
