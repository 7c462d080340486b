// The optics of a scene's water, as `photic optics` has them, in memory.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "core/error.hpp"
#include "documents.hpp"
#include "gil.hpp"
#include "io/describe.hpp"
#include "medium/optical_table.hpp"
#include "scene/read.hpp"
#include "session/context.hpp"

namespace photic::python {

/// At these wavelengths, ascending, or at those that light of the scene has. Throws UsageError
/// where there are no data: nothing is wrong with the scene, which has been checked.
inline medium::OpticalTable table_of(const scene::Scene& scene, const optics::Library& library,
                                     const std::optional<std::vector<double>>& wavelength_nm) {
  if (!wavelength_nm)
    return medium::optical_table(scene, library, medium::wavelengths_of_light(scene, library));
  try {
    return medium::optical_table(scene, library, *wavelength_nm);
  } catch (const InputError& error) {
    throw UsageError(std::string("wavelength_nm: ") + error.what());
  }
}

/// The arrays of the table. `command`: for its history.
inline py::dict optics_of(const session::Context& context, const Document& document,
                          const std::optional<std::vector<double>>& wavelength_nm,
                          const std::string& command) {
  auto arrays = without_gil([&] {
    const session::Document now = document.now();
    const scene::Scene& scene = now.reading().scene;
    auto out = std::make_unique<Arrays>();
    io::describe(table_of(scene, *context.library, wavelength_nm),
                 {.title = scene.title,
                  .scene_toml = scene::write_scene(scene),
                  .version = PHOTIC_VERSION,
                  .history = io::history_line(command)},
                 *out);
    return out;
  });
  return arrays->hand_over();
}

}  // namespace photic::python
