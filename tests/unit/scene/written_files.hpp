// Files for scenes to name: a folder of CSV files, and netCDF files that exist in memory.
#pragma once

#include <unistd.h>

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

  [[nodiscard]] NetcdfFiles netcdf_files() const {
    return {[this](const std::string&) {
              std::vector<std::string> names;
              for (const auto& [name, variable] : netcdf) names.push_back(name);
              return names;
            },
            [this](const std::string&, const std::string& name) { return netcdf.at(name); },
            [this](const std::string&, const std::string& name, std::size_t) {
              return netcdf.at(name);
            }};
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
  std::filesystem::path folder_;
};

}  // namespace photic::scene
