#include "photic/optics_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "io/netcdf.hpp"
#include "io/oil_text.hpp"
#include "io/optics_file.hpp"
#include "io/optics_table.hpp"
#include "io/spectral_table.hpp"
#include "medium/air_table.hpp"
#include "optics/air_plausibility.hpp"
#include "optics/modtran.hpp"
#include "photic/output.hpp"
#include "photic/tables.hpp"
#include "session/result_file.hpp"

namespace photic::app {
namespace {

namespace fs = std::filesystem;

io::OpticsOrigin origin_of(const ReportSubject& what, const OpticsCommand& command) {
  return {.title = what.title,
          .scene_toml = what.scene_toml,
          .version = PHOTIC_VERSION,
          .history = io::history_line(command.call.line)};
}

/// "5 layers".
std::string count(std::size_t number, const char* noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

/// The line that reports a file that was written.
std::string where_it_is(const OpticsCommand& command, const std::string& what) {
  return fmt::format("{}: {}\n", command.output, what) + plot_hint(command.call, command.output);
}

/// The wavelengths asked for, or those from the ultraviolet of fluorosensors to the red.
std::vector<double> wavelengths_of(const OpticsCommand& command) {
  std::vector<double> nm = command.wavelength_nm;
  for (double each = 300; command.wavelength_nm.empty() && each <= 700; each += 50)
    nm.push_back(each);
  return nm;
}

/// Prints the text, or JSON, or writes the file.
void report(const io::SpectralTable& table, const std::string& text, const std::string& title,
            const OpticsCommand& command) {
  if (!command.output.empty()) {
    io::write_spectral(table, origin_of({title, ""}, command), command.output);
    if (!command.json)
      print_out(
          where_it_is(command, title + " at " + count(table.wavelength_nm.size(), "wavelength")));
  } else if (!command.json) {
    print_out(text);
  }
  if (command.json) print_out(io::spectral_json(table));
}

/// Before anything is computed.
void check_output_of(const std::string& input, const OpticsCommand& command) {
  if (command.output.empty()) return;
  check_optics_output(command.output, "");
  session::spare({input}, command.output);
}

/// A tape6, if nothing else.
optics::AirProfile modtran_air(const std::string& text, const std::string& name) {
  if (!optics::is_tape6(text)) {
    throw InputError({{name, 0, 0,
                       "neither a tape6 of MODTRAN (no block \"ATMOSPHERIC PROFILES\") nor a tape7 "
                       "(no line of names that begins with FREQ)",
                       "the name of a table of levels must end in .csv"}});
  }
  return optics::modtran_profile(text, name);
}

/// A CSV file by its name, another file as a tape6, else one of Photic's atmospheres.
optics::AirProfile air_profile(const optics::AirLibrary& library, const std::string& name) {
  std::error_code none;
  if (session::format_of(name) == session::Format::csv)
    return optics::air_profile(optics::with_all_humidities(optics::DataTable::read(name)));
  if (fs::exists(name, none) || name.find('/') != std::string::npos)
    return modtran_air(optics::read_text(name), name);
  return library.atmosphere(name);
}

/// "O3 TRANS" as "o3_trans".
std::string column_name(const std::string& heading) {
  std::string out;
  for (const unsigned char c : heading)
    out += std::isalnum(c) != 0 ? static_cast<char>(std::tolower(c)) : '_';
  return out;
}

io::SpectralTable transmittances(const optics::ModtranTransmittances& air,
                                 const OpticsCommand& command) {
  io::SpectralTable table{.what = "transmittances of the air that MODTRAN computed"};
  table.wavelength_nm =
      command.wavelength_nm.empty() ? air.wavelengths_nm() : command.wavelength_nm;
  for (const std::string& column : air.columns()) {
    if (column.starts_with("-LOG ")) continue;
    table.columns.push_back({column_name(column), column, "transmittance: " + column, "1", {}});
    for (const double nm : table.wavelength_nm)
      table.columns.back().values.push_back(air.transmittance(column, nm));
  }
  table.sources = {command.air + ", a tape7 of MODTRAN"};
  return table;
}

/// Without the columns that are 1 everywhere, which are named below.
std::string transmittances_text(const io::SpectralTable& table) {
  io::SpectralTable seen = table;
  std::string clear;
  std::erase_if(seen.columns, [&](const io::SpectralTable::Column& column) {
    const bool all_1 = std::ranges::all_of(column.values, [](double t) { return t == 1; });
    if (all_1) clear += (clear.empty() ? "" : ", ") + column.heading;
    return all_1;
  });
  return io::spectral_text(seen) + (clear.empty() ? "" : "\n1 throughout: " + clear + "\n");
}

/// Reports a tape7; refuses options that it has no use for.
void report_tape7(const std::string& text, const OpticsCommand& command) {
  if (command.visibility_km || command.aerosol != OpticsCommand().aerosol)
    throw UsageError(command.air +
                     ": a tape7 holds transmittances, and no profile that aerosols could be added "
                     "to (leave out --visibility and --aerosol, or give a tape6)");
  const io::SpectralTable table =
      transmittances(optics::ModtranTransmittances(text, command.air), command);
  const std::string title = "Transmittances of " + command.air;
  report(table, title + "\n\n" + transmittances_text(table), title, command);
}

/// The text of a file that is a tape7.
std::optional<std::string> tape7(const std::string& file) {
  std::error_code none;
  if (!fs::is_regular_file(file, none) || session::format_of(file) == session::Format::csv)
    return {};
  std::string text = optics::read_text(file);
  return optics::is_tape7(text) ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace

void report(const medium::OpticalTable& table, const ReportSubject& what,
            const OpticsCommand& command) {
  if (!command.output.empty()) {
    const io::OpticsOrigin origin = origin_of(what, command);
    if (session::format_of(command.output) == session::Format::csv)
      io::write_optics_csv(table, origin, command.output);
    else
      io::write_optics_netcdf(table, origin, command.output);
    if (!command.json)
      print_out(where_it_is(command, "the optics of " + count(table.layers(), "layer") + " at " +
                                         count(table.wavelengths(), "wavelength")));
  } else if (!command.json) {
    print_out(io::optics_text(table));
  }
  if (command.json) print_out(io::optics_json(table));
}

int report_oil(const OpticsCommand& command) {
  check_output_of(command.oil, command);
  const optics::Oil oil = optics::oil(*tables(), command.oil);
  const auto nm = wavelengths_of(command);
  report(io::oil_table(oil, nm), io::oil_text(oil, nm), "Oil: " + oil.name, command);
  return done;
}

int report_air(const OpticsCommand& command) {
  check_output_of(command.air, command);
  if (const auto text = tape7(command.air)) {
    report_tape7(*text, command);
    return done;
  }
  const optics::AirLibrary& library = tables()->air();
  optics::AirProfile profile = air_profile(library, command.air);
  for (const auto& remarks : {profile.remarks, optics::doubts_about(profile)})
    for (const std::string& remark : remarks)
      print_error(fmt::format("{}: {}\n", command.air, remark));
  std::string title = "Air: " + command.air;
  if (command.visibility_km) {
    profile = optics::with_aerosols(library, std::move(profile), *command.visibility_km,
                                    optics::AerosolProfiles::seasons.front());
    title +=
        fmt::format(", visibility {:g} km, {} aerosols", *command.visibility_km, command.aerosol);
  }
  optics::AerosolChoice aerosols;
  aerosols.model[optics::boundary_layer] = command.aerosol;
  report(medium::air_table(*tables(), profile, aerosols, wavelengths_of(command)), {title, ""},
         command);
  return done;
}

}  // namespace photic::app
