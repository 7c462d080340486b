#include "optics/water_absorption.hpp"

namespace photic::optics {
namespace {

constexpr const char* absorption = "water absorption";

Sourced mason_ioccg(const Library& library, double nm, double salinity_psu, double temperature_c) {
  const LinearTable& mason = library.mason_a.values;
  const LinearTable& ioccg = library.ioccg_a.values;
  if (nm < ioccg.min() || nm > mason.max()) {
    no_data(absorption, nm, "Mason 2016 / IOCCG 2018", ioccg.min(), mason.max());
  }
  if (nm < mason.min()) return {ioccg(nm), library.ioccg_a.source};
  // The table is for pure water at 20 C.
  const double a = mason(nm) + library.mason_psi_s.values(nm) * salinity_psu +
                   library.mason_psi_t.values(nm) * (temperature_c - 20.0);
  if (a < 0)
    return {0.0, library.mason_a.source + " (set to 0: negative at this salinity and temperature)"};
  return {a, library.mason_a.source};
}

}  // namespace

Sourced water_absorption_per_m(const Library& library, const std::string& model,
                               double wavelength_nm, double salinity_psu, double temperature_c) {
  if (model == "mason-ioccg")
    return mason_ioccg(library, wavelength_nm, salinity_psu, temperature_c);
  const Spectrum* table = model == "pope-fry"      ? &library.pope_fry_a
                          : model == "ioccg"       ? &library.ioccg_a
                          : model == "smith-baker" ? &library.smith_baker_a
                                                   : nullptr;
  if (table == nullptr) no_model(absorption, model, "mason-ioccg, ioccg, pope-fry, smith-baker");
  return {table->at(wavelength_nm, absorption), table->source};
}

}  // namespace photic::optics
