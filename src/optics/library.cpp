#include "optics/library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "optics/own_data.hpp"

namespace photic::optics {
namespace {

Spectrum spectrum(const std::string& folder, const char* file, const char* column) {
  return own([&] { return Spectrum(own_table(folder, file), column); });
}

Parameters parameters(const std::string& folder, const char* file) {
  return own([&] { return Parameters(own_table(folder, file)); });
}

/// Photic's parameters of Raman scattering, of which the phase function needs one in range.
Parameters raman_parameters(const DataTable& table) {
  Parameters out(table);
  const std::string item = "depolarisation";
  const double share = out.at(item).value;
  const auto items = table.texts("item");
  const auto row = std::find(items.begin(), items.end(), item) - items.begin();
  if (!(share >= 0 && share <= 1))
    table.fail(static_cast<std::size_t>(row), "value", "a depolarisation is from 0 to 1");
  return out;
}

}  // namespace

std::vector<double> wavelengths_of(const DataTable& table, const std::string& column) {
  std::vector<double> nm = table.ascending_numbers(column);
  if (nm.front() <= 0) table.fail(0, column, "a wavelength is above 0");
  if (nm.size() < 2) table.fail(0, column, "a spectrum needs two rows or more");
  return nm;
}

std::string source_of(const DataTable& table) {
  const std::string& status = table.header("STATUS");
  return fmt::format("{} [{}]", table.header("SOURCE"), status.substr(0, status.find(" (")));
}

Spectrum::Spectrum(const DataTable& table, const std::string& column,
                   const std::string& wavelengths)
    : values(wavelengths_of(table, wavelengths), table.numbers(column)), source(source_of(table)) {}

double Spectrum::at(double wavelength_nm, const std::string& quantity) const {
  if (!values.covers(wavelength_nm))
    no_data(quantity, wavelength_nm, source, values.min(), values.max());
  return values(wavelength_nm);
}

void no_data(const std::string& quantity, double wavelength_nm, const std::string& source,
             double min_nm, double max_nm, const char* suggestion) {
  throw InputError({{"", 0, 0,
                     fmt::format("no {} data at {:.6g} nm: {} cover {:g}-{:g} nm", quantity,
                                 wavelength_nm, source, min_nm, max_nm),
                     suggestion}});
}

void no_model(const std::string& quantity, const std::string& model, const std::string& models) {
  throw InputError(
      {{"", 0, 0, fmt::format("no {} model \"{}\"", quantity, model), "there are: " + models}});
}

Parameters::Parameters(const DataTable& table) : name_(table.name()) {
  const auto item = table.texts("item");
  const auto value = table.numbers("value");
  const auto source = table.texts("source");
  const auto status = table.texts("status");
  for (std::size_t i = 0; i < item.size(); ++i) {
    const auto entry = Sourced{value[i], fmt::format("{} [{}]", source[i], status[i])};
    if (!items_.emplace(item[i], entry).second)
      table.fail(i, "item", "\"" + item[i] + "\" appears twice");
  }
}

const Sourced& Parameters::at(const std::string& item) const {
  const auto found = items_.find(item);
  if (found == items_.end()) {
    throw EnvironmentError(
        fmt::format("a data table of Photic is damaged: {}: no item \"{}\"", name_, item));
  }
  return found->second;
}

GaussianBand::GaussianBand(const DataTable& table)
    : weight(table.numbers("weight")),
      centre_per_cm(table.numbers("centre_per_cm")),
      fwhm_per_cm(table.numbers("fwhm_per_cm")),
      source(source_of(table)) {}

double GaussianBand::mean_per_cm() const {
  const double all = std::accumulate(weight.begin(), weight.end(), 0.0);
  return std::inner_product(weight.begin(), weight.end(), centre_per_cm.begin(), 0.0) / all;
}

double GaussianBand::density_cm(double per_cm) const {
  const double c = 4 * std::log(2.0);
  double sum = 0;
  double all = 0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    const double t = (per_cm - centre_per_cm[i]) / fwhm_per_cm[i];
    sum += weight[i] / fwhm_per_cm[i] * std::exp(-c * t * t);
    all += weight[i];
  }
  return sum / (all * std::sqrt(pi / c));
}

Library::Library(const std::string& folder)
    : mason_a(spectrum(folder, "water_mason_2016.csv", "a_per_m")),
      mason_psi_s(spectrum(folder, "water_mason_2016.csv", "psi_s_per_m_psu")),
      mason_psi_t(spectrum(folder, "water_mason_2016.csv", "psi_t_per_m_k")),
      ioccg_a(spectrum(folder, "water_ioccg_2018.csv", "a_per_m")),
      pope_fry_a(spectrum(folder, "water_pope_fry_1997.csv", "a_per_m")),
      smith_baker_a(spectrum(folder, "water_smith_baker_1981.csv", "a_per_m")),
      smith_baker_b(spectrum(folder, "water_smith_baker_1981.csv", "b_sea_per_m")),
      particles_a(spectrum(folder, "particles_bricaud_1998.csv", "a_per_m")),
      particles_e(spectrum(folder, "particles_bricaud_1998.csv", "e")),
      phytoplankton_a(spectrum(folder, "phytoplankton_bricaud_1995.csv", "a_m2_per_mg")),
      phytoplankton_b(spectrum(folder, "phytoplankton_bricaud_1995.csv", "b")),
      relative_a_c(spectrum(folder, "phytoplankton_prieur_sathyendranath_1981.csv", "a_c")),
      petzold(own(
          [&] { return phase_from_table(own_table(folder, "particles_petzold_average.csv")); })),
      raman_band(
          own([&] { return GaussianBand(own_table(folder, "raman_band_walrafen_1967.csv")); })),
      hawes_a0(own([&] {
        return Spectrum(own_table(folder, "cdom_fluorescence_hawes_1992.csv"), "a0_per_nm",
                        "excitation_nm");
      })),
      raman(own([&] { return raman_parameters(own_table(folder, "raman_parameters.csv")); })),
      fluorescence(parameters(folder, "fluorescence_parameters.csv")),
      jerlov(own(
          [&] { return JerlovSpectra(own_table(folder, "jerlov_williamson_hollins_2022.csv")); })),
      oils(own([&] { return oil_properties(own_table(folder, "oils.csv")); })),
      whitecaps_koepke(spectrum(folder, "whitecaps_koepke_1984.csv", "reflectance")),
      whitecaps_frouin(spectrum(folder, "whitecaps_frouin_1996.csv", "relative")),
      air(folder) {}

}  // namespace photic::optics
