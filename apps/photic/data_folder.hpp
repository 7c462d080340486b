// The folder of the tables.
#pragma once

#include <string>

namespace photic::app {

/// The folder named by the environment variable PHOTIC_DATA if it is set; else ../share/photic/data
/// beside the program (installed), else the source tree's data/. Throws EnvironmentError saying
/// where it looked.
std::string find_data_folder();

}  // namespace photic::app
