#include "optics/oil.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "optics/library.hpp"

namespace photic::optics {
namespace {

/// The items of a class, in the order of messages.
constexpr const char* items[] = {"refractive_index", "absorption_337_nm", "absorption_slope",
                                 "emission_peak",    "emission_fwhm",     "quantum_yield",
                                 "lifetime"};

/// The range in which the formulas of a class are taken as good.
constexpr double class_min_nm = 200, class_max_nm = 1100;

const OilProperty* find(const std::vector<OilProperty>& all, const std::string& oil,
                        const std::string& item) {
  const auto found = std::ranges::find_if(
      all, [&](const OilProperty& p) { return p.oil == oil && p.item == item; });
  return found == all.end() ? nullptr : &*found;
}

void check(const std::vector<OilProperty>& all, const DataTable& table) {
  const std::size_t last = all.size() - 1;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const OilProperty& p = all[i];
    if (std::ranges::find(items, p.item) == std::end(items))
      table.fail(i, "item", fmt::format("no property of oil \"{}\"", p.item),
                 fmt::format("there are: {}", fmt::join(items, ", ")));
    if (find(all, p.oil, p.item) != &p)
      table.fail(i, "item", fmt::format("\"{}\" of {} appears twice", p.item, p.oil));
    if (!(p.low <= p.value && p.value <= p.high))
      table.fail(i, "value", fmt::format("{} is not from {} to {}", p.value, p.low, p.high));
    for (const char* item : items)
      if (find(all, p.oil, item) == nullptr)
        table.fail(last, "item", fmt::format("\"{}\" of {} is missing", item, p.oil));
  }
}

/// A formula within the range of the classes.
OilSpectrum of_class(const char* quantity, const std::string& source,
                     const std::function<double(double)>& formula) {
  return [=](double nm) {
    if (!(nm >= class_min_nm && nm <= class_max_nm))
      no_data(fmt::format("oil {}", quantity), nm, source, class_min_nm, class_max_nm,
              "choose another wavelength, or give the spectra of the oil in a file");
    return formula(nm);
  };
}

double sigma_of_fwhm(double fwhm_nm) { return fwhm_nm / (2 * std::sqrt(2 * std::log(2.0))); }

OilSpectrum gaussian_per_nm(double peak_nm, double fwhm_nm) {
  const double sigma = sigma_of_fwhm(fwhm_nm);
  return [=](double nm) {
    const double t = (nm - peak_nm) / sigma;
    return std::exp(-t * t / 2) / (std::sqrt(2 * pi) * sigma);
  };
}

Oil oil_of_class(const std::vector<OilProperty>& all, const std::string& name) {
  const auto property = [&](const char* item) { return *find(all, name, item); };
  const auto index = property("refractive_index"), absorption = property("absorption_337_nm");
  const double slope = property("absorption_slope").value;
  Oil out;
  out.name = name;
  out.refractive_index =
      of_class("refractive index", index.source, [n = index.value](double) { return n; });
  out.absorption_per_m = of_class(
      "absorption", absorption.source,
      [a = absorption.value, slope](double nm) { return a * std::exp(-slope * (nm - 337)); });
  out.emission_per_nm =
      gaussian_per_nm(property("emission_peak").value, property("emission_fwhm").value);
  constexpr double sigmas = 4.5;  // 7e-6 lie beyond
  const double reach = sigmas * sigma_of_fwhm(property("emission_fwhm").value);
  out.emission_min_nm = std::max(class_min_nm, property("emission_peak").value - reach);
  out.emission_max_nm = std::min(class_max_nm, property("emission_peak").value + reach);
  out.yield = property("quantum_yield").value;
  out.lifetime_ns = property("lifetime").value;
  for (const char* item : items) out.properties.push_back(property(item));
  return out;
}

/// Straight lines between values that are 1 in all; 0 outside. Oil that does not shine has 0
/// everywhere, or no such column.
OilSpectrum emission_of_table(const DataTable& table, const std::vector<double>& nm, double yield) {
  constexpr const char* column = "emission_per_nm";
  if (yield == 0 && !table.has(column)) return [](double) { return 0.0; };
  if (!table.has(column))
    table.fail_columns(table.lack_of(column),
                       table.what_there_is() + "; with a yield of 0 it is not needed");
  auto values = table.numbers_from_0(column);
  double sum = 0;
  for (std::size_t i = 1; i < nm.size(); ++i)
    sum += (values[i - 1] + values[i]) / 2 * (nm[i] - nm[i - 1]);
  if (yield == 0 && sum == 0) return [](double) { return 0.0; };
  if (!(sum > 0 && std::isfinite(sum)))
    table.fail(0, column, "an emission spectrum has an integral above 0",
               "of oil that does not shine the yield is 0");
  for (double& value : values) value /= sum;
  const LinearTable emission(nm, values);
  return [=](double at) { return emission.covers(at) ? emission(at) : 0.0; };
}

OilSpectrum column_of(const DataTable& table, const std::vector<double>& nm, const char* column,
                      const char* quantity) {
  const LinearTable values(nm, table.numbers_from_0(column));
  return [values, quantity, file = table.name()](double at) {
    if (!values.covers(at))
      no_data(fmt::format("oil {}", quantity), at, "given in " + file, values.min(), values.max(),
              "choose another wavelength, or a table that reaches it");
    return values(at);
  };
}

Oil oil_of_file(const DataTable& table) {
  const double yield = table.number_in_header("yield");
  return oil_of_table(table, yield, table.number_in_header("lifetime_ns"));
}

}  // namespace

Oil oil_of_table(const DataTable& table, double yield, double lifetime_ns) {
  const auto nm = wavelengths_of(table);
  constexpr const char* index_column = "n";
  const auto index = table.numbers(index_column);
  for (std::size_t i = 0; i < index.size(); ++i)
    if (index[i] < 1) table.fail(i, index_column, "a refractive index is 1 or more");
  const std::string source = "given in " + table.name();
  const auto number = [&](double value, const char* item, const char* unit) {
    return OilProperty{table.name(), item, value, value, value, unit, source};
  };
  Oil out;
  out.name = table.name();
  out.refractive_index = column_of(table, nm, index_column, "refractive index");
  out.absorption_per_m = column_of(table, nm, "a_per_m", "absorption");
  out.emission_per_nm = emission_of_table(table, nm, yield);
  out.emission_min_nm = nm.front();
  out.emission_max_nm = nm.back();
  out.properties = {number(yield, "quantum_yield", "1"), number(lifetime_ns, "lifetime", "ns")};
  out.yield = yield;
  out.lifetime_ns = lifetime_ns;
  if (out.yield > 1)
    throw InputError({{table.name(), 0, 0, fmt::format("yield is {}", out.yield),
                       "it counts photons emitted per photon absorbed: 1 at most"}});
  return out;
}

EmissionSpectrum emission_above(const Oil& oil, double laser_nm) {
  constexpr double nodes_apart_nm = 1;
  const double first = std::max(laser_nm, oil.emission_min_nm), last = oil.emission_max_nm;
  if (!(first < last)) return {};
  const auto steps = static_cast<int>(std::ceil((last - first) / nodes_apart_nm));
  std::vector<double> nm, per_nm;
  for (int i = 0; i <= steps; ++i) {
    nm.push_back(std::lerp(first, last, static_cast<double>(i) / steps));
    per_nm.push_back(oil.emission_per_nm(nm.back()));
  }
  const double all = EmissionSpectrum(nm, per_nm).photons(first, last);
  if (!(all > 0)) return {};
  for (double& density : per_nm) density *= oil.yield / all;
  return {nm, per_nm};
}

std::vector<OilProperty> oil_properties(const DataTable& table) {
  const auto oil = table.texts("class"), item = table.texts("item"), unit = table.texts("unit"),
             source = table.texts("source"), status = table.texts("status");
  const auto value = table.numbers_from_0("value"), low = table.numbers_from_0("low"),
             high = table.numbers_from_0("high");
  std::vector<OilProperty> out;
  for (std::size_t i = 0; i < table.rows(); ++i)
    out.push_back({oil[i], item[i], value[i], low[i], high[i], unit[i],
                   fmt::format("{} [{}]", source[i], status[i])});
  check(out, table);
  return out;
}

std::vector<std::string> list_oils(const Library& library) {
  std::vector<std::string> names;
  for (const OilProperty& p : library.oils)
    if (std::ranges::find(names, p.oil) == names.end()) names.push_back(p.oil);
  return names;
}

Oil oil(const Library& library, const std::string& name_or_file) {
  const auto names = list_oils(library);
  if (std::ranges::find(names, name_or_file) != names.end())
    return oil_of_class(library.oils, name_or_file);
  if (name_or_file.ends_with(".csv")) return oil_of_file(DataTable::read(name_or_file));
  no_model("oil", name_or_file, fmt::format("{}, or a file .csv", fmt::join(names, ", ")));
}

}  // namespace photic::optics
