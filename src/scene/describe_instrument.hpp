// The keys of [source], [[telescope]] and [[channel]]: name, type, range, meaning, each given once.
// Visited by reader.hpp, writer.hpp and schema_builder.hpp.
#pragma once

#include "scene/channel_steps.hpp"
#include "scene/rules.hpp"
#include "scene/scene.hpp"
#include "scene/visitor.hpp"

namespace photic::scene {

inline constexpr double quarter_turn_mrad = 500.0 * pi;

inline constexpr const char* place_meaning =
    "the centre of a disc, else the place of the source [x, y, z] in m; z is up, the sea level is "
    "0";
inline constexpr const char* light_meaning =
    "the direction of the light, or the axis of its cone [x, y, z]; need not be normalised";

template <class V>
void describe_place(V& v, Source& s) {
  v.required("position_m", s.position_m, Position{}, place_meaning);
  v.required("direction", s.direction, Direction{}, light_meaning);
}

template <class V>
void describe_power(V& v, Source& s) {
  v.optional("power_w", s.power_w, positive, "the power of all of its light in W");
}

template <class V>
void describe_laser(V& v, Source& s) {
  describe_place(v, s);
  v.required("diameter_m", s.diameter_m, positive, "the diameter of the disc in m");
  v.required("half_divergence_mrad", s.half_divergence_mrad,
             Number{.low = 0.0, .high = quarter_turn_mrad, .high_open = true},
             "the angle between the axis and the edge of the beam in mrad");
  v.optional("profile", s.profile, ChoiceOf<SourceProfile>{},
             "the light by its angle to the axis, and by its place on the disc");
  v.one_of(option(!s.photons_per_pulse.has_value(),
                  [&](auto& w) {
                    w.optional("energy_j", s.energy_j, positive, "the energy of a pulse in J");
                  }),
           option(s.photons_per_pulse.has_value(), [&](auto& w) {
             w.required("photons_per_pulse", s.photons_per_pulse, positive,
                        "the photons of a pulse, in place of its energy");
           }));
}

template <class V>
void describe_beam(V& v, Source& s) {
  v.one_of(
      option(!s.zenith_deg.has_value(),
             [&](auto& w) { w.required("direction", s.direction, Direction{}, light_meaning); }),
      option(s.zenith_deg.has_value(), [&](auto& w) {
        w.required("zenith_deg", s.zenith_deg,
                   Number{.low = 0.0,
                          .high = 90.0,
                          .high_open = true,
                          .advice = "a sun at 90 degrees or more is below the horizon"},
                   "where the light comes from, in degrees from straight up");
        w.optional("azimuth_deg", s.azimuth_deg, from_to(-360.0, 360.0),
                   "the azimuth that it comes from, in degrees from +x to +y: 0 is from +x");
      }));
  v.once_read([&] { s.is_everywhere = true; });
  v.one_of(option(!s.is_everywhere,
                  [&](auto& w) {
                    w.required("position_m", s.position_m, Position{}, place_meaning);
                    w.optional("diameter_m", s.diameter_m, not_negative,
                               "the diameter of the disc in m; 0: a pencil");
                    describe_power(w, s);
                    w.once_read([&] { s.is_everywhere = false; });
                  }),
           option(s.is_everywhere, [&](auto& w) {
             w.optional("irradiance_w_m2", s.irradiance_w_m2, positive,
                        "the irradiance across the beam, not on the horizontal, in W/m2");
           }));
}

template <class V>
void describe(V& v, Source& s) {
  using enum SourceKind;
  v.optional("kind", s.kind, ChoiceOf<SourceKind>{}, "the kind of light source");
  v.required("wavelength_nm", s.wavelength_nm, Wavelength{}, "the wavelength of its light in nm");
  v.by_choice(
      "kind", s.kind, for_choice(laser, [&](auto& w) { describe_laser(w, s); }),
      for_choice(beam, [&](auto& w) { describe_beam(w, s); }),
      for_choice(point,
                 [&](auto& w) {
                   describe_place(w, s);
                   describe_power(w, s);
                 }),
      for_choice(cone, [&](auto& w) {
        describe_place(w, s);
        w.required(
            "half_angle_deg", s.half_angle_deg,
            Number{
                .low = 0.0, .high = 180.0, .low_open = true, .advice = "180 is light to all sides"},
            "the angle between the axis and the edge of the cone in degrees; 180: "
            "light to all sides");
        describe_power(w, s);
      }));
}

template <class V>
void describe(V& v, Telescope& t) {
  v.optional("name", t.name, Text{}, "what results call it; by default telescope0, telescope1 …");
  v.required("position_m", t.position_m, Position{},
             "the centre of the lens [x, y, z] in m; z is up, the sea level is 0");
  v.required("direction", t.direction, Direction{},
             "where the telescope looks [x, y, z]; need not be normalised");
  v.required("diameter_m", t.diameter_m, positive, "the diameter of the lens in m");
  v.required("focal_length_m", t.focal_length_m, positive, "the focal length of the lens in m");
  v.one_of(option(t.detector_diameter_m.has_value(),
                  [&](auto& w) {
                    w.required("detector_diameter_m", t.detector_diameter_m, positive,
                               "the diameter of the round detector in m");
                  }),
           option(t.half_field_of_view_mrad.has_value(), [&](auto& w) {
             w.required("half_field_of_view_mrad", t.half_field_of_view_mrad,
                        between(0.0, quarter_turn_mrad),
                        "the angle from the axis whose image in the focal plane is the detector's "
                        "rim, in mrad");
           }));
  v.one_of(option(!t.focus_m.has_value(),
                  [&](auto& w) {
                    w.optional("detector_shift_m", t.detector_shift_m, any_number,
                               "the detector's distance from the focal plane in m, positive away "
                               "from the lens");
                  }),
           option(t.focus_m.has_value(), [&](auto& w) {
             w.required("focus_m", t.focus_m, positive,
                        "the distance from the lens that the detector sees sharp, in m; it puts "
                        "the detector behind the focal plane");
           }));
  v.optional("obstruction_diameter_m", t.obstruction_diameter_m, not_negative,
             "the diameter of the round obstruction at the centre of the lens in m");
}

template <class V>
void describe(V& v, Channel& c) {
  v.required("name", c.name, Text{}, "what results call it");
  v.one_of(option(c.process.has_value(),
                  [&](auto& w) {
                    w.required("process", c.process, ChoiceOf<Process>{},
                               "count all light of this process");
                  }),
           option(c.centre_nm.has_value(),
                  [&](auto& w) {
                    w.required(
                        "centre_nm", c.centre_nm, WavelengthOrSteps{},
                        "count light that passes a filter of this centre in nm; { from, to, step } "
                        "makes a channel at each step");
                    w.required("fwhm_nm", c.fwhm_nm, positive,
                               "the filter's full width at half maximum in nm");
                    w.optional("filter", c.filter, ChoiceOf<FilterShape>{},
                               "the shape of its transmission, 1 at the centre");
                  }),
           option(c.transmission.has_value(), [&](auto& w) {
             w.required("transmission_file", c.transmission,
                        TableOrFile{{{"wavelength_nm", "wavelengths in nm, ascending"},
                                     {"transmission", "the transmission there, from 0 to 1"}}},
                        "count light that passes a filter given by a CSV file of wavelength_nm, "
                        "transmission, or by a table of these");
           }));
}

}  // namespace photic::scene
