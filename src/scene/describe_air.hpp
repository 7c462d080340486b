// The keys of [atmosphere] and [[atmosphere.layer]] (see describe_instrument.hpp).
#pragma once

#include "optics/aerosol_profiles.hpp"
#include "scene/air_levels.hpp"
#include "scene/describe_sea.hpp"

namespace photic::scene {

template <class V>
void describe_air_iop(V& v, IopEntry& i) {
  v.required("wavelength_nm", i.wavelength_nm, Wavelength{}, "the wavelength in nm");
  v.required("a_per_m", i.a_per_m, not_negative, "the absorption coefficient in 1/m");
  v.required("b_per_m", i.b_per_m, not_negative, "the scattering coefficient in 1/m");
}

template <class V>
void describe(V& v, AirLayer& l) {
  v.optional("name", l.name, Text{}, "what messages and --set call it; by default air0, air1 …");
  v.required("bottom_height_m", l.bottom_height_m, not_negative,
             "the height of the layer's lower end above the sea in m: the top of the one below it, "
             "0 for the first one");
  v.required("top_height_m", l.top_height_m, positive, "the height of its upper end in m");
  v.tables("iop", l.iop, "absorption and scattering by ascending wavelength",
           [](auto& inner, IopEntry& entry) { describe_air_iop(inner, entry); });
  v.table_or_word("phase_function", l.phase_function, model_key,
                  "the phase function of all scattering; by default that of the air's molecules");
  v.optional(expert("refractive_index"), l.refractive_index, from_to(1.0, 2.0),
             "the refractive index, at all wavelengths");
}

/// The levels of a profile.
inline TableOrFile air_levels_rule() {
  const char* region = "the extinction by the region's aerosols at 550 nm in 1/km; else 0";
  return {{{"z_km", "altitudes above the sea in km, ascending from 0"},
           {"p_hpa", "the pressure in hPa"},
           {"t_k", "the temperature in K"},
           {"air_per_cm3", "molecules of air per cm3; else those of an ideal gas", true},
           {"ozone_per_cm3", "molecules of ozone per cm3; else 0", true},
           {"relative_humidity_percent", "the relative humidity in per cent; else 0", true},
           {"water_vapour_per_cm3", "molecules of water per cm3, in place of the humidity", true},
           {"boundary_layer_per_km", region, true},
           {"troposphere_per_km", region, true},
           {"stratosphere_per_km", region, true},
           {"upper_atmosphere_per_km", region, true}},
          read_air_levels};
}

template <class V>
void describe(V& v, AirGases& g) {
  v.required("top_km", g.top_km, positive, "the height of the rung above the sea in km");
  v.required("file", g.depth,
             TableOrFile{{{"wavelength_nm", "wavelengths in nm, ascending"},
                          {"optical_depth", "from the sea straight up to the rung"}},
                         read_gas_depths},
             "a tape7 of LOWTRAN 7 or MODTRAN with the transmittances of that way, a CSV file of "
             "wavelength_nm, optical_depth, or a table of these");
}

template <class V>
void describe_profile(V& v, Atmosphere& a) {
  v.required("profile", a.profile,
             WordOrTable{{{{"us-standard", "the US standard atmosphere of 1976"},
                           {"tropical", "15 degrees north"},
                           {"midlatitude-summer", "45 degrees north in July"},
                           {"midlatitude-winter", "45 degrees north in January"},
                           {"subarctic-summer", "60 degrees north in July"},
                           {"subarctic-winter", "60 degrees north in January"}}},
                         air_levels_rule()},
             "the air by altitude: one of AFGL's six (Anderson et al. 1986), a CSV file of levels, "
             "a tape6 of LOWTRAN 7 or MODTRAN, or a table of the columns of a CSV");
  v.optional("aerosol", a.aerosol, Text{},
             "the aerosols of the lowest 2 km: rural, maritime, urban, tropospheric, "
             "fog-advection, fog-radiation, or a component of OPAC, as opac-waso-80; none: no "
             "aerosols at all");
  v.optional("visibility_km", a.visibility_km,
             from_to(optics::lowest_visibility_km, optics::highest_visibility_km),
             "the visibility at the sea in km, which sets how much aerosol there is; by default "
             "23, or the aerosols of the profile's own levels");
  v.optional(
      "aerosol_optical_depth_550", a.aerosol_optical_depth_550,
      from_to(0.0, optics::max_aerosol_depth),
      "the vertical optical depth of all aerosols at 550 nm from the sea to top_km, in place "
      "of the visibility: it scales the aerosols of the lowest 2 km");
  v.optional(expert("season"), a.season,
             Choice{{{"spring-summer", "LOWTRAN 7's profile of these seasons"},
                     {"fall-winter", "that of the others"}}},
             "the season of the aerosols above the lowest 2 km");
  v.optional(expert("relative_humidity_percent"), a.relative_humidity_percent, from_to(0.0, 100.0),
             "the relative humidity at levels up to 2 km in per cent, in which aerosols swell; by "
             "default the profile's");
  v.optional("top_km", a.top_km, positive, "where the air ends, in km above the sea");
  v.sections(expert("gases"), a.gases, Need::optional,
             "absorption by gases other than ozone, up to one height after the other");
}

template <class V>
void describe(V& v, Ground& g) {
  v.optional(expert("kind"), g.kind, ChoiceOf<GroundKind>{}, "how the ground reflects light");
  v.by_choice("kind", g.kind, for_choice(GroundKind::lambert, [&](auto& w) {
                w.required("albedo", g.albedo,
                           albedo_rule("zenith angles of the incident light, in degrees, ascending "
                                       "from 0 to 90"),
                           "the share of the light that the ground reflects, as a Lambert "
                           "reflector: a number, a table of wavelength_nm, zenith_deg or both, or "
                           "{ file = \"…\" }");
              }));
}

template <class V>
void describe(V& v, Atmosphere& a) {
  v.optional(
      expert("refraction"), a.refraction, YesOrNo{},
      "whether the air bends light by Snell's law: the axes of instruments, the indices of the "
      "water then being relative to the air at the sea; in spherical air all light");
  v.optional(expert("geometry"), a.geometry, ChoiceOf<AirGeometry>{}, "the shape of the air");
  v.when("geometry", a.geometry, AirGeometry::spherical, [&](auto& w) {
    w.optional(expert("planet_radius_km"), a.planet_radius_km,
               Number{.low = 0.0,
                      .high = 1e9,
                      .low_open = true,
                      .advice = "plane air is as good as that of a larger planet"},
               "the radius of the planet in km; its centre is straight below the origin");
  });
  v.one_of(option(a.layer.empty(), [&](auto& w) { describe_profile(w, a); }),
           option(!a.layer.empty(), [&](auto& w) {
             w.sections(expert("layer"), a.layer, Need::required,
                        "the layers of air from the sea up");
           }));
  v.table_or_word(
      "surface", a.surface, "kind",
      "the ground below air alone, in place of [sea]; below spherical air also \"sea\"");
}

}  // namespace photic::scene
