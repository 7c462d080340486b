#include "session/result_file.hpp"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <system_error>

#include "core/error.hpp"
#include "io/csv.hpp"
#include "io/table.hpp"
#include "session/checkpoint.hpp"

namespace photic::session {
namespace {

namespace fs = std::filesystem;

void make_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw EnvironmentError(fmt::format("cannot make the folder {}: {}", folder, error.message()));
}

}  // namespace

std::optional<Format> format_of(const std::string& file) {
  std::string kind = fs::path(file).extension().string();
  for (char& c : kind) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (kind == ".nc") return Format::netcdf;
  if (kind == ".csv") return Format::csv;
  if (kind == ".txt") return Format::text;
  return std::nullopt;
}

bool is_folder(const std::string& output) {
  std::error_code none;
  return output.ends_with('/') || fs::is_directory(output, none);
}

std::string result_path(const std::string& output, const std::string& scene_file,
                        const std::string& earlier, const Words& words) {
  const std::string named_after = scene_file.empty() ? without_checkpoint(earlier) : scene_file;
  std::string name = fs::path(named_after).filename().replace_extension(".nc").string();
  if (output.empty()) return name;
  if (is_folder(output)) {
    make_folder(output);
    return (fs::path(output) / name).string();
  }
  if (!format_of(output))
    throw UsageError(fmt::format(
        "{}: the result's name ends in none of .nc, .csv and .txt (write {}, or {} for a folder)",
        output, words.set(words.output, output + ".nc"), words.set(words.output, output + "/")));
  spare_scene(output, scene_file, words);
  return output;
}

void spare_scene(const std::string& output, const std::string& scene_file, const Words& words) {
  std::error_code none;
  if (fs::equivalent(output, scene_file, none))
    throw UsageError(
        fmt::format("{}: the result would replace the scene (choose another name with {})", output,
                    words.output));
}

void spare(const std::vector<std::string>& inputs, const std::string& output, const Words& words) {
  std::error_code none;
  for (const std::string& input : inputs) {
    if (fs::equivalent(output, input, none))
      throw UsageError(fmt::format(
          "{}: the result would replace a file that it is made of (choose another name with {})",
          output, words.output));
  }
}

std::string seen_from(const std::string& result, const std::string& scene_file) {
  return fs::absolute(scene_file)
      .lexically_normal()
      .lexically_relative(fs::absolute(result).parent_path().lexically_normal())
      .string();
}

void write(const tally::Result& result, const std::string& path, const io::WriteInfo& info) {
  switch (format_of(path).value_or(Format::netcdf)) {
    case Format::csv:
      return io::write_csv(result, path, info.keep_as);
    case Format::text:
      return io::write_table(result, path, info.keep_as);
    case Format::netcdf:
      return io::write_netcdf(result, path, info);
  }
}

}  // namespace photic::session
