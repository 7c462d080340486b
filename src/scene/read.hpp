// Scene file -> Scene, and back.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scene/findings.hpp"
#include "scene/netcdf_files.hpp"
#include "scene/node.hpp"
#include "scene/override.hpp"
#include "scene/scene.hpp"

namespace photic::scene {

/// "path=value" as given to --set: path in the style "sea.layer.0.chlorophyll_mg_m3" (elements
/// count from 0; a name serves as well as a number), value as TOML, or else taken as text.
using Override = std::string;

/// A scene that was read, and what its reader should know without it being wrong.
struct Reading {
  Scene scene;
  std::vector<std::string> remarks;  ///< e.g. "scene.toml:3:1: …"
  std::vector<std::string> files;    ///< that the scene names, which nothing should replace
  Multiples multiples = {};          ///< of the document that it was read from
};

/// The order in which a check is asked.
enum class Asked {
  of_scene,         ///< its environments being unknown
  of_environment,   ///< of the scene in one of them (scene_in)
  of_environments,  ///< of the scene with all of them known
};

/// A check of the whole scene that this folder is too low for (estimator/model.hpp has the one of
/// the optics). Its findings are reported with all others.
using Check = std::function<void(const Scene&, Findings&, Asked)>;

/// Reads and checks a scene file. Throws InputError with every problem (a TOML syntax error stands
/// alone) and for what is no text file, EnvironmentError if the file cannot be read. Files the
/// scene names are relative to the scene file.
Reading read_scene(const std::string& path, const std::vector<Override>& overrides = {},
                   const Check& check = {}, const NetcdfFiles& netcdf = {});

/// The same for a text; `name` stands for the file in diagnostics, `folder` is where relative files
/// lie.
Reading read_scene_text(const std::string& text, const std::string& name, const std::string& folder,
                        const std::vector<Override>& overrides = {}, const Check& check = {},
                        const NetcdfFiles& netcdf = {});

/// The text of a scene as a tree, whose own place is the end of the text. Throws InputError for a
/// syntax error.
Node document_of(const std::string& text, const std::string& name);

/// The text of a scene file. Throws as read_scene.
std::string text_of_scene(const std::string& path);

/// The same for a tree of values, in which profiles and grids are put in full. `findings`: on that
/// tree, so far.
Reading read_document(Node& document, const std::string& folder, Findings& findings,
                      const Check& check = {}, const NetcdfFiles& netcdf = {});

/// The effective scene as TOML, every default written out; reads back to the same scene, to the
/// last bit.
std::string write_scene(const Scene& scene);

/// The same as JSON.
std::string write_scene_json(const Scene& scene);

/// The JSON Schema (draft 2020-12) of scene files for editors, of a version of the program. Besides
/// what the draft knows, keys have `x-unit` and `x-level` (annotate.hpp).
std::string scene_schema(const std::string& version);

/// A commented starter scene. Throws InputError naming the kinds there are if `kind` is none of
/// them.
std::string starter_scene(const std::string& kind);

/// A file that a starter scene reads from its own folder.
struct StarterFile {
  std::string name, text;
};
std::vector<StarterFile> starter_files(const std::string& kind);

/// The kinds there are, each with the first line of its scene: one sentence.
struct StarterKind {
  std::string kind, summary;
};
std::vector<StarterKind> starter_kinds();

}  // namespace photic::scene
