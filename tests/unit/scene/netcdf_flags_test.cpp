// Quality flags in netCDF files: which variables they are in, and what they mean.
#include <gtest/gtest.h>

#include "scene/flag_meaning.hpp"
#include "unit/scene/profile_scenes.hpp"

namespace photic::scene {
namespace {

using Words = std::vector<std::string>;

/// Five levels, of which the third is out of all proportion and flagged.
class FlaggedFile {
 public:
  FlaggedFile() : files("netcdf_flags") {
    write_depths(files, {0, 5, 10, 15, 20}, {0.1, 0.15, 5, 0.25, 0.3});
  }

  /// A variable of flags, which is explained where meanings are given.
  NetcdfCodes& add(const std::string& name, const std::vector<double>& flags,
                   const Words& flag_values = {}, const std::string& meanings = "") {
    NetcdfCodes& codes = files.codes[name] =
        WrittenFiles::as_codes({{"z"}, {flags.size()}, "", flags});
    codes.flag_values = flag_values;
    if (!meanings.empty()) codes.flag_meanings = {meanings};
    return codes;
  }
  NetcdfCodes& add_words(const std::string& name, const Words& words) {
    NetcdfCodes& codes = files.codes[name] = {{"z"}, {words.size()}};
    codes.text = words;
    std::sort(codes.text.begin(), codes.text.end());
    codes.text.erase(std::unique(codes.text.begin(), codes.text.end()), codes.text.end());
    for (const std::string& word : words)
      codes.value.push_back(static_cast<std::size_t>(
          std::find(codes.text.begin(), codes.text.end(), word) - codes.text.begin()));
    return codes;
  }

  [[nodiscard]] Reading read() const { return files.read(profiled(from_depths)); }
  /// Of the layer, to three digits: 0.2 without the third level.
  [[nodiscard]] double mean() const {
    return std::round(1e3 * mean_chlorophyll(read().scene)) / 1e3;
  }
  [[nodiscard]] std::string first_remark() const {
    const Texts remarks = remarks_of(files, read());
    return remarks.empty() ? "" : remarks.front();
  }
  [[nodiscard]] std::string problem() const {
    const Texts problems = files.problems(profiled(from_depths));
    const std::string head = "scene.toml:22:30: float.nc: ";
    return problems.size() == 1 && problems[0].starts_with(head) ? problems[0].substr(head.size())
                                                                 : "another number of problems";
  }

  WrittenFiles files;
};

constexpr double without_bad = 0.2, with_bad = 1.4;
const std::vector<double> flags{1, 1, 4, 1, 1};
const Words qartod{"1", "2", "3", "4", "9"};
constexpr const char* qartod_meanings = "PASS NOT_EVALUATED SUSPECT FAIL MISSING";

// --- Meanings ------------------------------------------------------------------------------------

// Words of QARTOD, OceanSITES, SeaDataNet, WOCE and others. Seen red: with words looked for
// anywhere in a meaning (despiked); with no words of checks after "not".
TEST(FlagMeaning, IsSaidByManyWords) {
  for (const char* good :
       {"good_data", "PASS", "probably_good", "Acceptable", "not_bad", "no_error", "no_spikes",
        "valid", "ok", "goodQuality", "good_or_not_evaluated"})
    EXPECT_EQ(quality_of(good), Quality::good) << good;
  for (const char* unchecked :
       {"no_qc_performed", "NOT_EVALUATED", "not evaluated", "NotEvaluated", "unknown", "not_used",
        "value_changed", "interpolated_value", "despiked", "no_quality_control", "not_calibrated"})
    EXPECT_EQ(quality_of(unchecked), Quality::unchecked) << unchecked;
  for (const char* bad :
       {"bad_data", "Bad_data_that_are_potentially_correctable", "probablyBad", "SUSPECT", "FAIL",
        "missing_value", "no_data", "not_sampled", "not_good", "out_of_range", "range_out",
        "questionable", "incorrect", "unusable", "not_evaluated_or_missing"})
    EXPECT_EQ(quality_of(bad), Quality::bad) << bad;
  for (const char* unclear : {"value_below_detection", "exceeds_valid_max", "spike_test_passed",
                              "low_quality", "no_known_errors", "inversion", "", "7", "not"})
    EXPECT_EQ(quality_of(unclear), Quality::unclear) << unclear;
}

// Seen red: without flag 3.
TEST(FlagMeaning, WithoutWordsIsArgos) {
  const std::map<std::string, Quality> expected{
      {"0", Quality::unchecked}, {"1", Quality::good},      {"2", Quality::good},
      {"3", Quality::bad},       {"4", Quality::bad},       {"5", Quality::unchecked},
      {"8", Quality::unchecked}, {"9", Quality::bad},       {"A", Quality::unclear},
      {"10", Quality::unclear},  {"4.5", Quality::unclear}, {"", Quality::unclear}};
  for (const auto& [flag, quality] : expected) EXPECT_EQ(quality_in_table(flag), quality) << flag;
}

// --- Names ---------------------------------------------------------------------------------------

// Seen red: with _QC alone.
TEST(NetcdfFlags, AreFoundByTheirNameHoweverItIsSpelt) {
  for (const char* name : {"CHLA_QC", "CHLA_qc", "chla_qc", "Chla_Qc", "CHLAQC", "chlaqc",
                           "qc_chla", "CHLA_QC_FLAG", "chla_qartod_flag"}) {
    FlaggedFile file;
    file.add(name, flags);
    EXPECT_EQ(file.mean(), without_bad) << name;
    EXPECT_EQ(file.first_remark(), std::string(name) +
                                       " flags 1 of 5 levels of CHLA as bad (3, 4) or missing "
                                       "(9), which then have no value");
  }
  for (const char* name : {"CHLA_quality_control", "CHLA_quality_flag", "CHLA_WODflag"}) {
    FlaggedFile file;
    file.add(name, flags, qartod, qartod_meanings);
    EXPECT_EQ(file.mean(), without_bad) << name;
  }
}

// Of several names that a name of flags holds, the longest; then the one that is spelt alike.
// Seen red: with the first of them; with case folded throughout.
TEST(NetcdfFlags, BelongToTheVariableTheyAreNamedAfter) {
  FlaggedFile file;
  file.files.netcdf["CHLA_ADJUSTED"] = file.files.netcdf["chla"] = file.files.netcdf["CHLA"];
  file.add("CHLA_ADJUSTED_QC", flags);
  file.add("chla_qc", flags);
  EXPECT_EQ(file.mean(), with_bad);
  EXPECT_EQ(file.first_remark(), "");
  file.files.netcdf.erase("chla");
  EXPECT_EQ(file.mean(), without_bad);
}

// Seen red: without the attribute; with variables of uncertainty taken for flags.
TEST(NetcdfFlags, AreFoundByAncillaryVariables) {
  for (const char* standard_name :
       {"", "quality_flag", "aggregate_quality_flag", "sea_water_temperature status_flag"}) {
    FlaggedFile file;
    file.add("chl_checked", flags, qartod, qartod_meanings);
    file.files.netcdf["chl_error"] = {{"z"}, {5}, "mg/m3", {9, 9, 9, 9, 9}};
    file.files.attributes["CHLA"]["ancillary_variables"] = "chl_error chl_checked";
    file.files.attributes["chl_checked"]["standard_name"] = standard_name;
    EXPECT_EQ(file.mean(), without_bad) << standard_name;
    EXPECT_EQ(
        file.first_remark(),
        "chl_checked flags 1 of 5 levels of CHLA as bad or missing, which then have no value");
    EXPECT_EQ(remarks_of(file.files, file.read()).size(), 2U);
  }
}

/// Flags of whole profiles. Seen red: with flags of other dimensions refused.
TEST(NetcdfFlags, OfAWholeProfileHoldForItsLevels) {
  FlaggedFile file;
  file.add("chl_checked", flags, qartod, qartod_meanings) =
      WrittenFiles::as_codes({{}, {}, "", {4}});
  file.files.codes["chl_checked"].flag_values = qartod;
  file.files.codes["chl_checked"].flag_meanings = {qartod_meanings};
  file.files.attributes["CHLA"]["ancillary_variables"] = "chl_checked";
  EXPECT_EQ(file.problem(),
            "CHLA: profile 0 has values at 0 of 5 levels; it takes two: chl_checked flags 5 of 5 "
            "levels of CHLA as bad or missing, which then have no value (no profile has values)");
}

const std::string no_levels =
    ": no level is left out by these flags (those are read that ancillary_variables of the "
    "variable lists and that flag_values and flag_meanings explain)";

// Seen red: without remarks.
TEST(NetcdfFlags, ThatAreNotUnderstoodAreNamed) {
  const auto remark = [](const std::string& name, const std::string& standard_name = "",
                         const std::string& listed = "", const std::string& meanings = "") {
    FlaggedFile file;
    file.add(name, flags, meanings.empty() ? Words{} : qartod, meanings);
    file.files.attributes[name]["standard_name"] = standard_name;
    file.files.attributes["CHLA"]["ancillary_variables"] = listed;
    EXPECT_EQ(file.mean(), with_bad);
    return file.first_remark();
  };
  EXPECT_EQ(remark("CHLA_flag"), "CHLA_flag does not explain its flags" + no_levels);
  EXPECT_EQ(remark("checked", "quality_flag", "checked"),
            "checked does not explain its flags" + no_levels);
  EXPECT_EQ(remark("chla_qc_executed"),
            "chla_qc_executed looks like one of the flags of CHLA" + no_levels);
  const std::string nobodys = " looks like flags, but not of which variable" + no_levels;
  EXPECT_EQ(remark("quality_flag"), "quality_flag" + nobodys);
  EXPECT_EQ(remark("checked", "quality_flag"), "checked" + nobodys);
  EXPECT_EQ(remark("checked", "", "", qartod_meanings), "checked" + nobodys);
  const auto not_there = [](const std::string& name) {
    return "the attribute ancillary_variables of CHLA names " + name +
           ", which the file does not have: no flags of it are looked at";
  };
  EXPECT_EQ(remark("checked", "", "CHLA_flags none"), not_there("CHLA_flags"));
  EXPECT_EQ(remark("checked", "", "none"), not_there("none"));
  EXPECT_EQ(remark("checked", "quality_flag", "none,checked"), not_there("none"));
  EXPECT_EQ(remark("temperature_qc"), "");
  EXPECT_EQ(remark("direction", "", "", "up down level to fro"), "");
}

TEST(NetcdfFlags, OfOtherDimensions) {
  FlaggedFile file;
  file.add("checked", {1, 1, 4}, qartod, qartod_meanings).dimension = {"other"};
  file.files.attributes["CHLA"]["ancillary_variables"] = "checked";
  EXPECT_EQ(file.first_remark(), "checked does not have the dimensions of CHLA" + no_levels);
  file.add("chla_qc", {1, 1, 4}).dimension = {"other"};
  EXPECT_EQ(file.problem(), "chla_qc(other): should have a flag for each value of CHLA(z)");
}

// --- Flags ---------------------------------------------------------------------------------------

// Seen red: with what is not in the table for good.
TEST(NetcdfFlags, OutsideTheTableCountAsGoodWithARemark) {
  FlaggedFile file;
  file.add_words("chla_qc", {"1", "A", "4", "B", "1"});
  EXPECT_EQ(file.mean(), without_bad);
  EXPECT_EQ(
      remarks_of(file.files, file.read())[1],
      "2 of 5 levels of CHLA have flags in chla_qc that are not understood and count as good: "
      "\"A\", \"B\"");
  file.add("chla_qc", {1, 16, 4, 1, 1});
  EXPECT_EQ(
      remarks_of(file.files, file.read())[1],
      "1 of 5 levels of CHLA have flags in chla_qc that are not understood and count as good: "
      "16");
  file.add("chla_qc", {1, 3, 4, 1, 1}, qartod, "pass unknown below_detection fail missing");
  EXPECT_EQ(
      remarks_of(file.files, file.read())[1],
      "1 of 5 levels of CHLA have flags in chla_qc that are not understood and count as good: "
      "3 (\"below_detection\")");
}

TEST(NetcdfFlags, MayBeWords) {
  FlaggedFile file;
  file.add_words("chla_qc", {"good", "good", "bad", "good", "not evaluated"});
  EXPECT_EQ(file.mean(), without_bad);
}

// Seen red: with no remark.
TEST(NetcdfFlags, OfZeroAndOneAloneAreRemarked) {
  FlaggedFile file;
  file.add("chla_qc", {0, 0, 1, 0, 0});
  EXPECT_EQ(file.first_remark(),
            "chla_qc has the flags 0 and 1 and does not explain them (flag_meanings): they count "
            "as Argo's 0, not checked, and 1, good");
  file.files.attributes["chla_qc"]["conventions"] = "Argo reference table 2";
  EXPECT_EQ(file.first_remark(), "");
}

// Seen red: with blanks alone between meanings.
TEST(NetcdfFlags, HaveMeaningsBetweenBlanksOrCommas) {
  FlaggedFile file;
  file.add("chla_qc", flags, {"1", "4"}, "good data, bad data");
  EXPECT_EQ(file.mean(), without_bad);
  file.add("chla_qc", flags, {"1", "4"}).flag_meanings = {"good data", "bad data"};
  EXPECT_EQ(file.mean(), without_bad);
}

// Seen red: with a flag equal to a mask in the place of bits; with values not compared.
TEST(NetcdfFlags, MayBeBits) {
  FlaggedFile file;
  NetcdfCodes& bits = file.add("chla_qc", {0, 1, 5, 1, 9});
  bits.flag_masks = {1, 4, 8};
  bits.flag_meanings = {"range_test_passed spike_detected interpolated"};
  EXPECT_EQ(file.mean(), without_bad);
  // A number in the last two bits, and a bit of its own.
  NetcdfCodes& both = file.add("chla_qc", {4, 1, 2, 5, 0});
  both.flag_masks = {3, 3, 4};
  both.flag_values = {"1", "2", "4"};
  both.flag_meanings = {"good bad interpolated"};
  EXPECT_EQ(file.mean(), without_bad);
  EXPECT_EQ(file.first_remark(),
            "chla_qc flags 1 of 5 levels of CHLA as bad or missing, which then have no value");
}

// Seen red: with each of the checks left out.
TEST(NetcdfFlags, ThatContradictThemselvesAreRefused) {
  FlaggedFile file;
  const std::string one_meaning = " (every flag has one meaning)";
  const std::string to_explain = " (flag_values and flag_meanings have to explain each flag)";
  file.add("chla_qc", {1, 1, 4, 7, 1}, {"1", "4"}, "good bad");
  EXPECT_EQ(file.problem(),
            "chla_qc[3]: the flag 7 is none of its flag_values (1, 4)" + to_explain);
  file.add("chla_qc", {1, 1, 4, 7, 1}, {"1", "4"});
  EXPECT_EQ(file.problem(),
            "chla_qc[3]: the flag 7 is none of its flag_values (1, 4)" + to_explain);
  file.add("chla_qc", flags, {"1", "4", "4"}, "good good bad");
  EXPECT_EQ(file.problem(),
            "chla_qc: its attributes explain the flag 4 as \"good\" and as \"bad\"" + one_meaning);
  file.add("chla_qc", flags, {"1", "4"}, "good bad missing");
  EXPECT_EQ(file.problem(), "chla_qc: has 2 flag_values and 3 flag_meanings" + one_meaning);
  file.add("chla_qc", flags, {}, "good bad");
  EXPECT_EQ(file.problem(), "chla_qc: has 0 flag_values and 2 flag_meanings" + one_meaning);

  NetcdfCodes& bits = file.add("chla_qc", flags, {}, "good bad");
  bits.flag_masks = {1, 2};
  EXPECT_EQ(file.problem(),
            "chla_qc[2]: the flag 4 has bits that its attributes do not explain" + to_explain);
  bits.flag_masks = {1, 1};
  EXPECT_EQ(file.problem(),
            "chla_qc: its attributes explain the flag 1 as \"good\" and as \"bad\"" + one_meaning);
  bits.flag_masks = {0, 4};
  EXPECT_EQ(file.problem(), "chla_qc: its flag_masks has 0, which is no bit" + one_meaning);
  bits.flag_masks = {1.5, 4};
  EXPECT_EQ(file.problem(),
            "chla_qc: its flag_masks has 1.5, which is no set of bits" + one_meaning);
  bits.flag_masks = {1, 2, 4};
  EXPECT_EQ(file.problem(), "chla_qc: has 3 flag_masks and 2 flag_meanings" + one_meaning);
  bits.flag_masks = {1, 4};
  bits.flag_values = {"1", "4.5"};
  EXPECT_EQ(file.problem(),
            "chla_qc: its flag_values has 4.5, which is no set of bits" + one_meaning);
  bits.flag_values = {"1"};
  EXPECT_EQ(file.problem(), "chla_qc: has 1 flag_values and 2 flag_masks" + one_meaning);
}

// Flags of values that are missing anyway may be anything. Seen red: with these refused, too.
TEST(NetcdfFlags, OfMissingValuesDoNotMatter) {
  FlaggedFile file;
  file.add("chla_qc", {1, 1, 7, 1, 1}, {"1", "4"}, "good bad");
  file.files.netcdf["CHLA"].value[2] = none;
  EXPECT_EQ(file.mean(), without_bad);
}

// Two variables of one name but for case, or one that the file does not list beside one that it
// does. Seen red: with no comparison; with listed ones compared.
TEST(NetcdfFlags, OfTwoVariablesMustAgreeUnlessBothAreListed) {
  FlaggedFile file;
  file.add("CHLA_QC", flags);
  file.add("chla_qc", {1, 1, 1, 1, 1});
  const std::string refusal =
      "CHLA[2]: is good by chla_qc and bad by CHLA_QC (remove the flags that are wrong from the "
      "file, or name both in the ancillary_variables of CHLA: then what any of them calls bad is "
      "left out)";
  EXPECT_EQ(file.problem(), refusal);
  file.files.attributes["CHLA"]["ancillary_variables"] = "chla_qc";
  EXPECT_EQ(file.problem(), refusal);
  file.files.attributes["CHLA"]["ancillary_variables"] = "chla_qc CHLA_QC";
  EXPECT_EQ(file.mean(), without_bad);
  file.files.attributes.clear();
  file.add("chla_qc", {0, 0, 0, 0, 0});
  EXPECT_EQ(file.mean(), without_bad);
}

// Seen red: with no bound.
TEST(NetcdfFlags, OfManyDifferentValuesAreNone) {
  WrittenFiles files("netcdf_flags_many");
  std::vector<double> depth, value;
  for (int i = 0; i < 20'000; ++i) {
    depth.push_back(0.002 * i);
    value.push_back(0.2);
  }
  write_depths(files, depth, value);
  files.netcdf["CHLA_qc"] = files.netcdf["z"];
  EXPECT_EQ(
      remarks_of(files, files.read(profiled(from_depths))),
      (Texts{"CHLA_qc has 20000 different values, which are no flags, and is not looked at"}));
}

}  // namespace
}  // namespace photic::scene
