// The things that the runs of one process share.
#pragma once

#include <memory>
#include <string>

#include "optics/library.hpp"
#include "run/permits.hpp"

namespace photic::session {

/// Immutable; used by several threads.
struct Context {
  std::shared_ptr<const optics::Library> library;  ///< the data tables, read once
  std::shared_ptr<run::Permits> permits;           ///< how many batches are walked at once, by all
};

/// Reads the data tables of a folder. `threads`: how many batches are walked at once; 0: as many as
/// the machine has cores. Throws EnvironmentError.
Context make_context(const std::string& data_folder, int threads = 0);

}  // namespace photic::session
