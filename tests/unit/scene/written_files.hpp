// Files for scenes to name: a folder of CSV files, and netCDF files that exist in memory.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "core/error.hpp"
#include "unit/scene/base_scene.hpp"

namespace photic::scene {

/// Gone at the end of the test.
class WrittenFiles {
 public:
  explicit WrittenFiles(const std::string& name)
      : folder_(std::filesystem::path(testing::TempDir()) /
                ("photic_" + name + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  WrittenFiles(const WrittenFiles&) = delete;
  WrittenFiles& operator=(const WrittenFiles&) = delete;
  ~WrittenFiles() { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).lexically_normal().string();
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  /// The variables of all netCDF files, whose names still have to be those of written files.
  std::map<std::string, NetcdfVariable> netcdf;
  /// Their attributes that are texts and matter to profiles.
  std::map<std::string, std::map<std::string, std::string>> attributes;
  /// Those that hold no numbers, or explain their flags. Numbers are codes without that.
  std::map<std::string, NetcdfCodes> codes;

  [[nodiscard]] NetcdfFiles netcdf_files() const {
    return {[this](const std::string&) { return contents(); },
            [this](const std::string&, const std::string& name) { return netcdf.at(name); },
            [this](const std::string&, const std::string& name) {
              const auto given = codes.find(name);
              return given == codes.end() ? as_codes(netcdf.at(name)) : given->second;
            }};
  }

  /// As the reader of files makes them.
  static NetcdfCodes as_codes(const NetcdfVariable& variable) {
    NetcdfCodes out{variable.dimension, variable.length};
    for (const double x : variable.value)
      if (std::isfinite(x)) out.number.push_back(x);
    std::sort(out.number.begin(), out.number.end());
    out.number.erase(std::unique(out.number.begin(), out.number.end()), out.number.end());
    for (const double x : variable.value) {
      const auto at = std::lower_bound(out.number.begin(), out.number.end(), x);
      out.value.push_back(std::isfinite(x) ? static_cast<std::size_t>(at - out.number.begin())
                                           : NetcdfCodes::none);
    }
    return out;
  }

  [[nodiscard]] Reading read(const std::string& text) const {
    return read_scene_text(text, "scene.toml", folder_.string(), {}, {}, netcdf_files());
  }
  /// The texts of the diagnostics, without the folder.
  [[nodiscard]] Texts problems(const std::string& text) const {
    Texts texts;
    try {
      static_cast<void>(read(text));
    } catch (const InputError& error) {
      for (const Diagnostic& diagnostic : error.diagnostics())
        texts.push_back(without_folder(diagnostic.text()));
    }
    return texts;
  }
  [[nodiscard]] std::string without_folder(std::string text) const {
    const std::string folder = path("");
    for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
      text.erase(at, folder.size());
    return text;
  }

 private:
  [[nodiscard]] NetcdfHeader header(const std::string& name, const auto& variable) const {
    const auto texts = attributes.find(name);
    NetcdfHeader header{variable.dimension, variable.length};
    if (texts != attributes.end()) header.attribute = texts->second;
    return header;
  }

  [[nodiscard]] NetcdfContents contents() const {
    NetcdfContents out;
    for (const auto& [name, variable] : netcdf) out.variable[name] = header(name, variable);
    for (const auto& [name, variable] : codes) {
      NetcdfHeader& of_codes = out.variable[name] = header(name, variable);
      of_codes.has_numbers = !variable.number.empty();
      if (!variable.flag_meanings.empty())
        of_codes.attribute["flag_meanings"] = variable.flag_meanings.front();
      of_codes.has_flags = !variable.flag_meanings.empty() || !variable.flag_values.empty() ||
                           !variable.flag_masks.empty();
    }
    for (const auto& [name, variable] : out.variable)
      for (std::size_t i = 0; i < variable.dimension.size(); ++i)
        out.dimension[variable.dimension[i]] = variable.length[i];
    return out;
  }

  std::filesystem::path folder_;
};

}  // namespace photic::scene
