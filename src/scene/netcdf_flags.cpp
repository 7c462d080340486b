#include "scene/netcdf_flags.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "scene/netcdf_flag_names.hpp"
#include "scene/suggest.hpp"
#include "scene/unit_text.hpp"

namespace photic::scene {
namespace {

/// More different values than flags have.
constexpr std::size_t max_codes = 10'000;

}  // namespace

QualityFlags::QualityFlags(const NetcdfColumns& file, std::string variable)
    : file_(file), variable_(std::move(variable)), shape_(shape_of(file.header(variable_))) {
  const FlagNames names = flag_names_of(file_, variable_);
  remarks_ = names.remarks;
  for (const std::string& name : names.listed) add(name, true);
  for (const std::string& name : names.named) add(name, false);
}

void QualityFlags::add(const std::string& name, bool is_listed) {
  NetcdfCodes codes = file_.codes(name);
  const Shape shape = shape_of(codes);
  const auto place = Alignment::of(shape, shape_);
  if (!place || (!is_listed && shape.size() != shape_.size()))
    file_.fail(shape_text(name, shape), fmt::format("should have a flag for each value of {}",
                                                    shape_text(variable_, shape_)));
  if (codes.size() > max_codes) {
    remarks_.push_back(
        fmt::format("{} has {} different values, which are no flags, and is not looked at", name,
                    codes.size()));
    return;
  }
  FlagCodes explained = flag_codes(file_, name, codes);
  const bool is_argos =
      lower_case(file_.header(name).text("conventions")).find("argo") != std::string::npos;
  flags_.push_back(
      {name, shape, *place, std::move(codes.value), std::move(explained), is_listed, is_argos});
}

const FlagCode* QualityFlags::flag(const Flags& flags, std::size_t position) const {
  const std::size_t at = flags.place(position);
  if (flags.index[at] == NetcdfCodes::none) return nullptr;
  const FlagCode& code = flags.codes.code[flags.index[at]];
  if (!code.misfit.empty())
    file_.fail(flags.name + flags.shape.index_text(at),
               fmt::format("the flag {} {}", code.text, code.misfit),
               "flag_values and flag_meanings have to explain each flag");
  return &code;
}

Flagged QualityFlags::judge(const std::vector<std::size_t>& positions,
                            const std::vector<double>& values) const {
  Flagged out{std::vector<bool>(values.size(), false), {}, remarks_};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) check_agreement(positions[i]);
  for (const Flags& flags : flags_) judge_by(flags, positions, values, out);
  return out;
}

void QualityFlags::judge_by(const Flags& flags, const std::vector<std::size_t>& positions,
                            const std::vector<double>& values, Flagged& out) const {
  std::size_t dropped = 0, unclear = 0;
  std::set<std::string> texts, unclear_texts;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const FlagCode* code = std::isfinite(values[i]) ? flag(flags, positions[i]) : nullptr;
    if (code == nullptr) continue;
    texts.insert(code->text);
    if (code->quality == Quality::bad) {
      out.is_bad[i] = true;
      ++dropped;
    } else if (code->quality == Quality::unclear) {
      unclear_texts.insert(code->text);
      ++unclear;
    }
  }
  const char* what = flags.codes.by_table ? "bad (3, 4) or missing (9)" : "bad or missing";
  if (dropped > 0)
    out.dropped.push_back(
        fmt::format("{} flags {} of {} levels of {} as {}, which then have no value", flags.name,
                    dropped, values.size(), variable_, what));
  if (unclear > 0)
    out.remarks.push_back(fmt::format(
        "{} of {} levels of {} have flags in {} that are not understood and count as good: {}",
        unclear, values.size(), variable_, flags.name,
        first_of({unclear_texts.begin(), unclear_texts.end()})));
  if (flags.codes.by_table && !flags.is_argos && texts == std::set<std::string>{"0", "1"})
    out.remarks.push_back(fmt::format(
        "{} has the flags 0 and 1 and does not explain them (flag_meanings): they count "
        "as Argo's 0, not checked, and 1, good",
        flags.name));
}

void QualityFlags::check_agreement(std::size_t position) const {
  const Flags *good[2] = {}, *bad[2] = {};  // not listed, listed
  for (const Flags& flags : flags_) {
    const FlagCode* code = flag(flags, position);
    if (code == nullptr) continue;
    if (code->quality == Quality::good) good[flags.is_listed ? 1 : 0] = &flags;
    if (code->quality == Quality::bad) bad[flags.is_listed ? 1 : 0] = &flags;
  }
  for (const auto& [a, b] :
       {std::pair(good[0], bad[0]), std::pair(good[0], bad[1]), std::pair(good[1], bad[0])})
    if (a != nullptr && b != nullptr)
      file_.fail(variable_ + shape_.index_text(position),
                 fmt::format("is good by {} and bad by {}", a->name, b->name),
                 fmt::format("remove the flags that are wrong from the file, or name both in the "
                             "ancillary_variables of {}: then what any of them calls bad is "
                             "left out",
                             variable_));
}

}  // namespace photic::scene
