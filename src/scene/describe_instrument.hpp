// The keys of [source], [[telescope]] and [[channel]]: name, type, range, meaning, each given once.
// Visited by reader.hpp, writer.hpp and schema_builder.hpp.
#pragma once

#include "scene/channel_steps.hpp"
#include "scene/rules.hpp"
#include "scene/scene.hpp"
#include "scene/visitor.hpp"

namespace photic::scene {

inline constexpr double quarter_turn_mrad = 500.0 * pi;

template <class V>
void describe(V& v, Source& s) {
  v.optional("kind", s.kind,
             Choice{{{"laser", "a disc that emits light uniformly into a cone"}},
                    {"beam", "point", "cone"}},
             "the kind of light source");
  v.required("wavelength_nm", s.wavelength_nm, Wavelength{}, "the wavelength of its light in nm");
  v.required("position_m", s.position_m, Position{},
             "the centre of the laser's disc [x, y, z] in m; z is up, the sea level is 0");
  v.required("direction", s.direction, Direction{},
             "the direction of the light [x, y, z]; need not be normalised");
  v.required("diameter_m", s.diameter_m, positive, "the diameter of the laser's disc in m");
  v.required("half_divergence_mrad", s.half_divergence_mrad,
             Number{.low = 0.0, .high = quarter_turn_mrad, .high_open = true},
             "the angle between the axis and the edge of the beam in mrad");
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
