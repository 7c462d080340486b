#include "session/checkpoint.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "io/netcdf.hpp"
#include "session/destination.hpp"
#include "session/result_file.hpp"

namespace photic::session {
namespace {

namespace fs = std::filesystem;

constexpr const char* ending = ".checkpoint";

std::string checkpoint_path(const std::string& result) {
  return fs::path(result).replace_extension(ending).string() + ".nc";
}

/// Whatever cannot be read is no checkpoint to go on from, and none to replace.
Occupant checkpoint_at(const std::string& path, const Origin& origin) {
  try {
    return occupant_of(path, origin);
  } catch (const EnvironmentError& error) {
    return {Occupant::Kind::stranger, 0, error.what()};
  }
}

}  // namespace

std::string without_checkpoint(const std::string& file) {
  const fs::path path(file);
  const fs::path stem = path.stem();
  if (stem.extension() != ending) return file;
  return (path.parent_path() / stem.stem()).string() + path.extension().string();
}

Checkpoint::Checkpoint(const std::string& result, const Origin& origin, std::string history,
                       const FrontEnd& front_end)
    : result_(result),
      path_(checkpoint_path(result)),
      history_(std::move(history)),
      origin_(origin),
      front_end_(front_end) {
  const Occupant left = checkpoint_at(path_, origin_);
  if (left.kind == Occupant::Kind::same_scene) photons_ = left.photons;
}

std::string Checkpoint::leftover(std::uint64_t photons) const {
  if (photons_ <= photons) return "";
  return fmt::format(
      "{}: left by a run of this scene that did not end, with {} photons (continue it: {})", path_,
      photons_, front_end_.go_on(path_, result_));
}

void Checkpoint::write(const tally::Result& so_far) {
  if (so_far.photons <= photons_) return;
  try {
    const std::string keep_as = ours_ ? "" : take_place();
    io::write_netcdf(so_far, path_,
                     {.history = history_, .scene_file = origin_.scene_file, .keep_as = keep_as});
    photons_ = so_far.photons;
    ours_ = true;
  } catch (const EnvironmentError& error) {
    if (warned_) return;
    warned_ = true;
    front_end_.report(fmt::format("{} (the run continues without this checkpoint)", error.what()));
  }
}

/// Returns where the first checkpoint puts the one of an earlier scene; empty if there is none.
std::string Checkpoint::take_place() {
  const Occupant left = checkpoint_at(path_, origin_);
  const bool edited = left.kind == Occupant::Kind::edited_scene;
  if (!edited && left.reason.empty()) return "";
  if (edited) {
    const Place place = kept_before(path_, left, origin_);
    front_end_.report(place.remark);
    return place.keep_as;
  }
  const std::string taken = std::exchange(path_, free_name(path_));
  front_end_.report(fmt::format("{}: {}, and is left as it is: this run's checkpoint is {}", taken,
                                left.reason, path_));
  return "";
}

std::string Checkpoint::finish(const tally::Result& result) {
  if (photons_ == 0 || photons_ > result.photons) return "";
  if (result.partial && format_of(result_) != Format::netcdf) return path_;
  std::error_code none;
  fs::remove(path_, none);
  return "";
}

}  // namespace photic::session
