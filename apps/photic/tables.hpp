// The data tables of this process, and what needs them.
#pragma once

#include <memory>

#include "optics/library.hpp"
#include "scene/read.hpp"

namespace photic::app {

/// Read when they are first asked for, from find_data_folder(). Throws EnvironmentError for a file
/// that is missing or damaged.
const std::shared_ptr<const optics::Library>& tables();

/// estimator::optics_check by tables(), which it asks for no earlier than a scene is checked: what
/// is wrong with the scene's text is reported without them.
scene::Check optics_check();

}  // namespace photic::app
