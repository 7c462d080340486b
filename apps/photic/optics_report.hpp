// The output of `photic optics` for a table, and for air and oil.
#pragma once

#include <string>

#include "medium/optical_table.hpp"
#include "photic/commands.hpp"

namespace photic::app {

/// The subject of a table.
struct ReportSubject {
  std::string title;
  std::string scene_toml;  ///< empty: no scene
};

/// Prints the table, as JSON if it is asked for, or writes it to the command's output.
void report(const medium::OpticalTable& table, const ReportSubject& what,
            const OpticsCommand& command);

/// Reports the command's oil, or its air: layers, or the contents of a tape7. Returns the exit
/// code.
int report_oil(const OpticsCommand& command);
int report_air(const OpticsCommand& command);

}  // namespace photic::app
