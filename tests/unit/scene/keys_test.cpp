// Keys and tables that are missing, unknown or too many: all diagnostics, with line and column.
#include <gtest/gtest.h>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

const std::vector<Case>& keys_cases() {
  static const std::vector<Case> all{
      {"Syntax",
       {{3, 3, "wavelength_nm = = 532"}},
       {"scene.toml:3:17: this is not TOML: Error while parsing value: could not determine value "
        "type"}},
      {"SyntaxStandsAlone",
       {{3, 3, "wavelength = 1"}, {26, 26, "[gates"}},
       {R"(scene.toml:26:7: this is not TOML: Error while parsing table header: expected ']', saw '\n')"}},
      {"DuplicateKey",
       {{6, 6, R"(diameter_m = 0.04
diameter_m = 0.05)"}},
       {"scene.toml:7:14: this is not TOML: Error while parsing key-value pair: cannot redefine "
        "existing floating-point 'diameter_m'"}},
      {"IntegerTooLong",
       {{30, 30, "photons = 9223372036854775808"}},
       {"scene.toml:30:30: this is not TOML: Error while parsing decimal integer: "
        "'9223372036854775808' is not representable in 64 bits"}},
      {"TypographicQuotes",
       {{1, 1, "# été"}, {17, 17, "process = “elastic”"}},
       {"scene.toml:17:11: this is not TOML: a character that is not ASCII is outside quotes "
        "and "
        "comments (look for typographic quotes, dashes and spaces)"}},
      {"NoBreakSpace",
       {{1, 1, "title = \"\\\"é\" # é"}, {3, 3, "wavelength_nm\u00A0= 532"}},
       {"scene.toml:3:14: this is not TOML: a character that is not ASCII is outside quotes "
        "and "
        "comments (look for typographic quotes, dashes and spaces)"}},
      {"AccentBehindAnOpenQuote",
       {{1, 2, "title = 'é\né = 1\n[source]"}},
       {"scene.toml:2:1: this is not TOML: a character that is not ASCII is outside quotes and "
        "comments (look for typographic quotes, dashes and spaces)"}},
      {"BracketBeforeEquals",
       {{2, 2, "[=]"}},
       {"scene.toml:2:2: this is not TOML: Error while parsing key: expected bare key "
        "starting character or string delimiter, saw '='"}},
      {"SwappedLetters",
       {{24, 24, "ipo = 1"}},
       {"scene.toml:23:1: 'iop' is missing in [[sea.layer]] (add it: inherent optical properties "
        "by "
        "ascending wavelength)",
        "scene.toml:24:1: unknown key 'ipo' in [[sea.layer]] (did you mean 'iop'?)"}},
      {"EmptyFile",
       {{1, 30, ""}},
       {"scene.toml:1:1: [source] is missing (add it: the source of light)",
        "scene.toml:1:1: the scene needs 'telescope' or 'tally' (add a [[telescope]] for echoes, a "
        "[[tally]] for irradiances, balances and other quantities, or both)",
        "scene.toml:1:1: [sea] needs 'layer', 'column' or 'iop_table'",
        "scene.toml:1:1: [simulation] is missing (add it: how long and how to simulate)"}},
      {"EmptyLines",
       {{1, 30, R"(

# nothing)"}},
       {"scene.toml:3:1: [source] is missing (add it: the source of light)",
        "scene.toml:3:1: the scene needs 'telescope' or 'tally' (add a [[telescope]] for echoes, a "
        "[[tally]] for irradiances, balances and other quantities, or both)",
        "scene.toml:3:1: [sea] needs 'layer', 'column' or 'iop_table'",
        "scene.toml:3:1: [simulation] is missing (add it: how long and how to simulate)"}},
      {"EmptyTables",
       {{1, 1, ""},
        {3, 7, ""},
        {9, 14, ""},
        {16, 19, ""},
        {21, 25, ""},
        {27, 28, ""},
        {30, 30, ""}},
       {"scene.toml:1:1: 'wavelength_nm' is missing in [source] (add it: the wavelength of its "
        "light in nm)",
        "scene.toml:1:1: 'position_m' is missing in [source] (add it: the centre of a disc, else "
        "the "
        "place of the source [x, y, z] in m; z is up, the sea level is 0)",
        "scene.toml:1:1: 'direction' is missing in [source] (add it: the direction of the light, "
        "or the axis of its "
        "cone [x, y, z]; need not be normalised)",
        "scene.toml:1:1: 'diameter_m' is missing in [source] (add it: the diameter of the "
        "disc in m)",
        "scene.toml:1:1: 'half_divergence_mrad' is missing in [source] (add it: the angle between "
        "the axis and the edge of the beam in mrad)",
        "scene.toml:2:1: 'position_m' is missing in [[telescope]] (add it: the centre of the lens "
        "[x, y, z] in m; z is up, the sea level is 0)",
        "scene.toml:2:1: 'direction' is missing in [[telescope]] (add it: where the telescope "
        "looks [x, y, z]; need not be normalised)",
        "scene.toml:2:1: 'diameter_m' is missing in [[telescope]] (add it: the diameter of the "
        "lens in m)",
        "scene.toml:2:1: 'focal_length_m' is missing in [[telescope]] (add it: the focal length of "
        "the lens in m)",
        "scene.toml:2:1: [[telescope]] needs 'detector_diameter_m' or 'half_field_of_view_mrad'",
        "scene.toml:3:1: 'name' is missing in [[channel]] (add it: what results call it)",
        "scene.toml:3:1: [[channel]] needs 'process', 'centre_nm' + 'fwhm_nm' or "
        "'transmission_file'",
        "scene.toml:5:1: [gates] needs 'depth_max_m' + 'depth_step_m', 'range_min_m' + "
        "'range_max_m' + 'range_step_m' or 'start_ns' + 'stop_ns' + 'step_ns'",
        "scene.toml:6:1: [simulation] needs 'photons', 'target_relative_error' or 'max_time_s'"}},
      {"MissingKeyAtItsHeader",
       {{7, 7, ""}},
       {"scene.toml:2:1: 'half_divergence_mrad' is missing in [source] (add it: the angle between "
        "the axis and the edge of the beam in mrad)"}},
      {"MissingTablesAtTheEnd",
       {{26, 30, ""}},
       {"scene.toml:25:1: [gates] is missing (add it: the range gates)",
        "scene.toml:25:1: [simulation] is missing (add it: how long and how to simulate)"}},
      {"MissingTelescope",
       {{8, 14, ""}},
       {"scene.toml:23:1: the scene needs 'telescope' or 'tally' (add a [[telescope]] for echoes, "
        "a "
        "[[tally]] for irradiances, balances and other quantities, or both)"}},
      {"MissingLayers",
       {{20, 25, ""}},
       {"scene.toml:19:1: [sea] needs 'layer', 'column' or 'iop_table'"}},
      {"UnknownKeyNear",
       {{3, 3, "wavelenght_nm = 532.0"}},
       {"scene.toml:2:1: 'wavelength_nm' is missing in [source] (add it: the wavelength of its "
        "light in nm)",
        "scene.toml:3:1: unknown key 'wavelenght_nm' in [source] (did you mean 'wavelength_nm'?)"}},
      {"UnknownKeyFar",
       {{1, 1, R"(author = "me")"}},
       {"scene.toml:1:1: unknown key 'author' in the scene (known here: title, sensitivity, "
        "source, telescope, "
        "tally, channel, optics, sea, bottom, oil, atmosphere, gates, simulation, environment, "
        "environment_grid)"}},
      {"UnknownKeyInLayer",
       {{22, 22, "chlorophyl_mg_m3 = 0.1"}},
       {"scene.toml:22:1: unknown key 'chlorophyl_mg_m3' in [[sea.layer]] (did you mean "
        "'chlorophyll_mg_m3'?)"}},
      {"UnknownKeyInIop",
       {{24, 24, "iop = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1, c_per_m = 0.16 }]"}},
       {"scene.toml:24:62: unknown key 'c_per_m' in 'iop' (did you mean 'a_per_m'?)"}},
      {"UnknownTable",
       {{26, 26, "[gate]"}},
       {"scene.toml:26:2: unknown key 'gate' in the scene (did you mean 'gates'?)",
        "scene.toml:30:1: [gates] is missing (add it: the range gates)"}},
      {"SectionIsNoTable",
       {{1, 1, R"(title = "Base"
optics = "modern")"},
        {18, 18, ""}},
       {R"(scene.toml:2:10: 'optics' must be a table, not text "modern" (write [optics]))"}},
      {"SectionIsArray",
       {{18, 18, "[[optics]]"}},
       {"scene.toml:18:1: 'optics' must be a table, not an array of 1 (write [optics])"}},
      {"ArrayIsTable",
       {{15, 15, "[channel]"}},
       {"scene.toml:15:1: 'channel' must be one or more tables, not a table (write [[channel]])"}},
      {"ArrayOfNumbers",
       {{24, 24, "iop = [532, 0.06]"}},
       {"scene.toml:24:7: 'iop' must be one or more tables, not [532, 0.06] (write [ { … }, { … } "
        "])"}},
      {"ArrayEmpty",
       {{24, 24, "iop = []"}},
       {"scene.toml:24:7: 'iop' must be one or more tables, not [] (write [ { … }, { … } ])"}},
      {"InlineIsNoTable",
       {{19, 19, R"([sea]
surface = "flat")"}},
       {R"(scene.toml:20:11: 'surface' must be a table, not text "flat" (write { … }))"}},
      {"PhaseFunctionIsNumber",
       {{25, 25, "phase_function = 0.9"}},
       {"scene.toml:25:18: 'phase_function' must be a table, not 0.9 (write { … })"}},
      {"DetectorTwice",
       {{14, 14, R"(detector_diameter_m = 0.04
half_field_of_view_mrad = 10)"}},
       {"scene.toml:15:1: 'detector_diameter_m' and 'half_field_of_view_mrad' exclude each other "
        "in [[telescope]] (keep one of them)"}},
      {"ShiftAndFocus",
       {{14, 14, R"(detector_diameter_m = 0.04
focus_m = 12
detector_shift_m = 0.0)"}},
       {"scene.toml:16:1: 'focus_m' and 'detector_shift_m' exclude each other in [[telescope]] "
        "(keep one of them)"}},
      {"DetectorMissing",
       {{14, 14, ""}},
       {"scene.toml:8:1: [[telescope]] needs 'detector_diameter_m' or 'half_field_of_view_mrad'"}},
      {"ProcessAndFilter",
       {{16, 16, R"(name = "elastic"
centre_nm = 532)"}},
       {"scene.toml:18:1: 'centre_nm' and 'process' exclude each other in [[channel]] (keep one of "
        "them)"}},
      {"NeitherProcessNorFilter",
       {{17, 17, ""}},
       {"scene.toml:15:1: [[channel]] needs 'process', 'centre_nm' + 'fwhm_nm' or "
        "'transmission_file'"}},
      {"HalfAFilter",
       {{17, 17, "fwhm_nm = 3"}},
       {"scene.toml:15:1: 'centre_nm' is missing in [[channel]] (add it: count light that passes a "
        "filter of this centre in nm; { from, to, step } makes a channel at each step)"}},
      {"GatesTwice",
       {{28, 28, R"(depth_step_m = 1
stop_ns = 5)"}},
       {"scene.toml:29:1: 'depth_max_m' and 'stop_ns' exclude each other in [gates] (keep one of "
        "them)"}},
      {"GatesThrice",
       {{28, 28, R"(depth_step_m = 1
stop_ns = 5
range_max_m = 7)"}},
       {"scene.toml:29:1: 'depth_max_m' and 'stop_ns' exclude each other in [gates] (keep one of "
        "them)",
        "scene.toml:30:1: 'depth_max_m' and 'range_max_m' exclude each other in [gates] (keep one "
        "of them)"}},
      {"GatesMissing",
       {{27, 28, ""}},
       {"scene.toml:26:1: [gates] needs 'depth_max_m' + 'depth_step_m', 'range_min_m' + "
        "'range_max_m' + 'range_step_m' or 'start_ns' + 'stop_ns' + 'step_ns'"}},
      {"GatesIncomplete",
       {{27, 28, "range_max_m = 50"}},
       {"scene.toml:26:1: 'range_min_m' is missing in [gates] (add it: where the first gate "
        "begins, along the axis of the first telescope, in m)",
        "scene.toml:26:1: 'range_step_m' is missing in [gates] (add it: the length of one gate in "
        "m)"}},
      {"IopAndConstituents",
       {{24, 24, R"(iop = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1 }]
cdom_a440_per_m = 1)"}},
       {"scene.toml:25:1: 'iop' and 'cdom_a440_per_m' exclude each other in [[sea.layer]] (keep "
        "one of them)"}},
      {"PhaseFunctionOfConstituents",
       {{22, 22, R"(chlorophyll_mg_m3 = 0.1
phase_function = "petzold")"}},
       {"scene.toml:23:1: 'chlorophyll_mg_m3' and 'phase_function' exclude each other in "
        "[[sea.layer]] (keep one of them)"}},
      {"IopWithoutPhaseFunction",
       {{25, 25, ""}},
       {"scene.toml:23:1: 'phase_function' is missing in [[sea.layer]] (add it: the phase function "
        "of all scattering, water's included)"}},
      {"PhaseFunctionWithoutIop",
       {{24, 24, ""}},
       {"scene.toml:23:1: 'iop' is missing in [[sea.layer]] (add it: inherent optical properties "
        "by ascending wavelength)"}},
      {"NoLimit",
       {{30, 30, "seed = 3"}},
       {"scene.toml:29:1: [simulation] needs 'photons', 'target_relative_error' or 'max_time_s'"}},
      {"ModelMissing",
       {{25, 25, "phase_function = { g = 0.9 }"}},
       {"scene.toml:25:18: 'model' is missing in 'phase_function' (add it: the model of the phase "
        "function)"}},
      {"ParameterMissing",
       {{25, 25, R"(phase_function = { model = "henyey-greenstein" })"}},
       {"scene.toml:25:18: 'g' is missing in 'phase_function' (add it: the mean cosine of the "
        "scattering angle)"}},
      {"ParameterForeign",
       {{25, 25,
         R"(phase_function = { model = "fournier-forand", refractive_index = 1.1, slope = 3.5, g = 0.9 })"}},
       {R"(scene.toml:25:88: 'g' does not belong to model = "fournier-forand" (it belongs to "henyey-greenstein"))"}},
      {"TableWithoutFile",
       {{18, 18, "[optics]\nphytoplankton = \"table\""}},
       {"scene.toml:18:1: 'phytoplankton_file' is missing in [optics] (add it: a CSV file of "
        "wavelength_nm, a_m2_per_mg, b_m2_per_mg, or a table of these)"}},
      {"FileWithoutTable",
       {{18, 18, "[optics]\nphytoplankton_file = \"a.csv\""}},
       {R"(scene.toml:19:22: 'phytoplankton_file' does not belong to phytoplankton = "bricaud" (it belongs to "table"))"}},
      {"JerlovTypeWithConstituents",
       {{22, 22, "chlorophyll_mg_m3 = 0.1\njerlov = \"II\""}},
       {"scene.toml:23:1: 'chlorophyll_mg_m3' and 'jerlov' exclude each other in [[sea.layer]] "
        "(keep "
        "one of them)"}},
      {"WordNeedsParameters",
       {{25, 25, R"(phase_function = "rayleigh")"}},
       {"scene.toml:25:18: 'depolarisation' is missing in 'phase_function' (add it: the "
        "depolarisation ratio of natural light)"}},
      {"WordUnknown",
       {{25, 25, R"(phase_function = "petzhold")"}},
       {R"(scene.toml:25:18: 'model' must be "henyey-greenstein", "fournier-forand", "petzold", "rayleigh", "isotropic", "table", "mie" or "mixture", not text "petzhold" (did you mean 'petzold'?))"}},
      {"MixtureWithoutComponents",
       {{25, 25, R"(phase_function = { model = "mixture" })"}},
       {"scene.toml:25:18: 'components' is missing in 'phase_function' (add it: the phase "
        "functions mixed, each with its fraction)"}},
      {"MixtureBadComponents",
       {{25, 25,
         R"(phase_function = { model = "mixture", components = [{ model = "petzold" }, { fraction = 0.5, model = "rayleigh" }] })"}},
       {"scene.toml:25:53: 'fraction' is missing in 'components' (add it: its share of the "
        "scattering; the shares of a mixture sum to 1)",
        "scene.toml:25:76: 'depolarisation' is missing in 'components' (add it: the depolarisation "
        "ratio of natural light)"}},
      {"FractionOutsideMixture",
       {{25, 25, R"(phase_function = { model = "petzold", fraction = 1 })"}},
       {"scene.toml:25:39: unknown key 'fraction' in 'phase_function' (known here: model, g, "
        "refractive_index, slope, depolarisation, file, relative_index, absorption_index, "
        "junge_slope, min_radius_um, max_radius_um, components)"}},
  };
  return all;
}

TEST(Keys, AnyCharacterMayStandInQuotesAndComments) {
  EXPECT_TRUE(diagnostics_of("\xEF\xBB\xBF" + edited({{1, 1, "title = 'é' # “quoted”"}})).empty());
  EXPECT_TRUE(diagnostics_of(edited({{1, 1, "title = \"\"\"é \"a\" é\"\"\"# \"\"\" é"}})).empty());
  EXPECT_TRUE(diagnostics_of(edited({{1, 1, "title = '\"é' # 'é"}})).empty());
  EXPECT_TRUE(diagnostics_of(edited({{1, 1, "title = 'e' # a # é"}})).empty());
  EXPECT_TRUE(diagnostics_of(edited({{1, 1, "title = '''\né'''"}})).empty());
}

// Seen red: a missing key placed at the end of the file; diagnostics unsorted; foreign groups not
// forgiven their missing keys.
TEST(Keys, EveryTextWithLineAndColumn) {
  for (const Case& c : keys_cases()) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(diagnostics_of(edited(c.edits)), c.expected);
  }
}

}  // namespace
}  // namespace photic::scene
