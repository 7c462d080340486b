#include "scene/profile_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "scene/describe_sea.hpp"
#include "scene/profile_file.hpp"
#include "scene/reader.hpp"

namespace photic::scene {
namespace {

/// The visitor that learns which keys may be profiles.
class ProfiledKeys {
 public:
  template <class T>
  void profiled(const char* key, const T&, const Number& rule, const char*,
                std::optional<double> scale = {}) {
    keys.push_back({key, rule, scale});
  }
  template <class... Keys>
  void one_of(const Option<Keys>&... options) {
    (options.keys(*this), ...);
  }
  template <class... Rest>
  void optional(Rest&&...) {}
  template <class... Rest>
  void required(Rest&&...) {}
  template <class... Rest>
  void tables(Rest&&...) {}
  template <class... Rest>
  void table_or_word(Rest&&...) {}

  std::vector<ProfiledKey> keys;
};

/// One profile on its way out of the document.
class ProfileReader {
 public:
  ProfileReader(const Node& node, const std::string& path, const ProfiledKey& key,
                const Span& layer, const OtherFiles& files, Findings& findings)
      : node_(node), path_(path), key_(key), layer_(layer), files_(files), findings_(findings) {}

  std::optional<Profile> read() {
    if (node_.find("model")) return model();
    if (node_.find(file_key)) return file();
    return points();
  }

 private:
  void refuse(const Place& place, const std::string& reason, const std::string& suggestion) {
    findings_.add(path_, place, fmt::format("'{}' {}", key_.key, reason), suggestion);
  }

  /// The keys of a form; nothing if anything is wrong with them.
  template <class Form>
  std::optional<Form> keys() {
    const std::size_t before = findings_.problems().size();
    Form form;
    ReadContext context{findings_, files_.folder};
    Reader reader(node_, {path_, path_, fmt::format("'{}'", key_.key)}, context);
    describe(reader, form);
    reader.finish();
    return findings_.problems().size() == before ? std::optional(std::move(form)) : std::nullopt;
  }

  std::optional<Profile> model() {
    const auto form = keys<ProfileModel>();
    if (!form) return std::nullopt;
    for (const char* key : {"background", "maximum"}) {
      double checked = 0;
      const Node& value = *node_.find(key);
      if (const auto refusal = check(key_.rule, value, checked)) {
        refuse(value.place, refusal->reason, refusal->suggestion);
        return std::nullopt;
      }
    }
    if (form->maximum < form->background) {
      refuse(node_.find("maximum")->place,
             fmt::format("has a maximum of {}, below its background of {}",
                         plain_number(form->maximum), plain_number(form->background)),
             "the maximum is the value there, background included");
      return std::nullopt;
    }
    return GaussianProfile{form->background, form->maximum, form->depth_m, form->width_m};
  }

  std::optional<Profile> file() {
    const auto form = keys<ProfileFile>();
    if (!form) return std::nullopt;
    if (!form->negative.empty() && key_.rule.low < 0) {
      refuse(node_.find("negative")->place, "may be below 0: 'negative' is not for it", "");
      return std::nullopt;
    }
    if (!form->column.given() && form->depth.number > 0) {
      refuse(node_.find("depth")->place, "has a number for the variable of depths",
             "variables of netCDF files are called by their names");
      return std::nullopt;
    }
    try {
      ReadProfile read = form->column.given() ? profile_of_text(*form, key_)
                                              : profile_of_netcdf(*form, key_, files_.netcdf);
      for (const std::string& remark : read.remarks)
        findings_.remark_at(node_.place, form->file + ": " + remark);
      return covering(std::move(read.profile), form->beyond);
    } catch (const InputError& error) {
      findings_.add_from_file(path_, node_.find(file_key)->place, error);
      return std::nullopt;
    }
  }

  std::optional<Profile> points() {
    auto form = keys<ProfilePoints>();
    if (!form) return std::nullopt;
    const auto& depths = *node_.find("depth_m")->as<Node::Array>();
    const auto& values = *node_.find("value")->as<Node::Array>();
    if (depths.size() != values.size()) {
      refuse(node_.find("value")->place,
             fmt::format("has {} values at {} depths", values.size(), depths.size()),
             "give a value for each depth");
      return std::nullopt;
    }
    bool good = true;
    for (std::size_t i = 0; i < depths.size(); ++i) {
      double checked = 0;
      if (const auto refusal = check(key_.rule, values[i], checked)) {
        refuse(values[i].place, refusal->reason, refusal->suggestion);
        good = false;
      }
      if (i > 0 && !(form->depth_m[i] > form->depth_m[i - 1])) {
        refuse(depths[i].place,
               fmt::format("goes from {} m to {} m: depths must ascend",
                           plain_number(form->depth_m[i - 1]), plain_number(form->depth_m[i])),
               "");
        good = false;
      }
    }
    if (!good) return std::nullopt;
    return covering({std::move(form->depth_m), std::move(form->value)}, form->beyond);
  }

  /// A profile that is known all over its layer; nothing if it is not and may not be held.
  std::optional<Profile> covering(LinearProfile profile, const BeyondPoints& beyond) {
    const double first = profile.first_m(), last = profile.last_m();
    if (last <= 0) {
      refuse(node_.place,
             fmt::format("is known from {:.6g} to {:.6g} m, above the sea", first, last),
             "depths are positive below the surface; netCDF variables of heights have the "
             "attribute positive = \"up\"");
      return std::nullopt;
    }
    const bool short_above = first > layer_.top_m, short_below = last < layer_.bottom_m;
    if ((short_above && beyond.above.empty()) || (short_below && beyond.below.empty())) {
      refuse(node_.place,
             fmt::format("is known from {:.6g} to {:.6g} m, and its layer goes from {:.6g} to "
                         "{:.6g} m",
                         first, last, layer_.top_m, layer_.bottom_m),
             remedy(short_above && beyond.above.empty(), short_below && beyond.below.empty()));
      return std::nullopt;
    }
    if (short_above) hold(profile, layer_.top_m, std::min(first, layer_.bottom_m), first);
    if (short_below) hold(profile, std::max(last, layer_.top_m), layer_.bottom_m, last);
    return profile;
  }

  static std::string remedy(bool above, bool below) {
    std::string ways;
    if (above) ways += "above = \"constant\" holds its first value up to the top; ";
    if (below) ways += "below = \"constant\" holds its last value down to the bottom; ";
    return ways + "or let layers with a number begin and end where the profile does";
  }

  /// Goes on with the value of an end from one depth to another.
  void hold(LinearProfile& profile, double from_m, double to_m, double end_m) {
    const double value = profile.extremes(end_m, end_m).greatest;
    profile.reach(from_m, to_m);
    findings_.remark_at(node_.place,
                        fmt::format("'{}' is held constant from {:.6g} to {:.6g} m, at the {:.4g} "
                                    "of {:.6g} m",
                                    key_.key, from_m, to_m, value, end_m));
  }

  const Node& node_;
  const std::string& path_;
  const ProfiledKey& key_;
  const Span& layer_;
  const OtherFiles& files_;
  Findings& findings_;
};

}  // namespace

std::vector<ProfiledKey> profiled_keys() {
  ProfiledKeys visitor;
  Layer layer;
  describe(visitor, layer);
  return std::move(visitor.keys);
}

std::optional<Profile> read_profile(const Node& node, const std::string& path,
                                    const ProfiledKey& key, const Span& layer,
                                    const OtherFiles& files, Findings& findings) {
  return ProfileReader(node, path, key, layer, files, findings).read();
}

}  // namespace photic::scene
