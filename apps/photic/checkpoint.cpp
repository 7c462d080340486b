#include "photic/checkpoint.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "core/error.hpp"
#include "io/netcdf.hpp"
#include "photic/continuation.hpp"
#include "photic/output.hpp"

namespace photic::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* ending = ".checkpoint";

std::string checkpoint_path(const std::string& result) {
  return fs::path(result).replace_extension(ending).string() + ".nc";
}

}  // namespace

std::string without_checkpoint(const std::string& file) {
  const fs::path path(file);
  const fs::path stem = path.stem();
  if (stem.extension() != ending) return file;
  return (path.parent_path() / stem.stem()).string() + path.extension().string();
}

Checkpoint::Checkpoint(const std::string& result, const scene::Scene& scene, std::string history)
    : result_(result),
      path_(checkpoint_path(result)),
      history_(std::move(history)),
      photons_(photons_to_take_up(path_, scene)) {}

std::string Checkpoint::leftover(std::uint64_t photons) const {
  if (photons_ <= photons) return "";
  return fmt::format(
      "{}: left by a run of this scene that did not end, with {} photons (go on from it: {})\n",
      path_, photons_, go_on_command(path_, result_));
}

void Checkpoint::write(const tally::Result& so_far, ProgressBar& bar) {
  if (so_far.photons <= photons_) return;
  try {
    io::write_netcdf(so_far, path_, {.history = history_});
    photons_ = so_far.photons;
  } catch (const EnvironmentError& error) {
    if (warned_) return;
    warned_ = true;
    bar.wipe();
    print_error(fmt::format("{} (the run goes on without this checkpoint)\n", error.what()));
  }
}

std::string Checkpoint::finish(const tally::Result& result) {
  if (photons_ == 0 || photons_ > result.photons) return "";
  if (result.partial && fs::path(result_).extension() != ".nc") return path_;
  std::error_code none;
  fs::remove(path_, none);
  return "";
}

}  // namespace photic::app
