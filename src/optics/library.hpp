// The published tables that Photic's optics are made of, read once and never changed.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/interpolation.hpp"
#include "optics/data_table.hpp"
#include "optics/oil.hpp"
#include "optics/phase_from_table.hpp"
#include "optics/phase_table_cache.hpp"
#include "optics/spheres.hpp"

namespace photic::optics {

/// A number and where it comes from: "Author year, journal, table [status]".
struct Sourced {
  double value = 0;
  std::string source;
};

/// "source [status]" of a table, from its header.
std::string source_of(const DataTable& table);

/// The column wavelength_nm of a table: two or more, above 0 and ascending. Throws InputError.
std::vector<double> wavelengths_of(const DataTable& table,
                                   const std::string& column = "wavelength_nm");

/// A column of a table against its wavelengths, with straight lines between.
struct Spectrum {
  Spectrum(const DataTable& table, const std::string& column,
           const std::string& wavelengths = "wavelength_nm");

  LinearTable values;
  std::string source;

  /// The value at a wavelength. Throws InputError "no <quantity> data at … nm: <source> cover …".
  [[nodiscard]] double at(double wavelength_nm, const std::string& quantity) const;
};

/// The InputError for a wavelength without data.
[[noreturn]] void no_data(
    const std::string& quantity, double wavelength_nm, const std::string& source, double min_nm,
    double max_nm,
    const char* suggestion = "choose another wavelength, or give the layer's iop at this one");

/// The InputError for a model that does not exist.
[[noreturn]] void no_model(const std::string& quantity, const std::string& model,
                           const std::string& models);

/// The rows of a table of parameters (item, value, unit, source, status).
class Parameters {
 public:
  explicit Parameters(const DataTable& table);
  [[nodiscard]] const Sourced& at(const std::string& item) const;

 private:
  std::map<std::string, Sourced> items_;
  std::string name_;
};

/// A band of Gaussians, each with its share of the whole.
struct GaussianBand {
  explicit GaussianBand(const DataTable& table);

  std::vector<double> weight, centre_per_cm, fwhm_per_cm;
  std::string source;

  [[nodiscard]] double mean_per_cm() const;
  [[nodiscard]] double density_cm(double per_cm) const;  ///< 1 over all wavenumbers
};

/// Absorption and scattering of Jerlov's types of water [1/m], water included (optics/jerlov.hpp).
struct JerlovSpectra {
  explicit JerlovSpectra(const DataTable& table);

  struct AbsorptionAndScattering {
    Spectrum a, b;
  };
  std::map<std::string, AbsorptionAndScattering> of_type;
};

class AirLibrary;

/// The tables of air (optics/air_library.hpp), read when they are first asked for. May be used by
/// several threads.
class AirLibraryCache {
 public:
  explicit AirLibraryCache(std::string folder) : folder_(std::move(folder)) {}
  /// Throws EnvironmentError for a file that is missing or damaged.
  const AirLibrary& operator()() const;

 private:
  std::string folder_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const AirLibrary> known_;
};

/// All tables. Throws EnvironmentError for a file that is missing or damaged.
class Library {
 public:
  explicit Library(const std::string& folder);

  const Spectrum mason_a, mason_psi_s, mason_psi_t, ioccg_a;  ///< 1/m, 1/m/PSU, 1/m/K, 1/m
  const Spectrum pope_fry_a, smith_baker_a, smith_baker_b;    ///< 1/m
  const Spectrum particles_a, particles_e;                    ///< Bricaud 1998: 1/m, 1
  const Spectrum phytoplankton_a, phytoplankton_b;            ///< Bricaud 1995: m2/mg, 1
  const Spectrum relative_a_c;                                ///< Prieur & Sathyendranath 1981
  const TabulatedPhase petzold;
  const GaussianBand raman_band;
  const Spectrum hawes_a0;  ///< 1/nm against the exciting wavelength
  const Parameters raman, fluorescence;
  const JerlovSpectra jerlov;
  const std::vector<OilProperty> oils;
  const Spectrum whitecaps_koepke, whitecaps_frouin;  ///< reflectance; over that at short waves

  const SpheresCache spheres;  ///< no table: what Mie theory gives, computed once
  /// Nor these, of phase functions. Airs that were made by this library go on using it.
  const std::shared_ptr<const PhaseTableCache> phases = std::make_shared<const PhaseTableCache>();
  const AirLibraryCache air;
};

}  // namespace photic::optics
