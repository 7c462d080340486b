// First-order echoes of whole runs against the lidar equation integrated over every gate.
#include "analytic/first_order.hpp"
#include "optics/fournier_forand.hpp"

namespace photic::test {
namespace {

// Seen red: with n^2 left out of the refraction factor; with half for full divergence; with the
// refractive index for the group index on the way out, or on the way home; with nothing reflected
// where light leaves the water; with 1 % too much in c / c', or in the absorption along the way;
// with further points of a flight drawn too often where its free path is long.
TEST(FirstOrder, FlatSea) {
  compare(ship_instrument + channel("elastic") +
              water(0.03, 0.03, "{ model = \"henyey-greenstein\", g = 0.6 }") + depth_gates(50, 2),
          {shape(optics::henyey_greenstein(0.6))});
}

// Where a walk meets the laser's rays though it does not collide once. The forward estimator does
// not see anything there. Seen red: with echoes of batches below 1e-12 taken for none.
TEST(FirstOrder, WaterThatHardlyScatters) {
  for (const double per_m : {1e-7, 1e-12})
    compare(ship_instrument + channel("elastic") +
                water(per_m, per_m, "{ model = \"henyey-greenstein\", g = 0.6 }") +
                depth_gates(50, 5),
            {shape(optics::henyey_greenstein(0.6))}, {bidirectional});
}

// Seen red: with the obstruction left out of the lens' area, or of its image; with the blur of an
// infinitely far point; with a free path that crosses one edge at most; with the rest of a free
// path, or the absorption along it, by the coefficient of the layer it began in.
TEST(FirstOrder, ThreeLayersAndThreeTelescopes) {
  compare(ship_instrument + R"(
[[telescope]]
name = "aside, obstructed, defocused"
position_m = [0.5, -0.3, 12.0]
direction = [-0.02, 0.012, -1.0]
diameter_m = 0.40
focal_length_m = 1.0
detector_diameter_m = 0.06
detector_shift_m = 0.02
obstruction_diameter_m = 0.15
[[telescope]]
name = "wide, higher"
position_m = [0.0, 1.0, 20.0]
direction = [0.0, -0.02, -1.0]
diameter_m = 0.30
focal_length_m = 1.0
half_field_of_view_mrad = 80.0
)" + channel("elastic") +
              R"(
[[sea.layer]]
bottom_depth_m = 7.3
iop = [ { wavelength_nm = 532.0, a_per_m = 0.02, b_per_m = 0.04 } ]
phase_function = { model = "fournier-forand", refractive_index = 1.10, slope = 3.5835 }
[[sea.layer]]
bottom_depth_m = 21.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.04, b_per_m = 0.02 } ]
phase_function = { model = "fournier-forand", refractive_index = 1.10, slope = 3.5835 }
[[sea.layer]]
iop = [ { wavelength_nm = 532.0, a_per_m = 0.01, b_per_m = 0.05 } ]
phase_function = { model = "fournier-forand", refractive_index = 1.10, slope = 3.5835 }
[gates]
depth_max_m = 50.0
depth_step_m = 2.5
)",
          {shape(optics::fournier_forand(1.10, 3.5835))});
}

// Seen red: with the laser's wavelength for the emitted one in the optical depth, the refractive
// index or the group index of the way home; with the refractive index for the group index on the
// way out; with converted light taken for scattered.
TEST(FirstOrder, RamanAndFluorescenceHaveTwoWavelengths) {
  const auto lambert = [](double) { return 1 / (4 * pi); };
  compare(ship_instrument + channel("elastic") + channel("raman") + channel("chlorophyll") + R"(
[[sea.layer]]
bottom_depth_m = 10.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.03, b_per_m = 0.03, a_phytoplankton_per_m = 0.01 },
        { wavelength_nm = 700.0, a_per_m = 0.10, b_per_m = 0.02 } ]
phase_function = { model = "rayleigh", depolarisation = 0.039 }
[[sea.layer]]
iop = [ { wavelength_nm = 532.0, a_per_m = 0.04, b_per_m = 0.02, a_phytoplankton_per_m = 0.005 },
        { wavelength_nm = 700.0, a_per_m = 0.15, b_per_m = 0.01 } ]
phase_function = { model = "rayleigh", depolarisation = 0.039 }
[gates]
depth_max_m = 50.0
depth_step_m = 2.5
)",
          {shape(optics::rayleigh(0.039)), shape(optics::raman_phase(0.17)), lambert});
}

// Light that is spread over its spectra: the equation adds up all lines, each with its own way
// home. Two walks of the laser and of the telescope in a set. Seen red: with spectral_bins that are
// made up for as if all lines of a band had as many.
TEST(FirstOrder, Spectra) {
  const auto lambert = [](double) { return 1 / (4 * pi); };
  auto instrument = ship_instrument;
  instrument.replace(instrument.find("532.0"), 5, "450.0");
  compare(instrument + channel("raman") + channel("chlorophyll") + R"(
[[channel]]
name = "filter"
centre_nm = 650.0
fwhm_nm = 30.0
filter = "gaussian"
[optics]
emission = "spectra"
[[sea.layer]]
bottom_depth_m = 6.0
iop = [ { wavelength_nm = 440.0, a_per_m = 0.09, b_per_m = 0.03, a_phytoplankton_per_m = 0.02, a_cdom_per_m = 0.04 },
        { wavelength_nm = 600.0, a_per_m = 0.25, b_per_m = 0.02 },
        { wavelength_nm = 760.0, a_per_m = 1.20, b_per_m = 0.02 } ]
phase_function = { model = "rayleigh", depolarisation = 0.039 }
[[sea.layer]]
iop = [ { wavelength_nm = 440.0, a_per_m = 0.06, b_per_m = 0.02, a_phytoplankton_per_m = 0.01, a_cdom_per_m = 0.01 },
        { wavelength_nm = 600.0, a_per_m = 0.22, b_per_m = 0.01 },
        { wavelength_nm = 760.0, a_per_m = 1.20, b_per_m = 0.01 } ]
phase_function = { model = "rayleigh", depolarisation = 0.039 }
[gates]
depth_max_m = 12.0
depth_step_m = 4.0
)",
          {shape(optics::raman_phase(0.17)), lambert, lambert},
          {{simulation(4e6, 7, "max_order = 1\norders_kept = 1\nreception = \"overlap\""), 0.02,
            0.03, true},
           {simulation(4e5, 7, "max_order = 1\norders_kept = 1\nwalks = 2", "bidirectional"), 0.03,
            0.05, false}});
}

// Seen red: with the refractive index for the group index on the way out, or on the way home; with
// 1 % too much in c / c'; with the absorption across an edge by the coefficient of the layer it
// began in.
TEST(FirstOrder, Submerged) {
  compare(R"(
[source]
wavelength_nm = 532.0
position_m = [0.0, 0.0, -5.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.02
half_divergence_mrad = 3.0
[[telescope]]
position_m = [0.15, 0.0, -5.0]
direction = [0.0, 0.0, -1.0]
diameter_m = 0.20
focal_length_m = 0.5
half_field_of_view_mrad = 60.0
)" + channel("elastic") +
              R"(
[[sea.layer]]
bottom_depth_m = 12.0
iop = [ { wavelength_nm = 532.0, a_per_m = 0.03, b_per_m = 0.03 } ]
phase_function = { model = "henyey-greenstein", g = 0.3 }
[[sea.layer]]
iop = [ { wavelength_nm = 532.0, a_per_m = 0.05, b_per_m = 0.04 } ]
phase_function = { model = "henyey-greenstein", g = 0.3 }
[gates]
depth_min_m = 8.0
depth_max_m = 40.0
depth_step_m = 2.0
)",
          {shape(optics::henyey_greenstein(0.3))});
}

}  // namespace
}  // namespace photic::test
