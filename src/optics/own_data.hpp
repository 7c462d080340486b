// Reading the tables of the installation: what is wrong with one is not the user's input.
#pragma once

#include <string>

#include "core/error.hpp"
#include "optics/data_table.hpp"

namespace photic::optics {

/// Returns the product of `make`; its InputErrors become EnvironmentErrors.
template <class Make>
auto own(Make make) {
  try {
    return make();
  } catch (const InputError& e) {
    throw EnvironmentError(std::string("a data table of Photic is missing or damaged: ") +
                           e.what());
  }
}

inline DataTable own_table(const std::string& folder, const std::string& file) {
  return own([&] { return DataTable::read(folder + "/" + file); });
}

}  // namespace photic::optics
