// The file of a result: its name, its format, and its writing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/netcdf.hpp"
#include "session/front_end.hpp"
#include "tally/result.hpp"

namespace photic::session {

/// The format that a file's name states, in small letters or capitals: .nc, .csv or .txt.
enum class Format { netcdf, csv, text };
std::optional<Format> format_of(const std::string& file);

/// Returns whether an output is a folder: by its name, or because one is there.
bool is_folder(const std::string& output);

/// The file of a run's result: the output, or the scene's name with .nc, in the folder that is
/// given, which is made if it is not there, or in the current one; where there is no scene file,
/// the name of the earlier result. Throws UsageError unless it has a Format and is another file
/// than the scene, EnvironmentError for a folder that cannot be made.
std::string result_path(const std::string& output, const std::string& scene_file,
                        const std::string& earlier, const Words& words = {});

/// Throws UsageError if the output is the scene file.
void spare_scene(const std::string& output, const std::string& scene_file, const Words& words = {});
/// Throws UsageError if the output is one of the files that it is made of.
void spare(const std::vector<std::string>& inputs, const std::string& output,
           const Words& words = {});

/// A scene file seen from the folder of a result, so that both may move.
std::string seen_from(const std::string& result, const std::string& scene_file);

/// Writes a result whole, or not at all, in the format of its name. Throws EnvironmentError.
void write(const tally::Result& result, const std::string& path, const io::WriteInfo& info);

}  // namespace photic::session
