// Oil: how it refracts, absorbs and fluoresces. Films scatter next to nothing: c = a.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "optics/data_table.hpp"
#include "optics/emission.hpp"

namespace photic::optics {

class Library;

/// A number of an oil, with the range that its source gives; low = value = high if it gives none.
struct OilProperty {
  std::string oil, item;
  double value = 0, low = 0, high = 0;
  std::string unit, source;
};

/// The rows of a table of classes of oil: each class has all items, once. Throws InputError.
std::vector<OilProperty> oil_properties(const DataTable& table);

/// A function of the wavelength [nm].
using OilSpectrum = std::function<double(double)>;

struct Oil {
  std::string name;
  OilSpectrum refractive_index;  ///< against air; throws InputError outside its data, as do all
  OilSpectrum absorption_per_m;
  OilSpectrum emission_per_nm;  ///< photons, 1 in all, isotropic, whatever the exciting wavelength
  double emission_min_nm = 0, emission_max_nm = 0;  ///< next to nothing outside
  double yield = 0;                                 ///< photons emitted per photon absorbed
  double lifetime_ns = 0;
  std::vector<OilProperty> properties;  ///< its parts, for people to read
};

/// The names of Photic's classes.
std::vector<std::string> list_oils(const Library& library);

/// A class by its name, or a user's CSV file: lines "# yield: …" and "# lifetime_ns: …", columns
/// wavelength_nm (ascending), n, a_per_m and emission_per_nm, which is relative and scaled to 1
/// photon, or 0 or not there where the yield is 0. Between the rows are straight lines; outside it
/// emits nothing and the rest is an error. Throws InputError.
Oil oil(const Library& library, const std::string& name_or_file);
/// The oil of such a table. Throws InputError.
Oil oil_of_table(const DataTable& table, double yield, double lifetime_ns);

/// Photons that an oil emits per photon of the laser's that it absorbs. None has a shorter
/// wavelength than the laser's: the spectrum is cut there, and the rest scaled so that the yield
/// stays. Empty if nothing is left.
EmissionSpectrum emission_above(const Oil& oil, double laser_nm);

}  // namespace photic::optics
