// What `photic optics` prints and writes of a table, and of air and oil.
#pragma once

#include <string>

#include "medium/optical_table.hpp"
#include "photic/commands.hpp"

namespace photic::app {

/// What a table is of.
struct ReportSubject {
  std::string title;
  std::string scene_toml;  ///< empty: no scene
};

/// Prints the table, as JSON if it is asked for, or writes it to the command's output.
void report(const medium::OpticalTable& table, const ReportSubject& what,
            const OpticsCommand& command);

/// The command's oil, or its air: layers, or what a tape7 holds. Return the exit code.
int report_oil(const OpticsCommand& command);
int report_air(const OpticsCommand& command);

}  // namespace photic::app
