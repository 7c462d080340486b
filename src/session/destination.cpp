#include "session/destination.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "core/error.hpp"
#include "io/atomic_file.hpp"

namespace photic::session {
namespace {

namespace fs = std::filesystem;
using Kind = Occupant::Kind;

/// "my.nc" and ".previous" -> "my.previous.nc"
fs::path renamed(const fs::path& file, const std::string& ending) {
  return file.parent_path() / (file.stem().string() + ending + file.extension().string());
}

[[noreturn]] void refuse_to_replace(const std::string& file, const std::string& reason,
                                    const Words& words, const std::string& way = "") {
  throw UsageError(
      fmt::format("{}: {}, and is left as it is ({}choose another name with {}, or {} to "
                  "replace it)",
                  file, reason, way, words.output, words.force));
}

std::string more_photons(const Occupant& occupant) {
  return fmt::format("holds {} photons of this scene", occupant.photons);
}

}  // namespace

std::string previous_name(const std::string& file) {
  return renamed(io::behind_links(file), ".previous").string();
}

std::string free_name(const std::string& file, int first) {
  std::error_code none;
  for (int n = first;; ++n) {
    const fs::path name = renamed(file, fmt::format("-{}", n));
    if (!fs::exists(name, none)) return name.string();
  }
}

Place kept_before(const std::string& file, const Occupant& there, const Origin& origin) {
  const std::string previous = previous_name(file);
  const Occupant before = occupant_of(previous, origin);
  if (before.reason.empty() && before.photons > there.photons)
    return {file, "",
            fmt::format("{}: holds {} photons and stays; the {} of {} are replaced", previous,
                        before.photons, there.photons, file)};
  const std::string keep_as = before.reason.empty() ? previous : free_name(previous);
  return {file, keep_as, fmt::format("{}: what {} held before", keep_as, file)};
}

Destination::Destination(std::string path, const Origin& origin, bool force,
                         const FrontEnd& front_end)
    : path_(std::move(path)),
      previous_(previous_name(path_)),
      origin_(origin),
      force_(force),
      front_end_(front_end) {
  if (!force_) expect_room(occupant_of(path_, origin_));
}

void Destination::expect_room(const Occupant& occupant) const {
  const Words& words = front_end_.words;
  if (!occupant.reason.empty()) refuse_to_replace(path_, occupant.reason, words);
  const auto asked = origin_.scene.simulation.photons;
  if (occupant.kind == Kind::same_scene && asked && *asked < occupant.photons)
    refuse_to_replace(path_,
                      fmt::format("{}, more than the {} requested", more_photons(occupant), *asked),
                      words, fmt::format("add to them with {}, ", words.set(words.earlier, path_)));
  if (occupant.kind != Kind::edited_scene && occupant.kind != Kind::some_scene) return;
  const Occupant previous = occupant_of(previous_, origin_);
  if (!previous.reason.empty())
    refuse_to_replace(previous_,
                      fmt::format("{}; {} would be kept under this name", previous.reason, path_),
                      words);
}

Place Destination::beside(const std::string& why) {
  std::string path = free_name(path_);
  for (int n = 3; !lock_; ++n) {
    try {
      lock_.emplace(path, front_end_);
    } catch (const UsageError&) {  // another run is at work on that one
      path = free_name(path_, n);
    }
  }
  return {path, "", fmt::format("{}: {}, and is left as it is: see {}", path_, why, path)};
}

Place Destination::place_of(const tally::Result& result) {
  if (force_) return {path_, "", ""};
  const Occupant occupant = occupant_of(path_, origin_);
  if (!occupant.reason.empty()) return beside(occupant.reason);
  const bool more = occupant.photons > result.photons;
  if (occupant.kind == Kind::same_scene && more)
    return beside(
        fmt::format("{}, more than this run's {}", more_photons(occupant), result.photons));
  if (occupant.kind == Kind::some_scene && more && result.partial)
    return beside(
        fmt::format("holds {} photons, more than this run's {}", occupant.photons, result.photons));
  if (occupant.kind != Kind::edited_scene && occupant.kind != Kind::some_scene)
    return {path_, "", ""};
  return kept_before(path_, occupant, origin_);
}

}  // namespace photic::session
