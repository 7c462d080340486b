// Values that are good alone and wrong together: all diagnostics, with line and column.
#include <gtest/gtest.h>

#include "unit/scene/base_scene.hpp"

namespace photic::scene {
namespace {

const std::vector<Case>& checks_cases() {
  static const std::vector<Case> all{
      {"LayersInverted",
       {{25, 25, R"(phase_function = { model = "henyey-greenstein", g = 0.9 }
bottom_depth_m = 10)"}},
       {"scene.toml:26:18: the layer ends at 10 m, not below the one above it, which ends at 20 m "
        "(layers go from the surface down)"}},
      {"LayersEqual",
       {{25, 25, R"(phase_function = { model = "henyey-greenstein", g = 0.9 }
bottom_depth_m = 20)"}},
       {"scene.toml:26:18: the layer ends at 20 m, not below the one above it, which ends at 20 m "
        "(layers go from the surface down)"}},
      {"BottomlessInTheMiddle",
       {{21, 21, ""}},
       {"scene.toml:20:1: 'bottom_depth_m' is missing in [[sea.layer]] (only the last layer may be "
        "bottomless)"}},
      {"NamesTwice",
       {{14, 14, R"(detector_diameter_m = 0.04
[[telescope]]
name = "t"
position_m = [0, 0, 12]
direction = [0, 0, -1]
diameter_m = 0.4
focal_length_m = 2
detector_diameter_m = 0.04
[[channel]]
name = "elastic"
process = "raman")"},
        {20, 20, R"([[sea.layer]]
name = "layer1")"},
        {24, 24, R"(iop = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1 }]
name = "layer1")"}},
       {R"(scene.toml:16:8: two of [[telescope]] are called "t" (give each its own name))",
        R"(scene.toml:26:8: two of [[channel]] are called "elastic" (give each its own name))",
        R"(scene.toml:36:8: two of [[sea.layer]] are called "layer1" (give each its own name))"}},
      {"ObstructionCoversLens",
       {{13, 13, R"(focal_length_m = 2
obstruction_diameter_m = 0.4)"}},
       {"scene.toml:14:26: the obstruction of 0.4 m covers the whole lens of 0.4 m (it must be "
        "smaller than diameter_m)"}},
      {"DetectorInTheLens",
       {{13, 13, R"(focal_length_m = 2
detector_shift_m = -2)"}},
       {"scene.toml:14:20: a shift of -2 m puts the detector into or before the lens of focal "
        "length 2 m (focal_length_m + detector_shift_m must be greater than 0)"}},
      // Seen red: without the check; with the focal length itself let through.
      {"FocusWithinTheFocalLength",
       {{13, 13, R"(focal_length_m = 2
focus_m = 1.5)"}},
       {"scene.toml:14:11: what is 1.5 m from a lens of focal length 2 m has no sharp image "
        "(focus_m must be greater than focal_length_m)"}},
      {"FocusAtTheFocalLength",
       {{13, 13, R"(focal_length_m = 2
focus_m = 2)"}},
       {"scene.toml:14:11: what is 2 m from a lens of focal length 2 m has no sharp image "
        "(focus_m must be greater than focal_length_m)"}},
      {"OnTheSurface",
       {{4, 4, "position_m = [0, 0, 0]"}, {10, 10, "position_m = [0, 0, -0.0]"}},
       {"scene.toml:4:14: the source lies on the sea surface (put it into the air (z > 0) or into "
        "the water (z < 0))",
        "scene.toml:10:14: the telescope lies on the sea surface (put it into the air (z > 0) or "
        "into the water (z < 0))"}},
      {"BelowTheSeaBed",
       {{4, 4, "position_m = [0, 0, -61]"},
        {10, 10, "position_m = [0, 0, -60]"},
        {25, 25, R"(phase_function = { model = "henyey-greenstein", g = 0.9 }
bottom_depth_m = 60)"}},
       {"scene.toml:4:14: the source is 61 m deep and the sea bed 60 m (raise it, or lower the "
        "last layer's bottom_depth_m)",
        "scene.toml:10:14: the telescope is 60 m deep and the sea bed 60 m (raise it, or lower the "
        "last layer's bottom_depth_m)"}},
      {"SourceLooksUp",
       {{5, 5, "direction = [1, 0, 0]"}},
       {"scene.toml:5:13: the light never meets the sea: a source in the air must point down (make "
        "the third number negative)"}},
      {"IopNotAscending",
       {{24, 24,
         "iop = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1 }, { wavelength_nm = 532, "
         "a_per_m = 0.06, b_per_m = 0.1 }, { wavelength_nm = 500, a_per_m = 0.06, b_per_m = 0.1 "
         "}]"}},
       {"scene.toml:24:82: 532 nm does not come after 532 nm (sort the iop by ascending "
        "wavelength, each once)",
        "scene.toml:24:138: 500 nm does not come after 532 nm (sort the iop by ascending "
        "wavelength, each once)"}},
      {"IopWithoutAttenuation",
       {{24, 24, "iop = [{ wavelength_nm = 532, a_per_m = 0, b_per_m = 0 }]"}},
       {"scene.toml:24:8: a_per_m + b_per_m is 0: there is no water without attenuation"}},
      {"PhytoplanktonAboveAll",
       {{24, 24,
         "iop = [{ wavelength_nm = 532, a_per_m = 0.06, b_per_m = 0.1, a_phytoplankton_per_m = "
         "0.07 }]"}},
       {"scene.toml:24:86: phytoplankton absorbs 0.07 1/m, more than the total of 0.06 1/m (it is "
        "a "
        "part of a_per_m)"}},
      {"MixtureSum",
       {{25, 25,
         R"(phase_function = { model = "mixture", components = [{ fraction = 0.5, model = "petzold" }, { fraction = 0.4, model = "isotropic" }] })"}},
       {"scene.toml:25:52: the fractions of the mixture sum to 0.9, not to 1"}},
      {"MixtureInMixtureSum",
       {{25, 25,
         R"(phase_function = { model = "mixture", components = [{ fraction = 1, model = "mixture", components = [{ fraction = 0.7, model = "petzold" }] }] })"}},
       {"scene.toml:25:101: the fractions of the mixture sum to 0.7, not to 1"}},
      {"RadiiInverted",
       {{25, 25,
         R"(phase_function = { model = "mixture", components = [{ fraction = 1, model = "mie", max_radius_um = 0.01 }] })"}},
       {"scene.toml:25:100: the largest radius, 0.01 um, is not above the smallest, 0.01 um"}},
      {"SmallestRadiusAboveTheDefault",
       {{25, 25, R"(phase_function = { model = "mie", min_radius_um = 2 })"}},
       {"scene.toml:25:51: the largest radius, 1 um, is not above the smallest, 2 um"}},
      {"GatesInverted",
       {{27, 27, R"(depth_min_m = 50
depth_max_m = 20)"}},
       {"scene.toml:28:15: the gates end at 20 m, not beyond 50 m where they begin"}},
      {"GatesEmpty",
       {{26, 26, R"([gates]
depth_min_m = 50)"}},
       {"scene.toml:28:15: the gates end at 50 m, not beyond 50 m where they begin"}},
      // Seen red: with metres for every unit.
      {"GatesInvertedInTime",
       {{27, 28, "start_ns = 200\nstop_ns = 90\nstep_ns = 1"}},
       {"scene.toml:28:11: the gates end at 90 ns, not beyond 200 ns where they begin"}},
      {"GateStepTooLongInTime",
       {{27, 28, "start_ns = 100\nstop_ns = 200\nstep_ns = 101"}},
       {"scene.toml:29:11: a gate of 101 ns is longer than all gates together, 100 ns"}},
      {"GateStepNegative",
       {{28, 28, "depth_step_m = -1"}},
       {"scene.toml:28:16: 'depth_step_m' must be a finite number, greater than 0, not -1"}},
      {"GateStepTooLong",
       {{28, 28, "depth_step_m = 51"}},
       {"scene.toml:28:16: a gate of 51 m is longer than all gates together, 50 m"}},
      {"TooManyGates",
       {{28, 28, "depth_step_m = 1e-300"}},
       {"scene.toml:28:16: these are 5e+301 gates (at most 1000000 are possible: take longer "
        "ones)"}},
      {"GatesInTheAir",
       {{27, 27, R"(depth_min_m = -5
depth_max_m = 0)"}},
       {"scene.toml:28:15: all gates lie in the air (end them below the sea surface, at depth 0, "
        "or give the scene an [atmosphere])"}},
      {"GatesAboveTheInstrument",
       {{27, 27, R"(depth_min_m = -12.5
depth_max_m = 10)"}},
       {"scene.toml:27:15: the gates begin at the depth -12.5 m, above the source or the first "
        "telescope (begin at -12 m or deeper)"}},
      {"GatesAboveASubmergedLidar",
       {{4, 4, "position_m = [0, 0, -5]"}, {10, 10, "position_m = [0, 0, -6]"}},
       {"scene.toml:26:1: the gates begin at the depth 0 m, above the source or the first "
        "telescope (begin at 6 m or deeper)"}},
      {"GatesBelowTheSeaBed",
       {{25, 25, R"(phase_function = { model = "henyey-greenstein", g = 0.9 }
bottom_depth_m = 60)"},
        {27, 27, R"(depth_min_m = 60
depth_max_m = 70)"}},
       {"scene.toml:28:15: all gates lie below the sea bed at 60 m"}},
      {"DepthGatesLookingUp",
       {{4, 5, R"(position_m = [0, 0, -5]
direction = [0, 0, 1])"},
        {10, 11, R"(position_m = [0, 0, -5]
direction = [0, 0, 1])"}},
       {"scene.toml:27:15: gates by depth need a source and a first telescope that look down (give "
        "the gates by range_… or by …_ns)"}},
      {"RangeGatesInTheAir",
       {{11, 11, "direction = [0.5, 0, -0.8660254037844386]"}, {27, 28, R"(range_min_m = 0
range_max_m = 13
range_step_m = 1)"}},
       {"scene.toml:28:15: all gates lie in the air: the axis of the first telescope meets the "
        "water at 13.86 m (end them beyond that, or give the scene an [atmosphere])"}},
      {"RangeGatesLookingUp",
       {{11, 11, "direction = [0, 0, 1]"}, {27, 28, R"(range_min_m = 0
range_max_m = 13
range_step_m = 1)"}},
       {"scene.toml:28:15: the axis of the first telescope never meets the water (make it look "
        "down, or give the gates by …_ns)"}},
      {"RangeGatesBehindTheTelescope",
       {{27, 28, R"(range_min_m = -1
range_max_m = 20
range_step_m = 1)"}},
       {"scene.toml:27:15: 'range_min_m' must be a finite number, at least 0, not -1"}},
      {"TimeGatesTooEarly",
       {{27, 28, R"(start_ns = 10
stop_ns = 80
step_ns = 1)"}},
       {"scene.toml:28:11: all gates end before light can come back from the water, after 80.06 "
        "ns"}},
      {"TimeGatesBeforeTheLight",
       {{27, 28, R"(start_ns = -10
stop_ns = 200
step_ns = 1)"}},
       {"scene.toml:27:12: 'start_ns' must be a finite number, at least 0, not -10"}},
      {"MemoryByGates",
       {{28, 28, "depth_step_m = 1e-4\ndepth_cells = 20"}},
       {"scene.toml:28:16: the tallies (telescopes 1, channels 1, gates 500000, orders 6, cells of "
        "depth 20) would take 5.24 GiB; the limit is 2 GiB (take fewer gates)"}},
      {"MemoryByDepths",
       {{28, 28, "depth_step_m = 0.01\ndepth_cells = 10000"}},
       {"scene.toml:29:15: the tallies (telescopes 1, channels 1, gates 5000, orders 6, cells of "
        "depth 10000) would take 2.3 GiB; the limit is 2 GiB (take fewer, 0 leaves echo_by_depth "
        "out, or fewer gates)"}},
      {"ToolsOfTheBidirectionalEstimator",
       {{30, 30,
         "photons = 1e6\nestimator = \"bidirectional\"\ntools = { forced_collisions = 1 }"}},
       {"scene.toml:31:13: the bidirectional estimator cannot use simulation.tools (write "
        "estimator = \"forward\", or leave the tools out)"}},
      {"ToolsOfAnalogPhotons",
       {{30, 30, "photons = 1e6\nestimator = \"analog\"\ntools = { forced_collisions = 1 }"}},
       {"scene.toml:31:13: the analog estimator cannot use simulation.tools (write estimator = "
        "\"forward\", or leave the tools out)"}},
      {"ImportancesInNoOrder",
       {{30, 30,
         "photons = 1e6\n[simulation.tools]\nimportance = [{ depth_m = 5, value = 2 }, { depth_m = "
         "5, "
         "value = 3 }]"}},
       {"scene.toml:32:55: importances must be listed from the surface down (a depth below 5 m)"}},
      {"ImportanceTooLarge",
       {{30, 30, "photons = 1e6\n[simulation.tools]\nimportance = [{ depth_m = 5, value = 101 }]"}},
       {"scene.toml:32:38: 'value' must be a finite number, at least 0.01 and at most 100, not "
        "101"}},
      {"AllAtOnce",
       {{3, 3, "wavelength_nm = -1"}, {12, 12, "diametre_m = 0.4"}, {17, 17, ""}, {26, 28, ""}},
       {"scene.toml:3:17: 'wavelength_nm' must be a finite number, greater than 0, not -1",
        "scene.toml:8:1: 'diameter_m' is missing in [[telescope]] (add it: the diameter of the "
        "lens in m)",
        "scene.toml:12:1: unknown key 'diametre_m' in [[telescope]] (did you mean 'diameter_m'?)",
        "scene.toml:15:1: [[channel]] needs 'process', 'centre_nm' + 'fwhm_nm' or "
        "'transmission_file'",
        "scene.toml:26:1: [gates] is missing (add it: the range gates)"}},
  };
  return all;
}

// Seen red, each for itself: telescopes allowed on the sea bed, horizontal lasers, layers of no
// thickness, the shallower instead of the deeper instrument for depth gates, the distance to the
// water without its slant, time gates without the way to the surface, memory without the depth
// axis, tools and analog photons together, importances in any order.
TEST(Checks, EveryTextWithLineAndColumn) {
  for (const Case& c : checks_cases()) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(diagnostics_of(edited(c.edits)), c.expected);
  }
}

// Seen red: without the remark.
TEST(Checks, ATelescopeThatLooksUpHasNoDepths) {
  const std::string text = edited({{14, 14,
                                    "detector_diameter_m = 0.04\n[[telescope]]\nname = \"up\"\n"
                                    "position_m = [0, 0, -1]\ndirection = [0, 0, 1]\n"
                                    "diameter_m = 0.1\nfocal_length_m = 1\n"
                                    "detector_diameter_m = 0.04"}});
  EXPECT_EQ(read_scene_text(text, "scene.toml", "/").remarks,
            (std::vector<std::string>{"scene.toml:18:13: telescope \"up\" does not look down: its "
                                      "gates have times, but no depths"}));
}

// Seen red: without the remark; with it for lenses in the air, too; for walks, which do not use it.
TEST(Checks, RemarkOnTheMeanOverALensInTheWater) {
  const auto remarks = [](const std::string& z, const std::string& estimator = "forward") {
    const std::string text = edited({});
    return read_scene_text(text, "scene.toml", "/",
                           {{"simulation.estimator=" + estimator},
                            {"simulation.reception=overlap"},
                            {"gates={ start_ns = 0, stop_ns = 100, step_ns = 10 }"},
                            {"telescope.0.position_m=[0, 0, " + z + "]"}})
        .remarks;
  };
  EXPECT_EQ(remarks("12"), std::vector<std::string>{});
  EXPECT_EQ(remarks("-1", "bidirectional"), std::vector<std::string>{});
  EXPECT_EQ(
      remarks("-1"),
      (std::vector<std::string>{
          "--set simulation.reception: the mean over a lens in the water takes light scattered "
          "close to it at one angle: echoes are low, without a flag (3 m from a lens of 0.3 m a "
          "gate by 3 %, its third order by 20 %); reception = \"ray\" is exact"}));
}

// Seen red: without the remark; with it where no groups are asked for.
TEST(Checks, RemarkOnGroupsThatTakeTooMuchRoom) {
  const auto remarks = [](const std::string& step_m, const std::string& keep_groups) {
    return read_scene_text(edited({}), "scene.toml", "/",
                           {{"gates.depth_step_m=" + step_m},
                            {"gates.depth_cells=0"},
                            {"simulation.keep_groups=" + keep_groups}})
        .remarks;
  };
  EXPECT_EQ(remarks("0.0004", "true"), std::vector<std::string>{});
  EXPECT_EQ(remarks("0.00032", "false"), std::vector<std::string>{});
  EXPECT_EQ(
      remarks("0.00032", "true"),
      (std::vector<std::string>{
          "--set simulation.keep_groups: echoes by groups of batches would take up to 80 MB in "
          "the result, more than 64, and are left out: errors of what is made of several echoes "
          "will not be known (take fewer gates, channels or environments, or keep_groups = "
          "false)"}));
}

TEST(Checks, MemoryOfManyOrders) {
  std::string channels;
  for (int i = 0; i < 100; ++i)
    channels += "[[channel]]\nname = \"c" + std::to_string(i) + "\"\nprocess = \"raman\"\n";
  channels.pop_back();
  const std::vector<std::string> expected{
      "scene.toml:328:15: the tallies (telescopes 1, channels 100, gates 500, orders "
      "1000, cells of depth 100) would take 3.28 GiB; the limit is 2 GiB (keep fewer orders: "
      "orders_kept)"};
  EXPECT_EQ(diagnostics_of(edited({{15, 17, channels},
                                   {28, 28, "depth_step_m = 0.1"},
                                   {30, 30, "photons = 1e6\norders_kept = 1000"}})),
            expected);
}

}  // namespace
}  // namespace photic::scene
