#include "optics/air_library.hpp"

#include <algorithm>

#include "optics/own_data.hpp"

namespace photic::optics {
namespace {

constexpr const char* atmospheres[] = {"us-standard",        "tropical",
                                       "midlatitude-summer", "midlatitude-winter",
                                       "subarctic-summer",   "subarctic-winter"};
constexpr const char* models[] = {"rural",         "maritime",      "urban",         "tropospheric",
                                  "fog-advection", "fog-radiation", "stratospheric", "meteoric"};

/// The name of a file of one kind: "midlatitude-summer" is in atmosphere_midlatitude_summer.csv.
std::string file_of(const std::string& kind, std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return kind + "_" + name + ".csv";
}

Spectrum ozone(const std::string& folder, const char* file, const char* column) {
  const DataTable table = own_table(folder, file);
  return own([&] { return Spectrum(table, column); });
}

std::map<std::string, AirProfile> read_atmospheres(const std::string& folder) {
  std::map<std::string, AirProfile> out;
  for (const char* name : atmospheres) {
    const DataTable table = own_table(folder, file_of("atmosphere", name));
    out[name] = own([&] { return air_profile(table); });
    out[name].source = own([&] { return source_of(table); });
  }
  return out;
}

std::map<std::string, AerosolModel> read_models(const std::string& folder) {
  std::map<std::string, AerosolModel> out;
  for (const char* name : models) {
    const DataTable table = own_table(folder, file_of("aerosols", name));
    out.emplace(name, own([&] { return AerosolModel(table); }));
  }
  return out;
}

}  // namespace

AirLibrary::AirLibrary(const std::string& folder)
    : ozone_c0(ozone(folder, "ozone_molina_1986.csv", "c0")),
      ozone_c1(ozone(folder, "ozone_molina_1986.csv", "c1")),
      ozone_c2(ozone(folder, "ozone_molina_1986.csv", "c2")),
      ozone_293k(ozone(folder, "ozone_serdyuchenko_2014.csv", "cross_section_cm2")),
      aerosol_profiles(
          own([&] { return AerosolProfiles(own_table(folder, "aerosols_profiles.csv")); })),
      aerosols(read_models(folder)),
      opac(own([&] {
        return Opac(own_table(folder, "opac_refractive_index.csv"),
                    own_table(folder, "opac_sizes.csv"));
      })),
      atmospheres_(read_atmospheres(folder)) {}

const AirLibrary& AirLibraryCache::operator()() const {
  const std::scoped_lock lock(mutex_);
  if (!known_) known_ = std::make_shared<const AirLibrary>(folder_);
  return *known_;
}

const AirProfile& AirLibrary::atmosphere(const std::string& name) const {
  const auto found = atmospheres_.find(name);
  if (found == atmospheres_.end()) {
    no_model("atmosphere", name,
             "us-standard, tropical, midlatitude-summer, midlatitude-winter, subarctic-summer, "
             "subarctic-winter, or a file: levels in a .csv, a tape6 or tape7 of MODTRAN");
  }
  return found->second;
}

}  // namespace photic::optics
