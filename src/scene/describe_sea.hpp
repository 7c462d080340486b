// The keys of [optics], [sea], [[sea.layer]], [[sea.column]], [bottom] and [oil] (see
// describe_instrument.hpp).
#pragma once

#include "optics/fournier_forand.hpp"
#include "optics/phase_functions.hpp"
#include "scene/iop_layers.hpp"
#include "scene/presets.hpp"
#include "scene/rules.hpp"
#include "scene/scene.hpp"
#include "scene/visitor.hpp"

namespace photic::scene {

template <class V>
void describe(V& v, Optics& o) {
  v.optional("set", o.set, ChoiceOf<OpticsSet>{}, "fills in the choices below that are not given");
  v.once_read([&] { o = optics_of(o.set); });
  v.optional(expert("water_absorption"), o.water_absorption,
             Choice{{{"mason-ioccg",
                      "Mason, Cone & Fry 2016 up to 510 nm, the Water Optical Properties Processor "
                      "3 above, IOCCG 2018 below 300 nm: 200 to 1100 nm"},
                     {"ioccg", "IOCCG 2018, as recommended for pure water: 200 to 1000 nm"},
                     {"pope-fry", "Pope & Fry 1997: 380 to 727.5 nm"},
                     {"smith-baker", "Smith & Baker 1981: 200 to 800 nm"}}},
             "the absorption of pure sea water");
  v.optional(expert("water_scattering"), o.water_scattering,
             Choice{{{"zhang", "Zhang, Hu & He 2009: 200 to 1100 nm"},
                     {"morel", "Morel 1974: 200 to 800 nm"},
                     {"smith-baker", "Smith & Baker 1981: 200 to 800 nm"}}},
             "the scattering of pure sea water");
  v.optional(
      expert("water_depolarisation"), o.water_depolarisation, from_to(0.0, 1.0),
      "the depolarisation ratio of natural light scattered by water, for its phase function");
  v.optional("phytoplankton", o.phytoplankton,
             Choice{{{"bricaud", "Bricaud et al. 1995 and 1998"},
                     {"prieur-sathyendranath", "Prieur & Sathyendranath 1981"},
                     {"table", "your own spectra: phytoplankton_file"}}},
             "the absorption and scattering of phytoplankton, which scale with chlorophyll");
  v.when("phytoplankton", o.phytoplankton, "table", [&](auto& w) {
    w.required("phytoplankton_file", o.phytoplankton_table,
               TableOrFile{{{"wavelength_nm", "wavelengths in nm, ascending"},
                            {"a_m2_per_mg", "absorption per chlorophyll in m2/mg"},
                            {"b_m2_per_mg", "scattering per chlorophyll in m2/mg"},
                            {"a_exciting_m2_per_mg",
                             "the part of the absorption that excites fluorescence, in m2/mg; by "
                             "default all",
                             true}}},
               "a CSV file of wavelength_nm, a_m2_per_mg, b_m2_per_mg, or a table of these");
  });
  v.optional(expert("phytoplankton_phase"), o.phytoplankton_phase, ChoiceOf<ParticlePhase>{},
             "the phase function of phytoplankton");
  v.optional(expert("minerals"), o.minerals, ChoiceOf<MineralOptics>{},
             "the absorption and scattering of minerals");
  auto& minerals = o.minerals_power_law;
  v.optional(expert("minerals_a_443_m2_per_g"), minerals.a_443_m2_per_g, not_negative,
             "power-law: the absorption of minerals at 443 nm in m2/g");
  v.optional(expert("minerals_a_slope_per_nm"), minerals.a_slope_per_nm, not_negative,
             "power-law: how fast the absorption of minerals falls, in 1/nm");
  v.optional(expert("minerals_b_555_m2_per_g"), minerals.b_555_m2_per_g, not_negative,
             "power-law: the scattering of minerals at 555 nm in m2/g");
  v.optional(expert("minerals_b_exponent"), minerals.b_exponent, any_number,
             "power-law: the scattering of minerals scales as wavelength^-exponent");
  v.optional(expert("minerals_phase"), o.minerals_phase, ChoiceOf<ParticlePhase>{},
             "the phase function of minerals");
  v.optional(
      expert("raman"), o.raman,
      Choice{{{"bartlett", "Bartlett et al. 1998"}, {"marshall-smith", "Marshall & Smith 1990"}}},
      "the Raman scattering coefficient of water");
  v.optional(expert("emission"), o.emission, ChoiceOf<Emission>{},
             "whether Raman light and chlorophyll's have spectra, or one wavelength each; by "
             "default spectra in set modern, unless a layer has iop or jerlov");
  v.optional(expert("chlorophyll_share_730"), o.chlorophyll_share_730, from_to(0.0, 1.0),
             "the share of chlorophyll's light that is emitted about 730 nm");
  v.optional(expert("cdom_fluorescence"), o.cdom_fluorescence, ChoiceOf<CdomFluorescence>{},
             "how dissolved organic matter fluoresces");
  v.when("cdom_fluorescence", o.cdom_fluorescence, CdomFluorescence::table, [&](auto& w) {
    w.required(expert("cdom_fluorescence_file"), o.cdom_fluorescence_table,
               TableOrFile{{{"excitation_nm", "ascending wavelengths in nm, for each emission"},
                            {"emission_nm", "wavelengths in nm, the same for every excitation"},
                            {"yield_per_nm", "photons per photon absorbed and nm"}}},
               "a CSV file of excitation_nm, emission_nm, yield_per_nm, or a table of these");
  });
  v.optional(expert("chlorophyll_lifetime_ns"), o.chlorophyll_lifetime_ns, not_negative,
             "the mean time from excitation to emission of chlorophyll's light in ns; 0: no delay");
  v.optional(expert("cdom_lifetime_ns"), o.cdom_lifetime_ns, not_negative,
             "the same for the light of dissolved organic matter");
}

template <class V>
void describe(V& v, IopEntry& i) {
  v.required("wavelength_nm", i.wavelength_nm, Wavelength{}, "the wavelength in nm");
  v.required("a_per_m", i.a_per_m, not_negative,
             "the absorption coefficient in 1/m, water included");
  v.required("b_per_m", i.b_per_m, not_negative,
             "the scattering coefficient in 1/m, water included");
  v.optional(expert("a_phytoplankton_per_m"), i.a_phytoplankton_per_m, not_negative,
             "the part of a_per_m that excites chlorophyll fluorescence, in 1/m");
  v.optional("bb_per_m", i.bb_per_m, not_negative,
             "the backscattering coefficient in 1/m, water included; sets the phase function");
  v.optional(expert("a_cdom_per_m"), i.a_cdom_per_m, not_negative,
             "the part of a_per_m that excites the fluorescence of dissolved organic matter, in "
             "1/m");
}

inline constexpr const char* model_key = "model";
inline constexpr const char* phase_function_meaning =
    "the phase function of all scattering, water's included";
/// The largest departure of constituents from their mean in the pieces of a layer (cut.hpp).
inline constexpr Number profile_tolerance_rule{.low = 0.0, .high = 1.0, .low_open = true};
inline constexpr double default_profile_tolerance = 0.05;

// Wider than the seas: the formulas behind were fitted to 0-40 PSU and 0-40 C (Millero 1980).
inline constexpr Number salinity_rule = from_to(0.0, 45.0);
inline constexpr Number temperature_rule = from_to(-2.0, 45.0);
/// The scales of their departures, 0 C being no less water than 20 C: the values of a sea by
/// default.
inline constexpr double salinity_scale_psu = 35.0, temperature_scale_c = 20.0;

/// Stronger winds leave no surface, but spray.
inline constexpr Number wind_speed_rule = from_to(0.0, 30.0);
/// Slopes of 45 degrees and more.
inline constexpr Number slope_variance_rule = from_to(0.0, 1.0);

/// Everything of a phase function but its share in a mixture.
template <class V>
void describe(V& v, PhaseFunction& p) {
  v.required(model_key, p.model, ChoiceOf<PhaseModel>{}, "the model of the phase function");
  v.when(model_key, p.model, PhaseModel::henyey_greenstein, [&](auto& w) {
    w.required("g", p.g,
               Number{.low = optics::lowest_henyey_greenstein_g, .high = 1.0, .high_open = true},
               "the mean cosine of the scattering angle");
  });
  v.when(model_key, p.model, PhaseModel::fournier_forand, [&](auto& w) {
    using Ff = optics::FournierForand;
    w.required("refractive_index", p.refractive_index, from_to(Ff::lowest_index, Ff::highest_index),
               "the particles' real refractive index relative to water");
    w.required("slope", p.slope, between(Ff::slope_above, Ff::slope_below),
               "the exponent of the particles' hyperbolic size distribution");
  });
  v.when(model_key, p.model, PhaseModel::rayleigh, [&](auto& w) {
    w.required("depolarisation", p.depolarisation, from_to(0.0, 1.0),
               "the depolarisation ratio of natural light");
  });
  v.when(model_key, p.model, PhaseModel::table, [&](auto& w) {
    w.required("file", p.table,
               TableOrFile{{{"angle_deg", "scattering angles in degrees, ascending to 180"},
                            {"phase_function_per_sr", "the phase function there, in 1/sr"}}},
               "a CSV file of angle_deg, phase_function_per_sr, or a table of these");
  });
  v.when(model_key, p.model, PhaseModel::mie, [&](auto& w) {
    w.optional(expert("relative_index"), p.particles.relative_index, from_to(0.5, 3.0),
               "the spheres' real refractive index relative to water");
    w.optional(expert("absorption_index"), p.particles.absorption_index, from_to(0.0, 3.0),
               "how much they absorb: k of their index n - ik relative to water");
    w.optional(
        expert("junge_slope"), p.particles.junge_slope, from_to(0.0, 10.0),
        "the exponent of their Junge distribution: numbers per radius scale as radius^-slope");
    w.optional(expert("min_radius_um"), p.particles.min_radius_um, from_to(0.001, 20.0),
               "the smallest radius in um");
    w.optional(expert("max_radius_um"), p.particles.max_radius_um, from_to(0.001, 20.0),
               "the largest radius in um");
  });
  v.when(model_key, p.model, PhaseModel::mixture, [&](auto& w) {
    w.tables("components", p.components, "the phase functions mixed, each with its fraction",
             [](auto& inner, PhaseFunction& component) { describe_component(inner, component); });
  });
}

template <class V>
void describe_component(V& v, PhaseFunction& p) {
  v.required("fraction", p.fraction, Number{.low = 0.0, .high = 1.0, .low_open = true},
             "its share of the scattering; the shares of a mixture sum to 1");
  describe(v, p);
}

template <class V>
void describe(V& v, Layer& l) {
  v.optional("name", l.name, Text{},
             "what messages and --set call it; by default layer0, layer1 …");
  v.optional("bottom_depth_m", l.bottom_depth_m, positive,
             "the depth of the layer's lower end in m; only the last layer may be bottomless");
  v.one_of(option(l.iop.empty() && l.jerlov.empty(),
                  [&](auto& w) {
                    w.profiled("chlorophyll_mg_m3", l.chlorophyll_mg_m3, not_negative,
                               "the concentration of chlorophyll in mg/m3");
                    w.profiled("cdom_a440_per_m", l.cdom_a440_per_m, not_negative,
                               "the absorption of dissolved organic matter at 440 nm in 1/m");
                    w.optional(
                        "cdom_slope_per_nm", l.cdom_slope_per_nm, not_negative,
                        "how fast the absorption of dissolved organic matter falls, in 1/nm");
                    w.profiled("minerals_g_m3", l.minerals_g_m3, not_negative,
                               "the mass of suspended minerals in g/m3");
                    w.profiled("salinity_psu", l.salinity_psu, salinity_rule,
                               "the salinity in PSU, only for the layer's absorption and "
                               "scattering; by default the sea's, which bends and times all light",
                               salinity_scale_psu);
                    w.profiled("temperature_c", l.temperature_c, temperature_rule,
                               "the temperature in C, only for the layer's absorption and "
                               "scattering; by default the sea's, which bends and times all light",
                               temperature_scale_c);
                  }),
           option(!l.iop.empty(),
                  [&](auto& w) {
                    w.tables("iop", l.iop, "inherent optical properties by ascending wavelength",
                             [](auto& inner, IopEntry& entry) { describe(inner, entry); });
                    w.table_or_word("phase_function", l.phase_function, model_key,
                                    "the phase function of all scattering, water's included");
                  }),
           option(!l.jerlov.empty(), [&](auto& w) {
             w.required("jerlov", l.jerlov,
                        Choice{{{"IB", "clear ocean water"},
                                {"II", "less clear ocean water"},
                                {"III", "turbid ocean water"},
                                {"1C", "clear coastal water"},
                                {"3C", "less clear coastal water"},
                                {"5C", "turbid coastal water"}}},
                        "Jerlov's type of water, which sets all absorption and scattering");
           }));
  v.optional(expert("chlorophyll_yield"), l.chlorophyll_yield, from_to(0.0, 1.0),
             "fluorescence photons per photon absorbed by phytoplankton");
}

template <class V>
void describe(V& v, Surface& s) {
  using enum SurfaceModel;
  using Models = Among<SurfaceModel>;
  v.optional("model", s.model,
             ChoiceOf<SurfaceModel>{{{"slick", "model = \"cox-munk\" with slick = true"}}},
             "the shape of the sea surface");
  v.when("model", s.model, Models{{cox_munk, paper}}, [&](auto& w) {
    w.required("wind_speed_m_s", s.wind_speed_m_s, wind_speed_rule,
               "the wind's speed in m/s; at 0 the surface is flat");
  });
  v.when("model", s.model, Models{{cox_munk, gaussian, paper}}, [&](auto& w) {
    w.optional("wind_direction_deg", s.wind_direction_deg, from_to(-360.0, 360.0),
               "where the wind comes from, in degrees from +x to +y: 0 is from +x, 90 from +y");
  });
  v.when("model", s.model, cox_munk, [&](auto& w) {
    w.optional("slick", s.slick, YesOrNo{}, "whether a slick damps the waves");
    w.optional(expert("gram_charlier"), s.gram_charlier, YesOrNo{},
               "whether slopes are skewed and peaked as Cox & Munk found, or a Gaussian");
  });
  v.when("model", s.model, gaussian, [&](auto& w) {
    w.required("upwind_slope_variance", s.upwind_slope_variance, slope_variance_rule,
               "the variance of slopes along the wind");
    w.required("crosswind_slope_variance", s.crosswind_slope_variance, slope_variance_rule,
               "the variance of slopes across the wind; with one variance 0 waves are "
               "one-dimensional");
  });
  v.when("model", s.model, Models{{cox_munk, gaussian, paper}}, [&](auto& w) {
    w.optional("whitecaps", s.whitecaps, YesOrNo{},
               "whether whitecaps cover a part of the surface; by default only with \"cox-munk\", "
               "unless there is a slick");
    w.optional("whitecap_fraction", s.whitecap_fraction, from_to(0.0, 1.0),
               "the share of the surface that whitecaps cover; by default from whitecap_law");
  });
  v.when("model", s.model, Models{{cox_munk, paper}}, [&](auto& w) {
    w.optional(expert("whitecap_law"), s.whitecap_law, ChoiceOf<WhitecapLaw>{},
               "how the part of the sea that whitecaps cover depends on the wind");
  });
  v.when("model", s.model, Models{{cox_munk, gaussian, paper}}, [&](auto& w) {
    w.optional(expert("whitecap_reflectance"), s.whitecap_reflectance,
               ChoiceOf<WhitecapReflectance>{}, "how much light whitecaps reflect");
    w.optional(expert("facets"), s.facets, ChoiceOf<FacetWeight>{},
               "the weight of light at every facet; by default \"reciprocal\" with a laser, else "
               "\"conserving\"");
  });
}

template <class V>
void describe(V& v, Column& c) {
  v.optional("name", c.name, Text{},
             "what messages, results and --set call it; by default column0, column1 …");
  v.optional(expert("x_min_m"), c.x_min_m, any_number,
             "the x in m where the first column begins; by default it has no end there");
  v.optional(expert("x_max_m"), c.x_max_m, any_number,
             "the x in m where the column ends and the next one begins; by default the last one "
             "has no end there");
  v.table(expert("oil"), c.oil, "a film of oil on this column alone");
  v.sections("layer", c.layer, Need::required, "its layers of water from the surface down");
  v.section("bottom", c.bottom, Need::optional,
            "the sea bed of this column, where its last layer ends");
}

template <class V>
void describe(V& v, Sea& s) {
  v.optional("salinity_psu", s.salinity_psu, salinity_rule, "the salinity in PSU");
  v.optional("temperature_c", s.temperature_c, temperature_rule, "the temperature in C");
  v.optional(expert("refractive_index"), s.refractive_index, from_to(1.0, 2.0),
             "replaces the refractive index from salinity and temperature, at all wavelengths");
  v.optional(expert("group_index"), s.group_index, from_to(1.0, 2.0),
             "replaces the group index from salinity and temperature, at all wavelengths");
  v.table("surface", s.surface, "the sea surface");
  v.one_of(option(s.column.empty(),
                  [&](auto& w) {
                    w.sections("layer", s.layer, Need::required,
                               "the layers of water from the surface down");
                  }),
           option(!s.column.empty(),
                  [&](auto& w) {
                    w.sections(expert("column"), s.column, Need::required,
                               "columns of water side by side along x, each with its own layers");
                  }),
           option(false, [&](auto& w) {
             w.expanded("iop_table", IopTableKey{},
                        "a file of optical properties by depth and wavelength, instead of layers");
           }));
  v.with("column", !s.column.empty(), [&](auto& w) {
    w.optional(expert("y_min_m"), s.y_min_m, any_number,
               "the y in m where all columns begin; by default they have no end there");
    w.optional(expert("y_max_m"), s.y_max_m, any_number,
               "the y in m where all columns end; by default they have no end there");
  });
  v.expanded(expert("profile_tolerance"), profile_tolerance_rule,
             "how far constituents may depart from their mean in the layers that profiles are cut "
             "into, relative to their greatest value, temperatures to 20 C, salinities to "
             "35 PSU",
             default_profile_tolerance);
}

/// An albedo for light that comes in at zenith angles of this meaning.
inline NumberOrTable albedo_rule(const char* zenith_meaning) {
  return {from_to(0.0, 1.0),
          {{{"wavelength_nm", "wavelengths in nm, ascending", true},
            {"zenith_deg", zenith_meaning, true},
            {"albedo", "the albedo there, 0 to 1"}}}};
}

template <class V>
void describe(V& v, Bottom& b) {
  v.required("albedo", b.albedo,
             albedo_rule("zenith angles of the incident light in the water, in degrees, ascending "
                         "from 0 to 90"),
             "the share of the light that the sea bed reflects, as a Lambert reflector: "
             "a number, a table of wavelength_nm, zenith_deg or both, or { file = \"…\" }");
}

template <class V>
void describe(V& v, Oil& o) {
  v.one_of(
      option(o.of_class.has_value(),
             [&](auto& w) {
               w.required("class", o.of_class, ChoiceOf<OilClass>{},
                          "the kind of oil; most of the data on oils are placeholders");
             }),
      option(!o.table.columns().empty(), [&](auto& w) {
        w.required(
            "file", o.table,
            TableOrFile{{{"wavelength_nm", "wavelengths in nm, ascending"},
                         {"n", "the refractive index relative to air"},
                         {"a_per_m", "the absorption coefficient in 1/m"},
                         {"emission_per_nm",
                          "the spectrum of the emitted light, in photons, relative; "
                          "not needed with a yield of 0",
                          true}},
                        optics::DataTable::read,
                        {{"yield", "as oil.yield, which goes first", from_to(0.0, 1.0)},
                         {"lifetime_ns", "as oil.lifetime_ns, which goes first", not_negative}}},
            "a CSV file as photic optics --oil writes it, or a table of its columns");
      }));
  v.required("thickness_um", o.thickness_um, not_negative,
             "the thickness of the film in um; at 0 there is none");
  v.optional("yield", o.yield, from_to(0.0, 1.0),
             "fluorescence photons per photon absorbed; by default that of the class or file");
  v.optional(expert("lifetime_ns"), o.lifetime_ns, not_negative,
             "the mean time from excitation to emission in ns; by default that of the class or "
             "file");
  v.optional(expert("absorption_factor"), o.absorption_factor, not_negative,
             "multiplies the absorption of the oil's data, at all wavelengths");
}

}  // namespace photic::scene
