// The beginning of a table: the names of its columns and what separates its fields.
//
// Names stand in the first line, or in the last comment or text before the numbers, or behind
// /fields= in the header of a SeaBASS file. They are as many as the fields of the first line of
// numbers. A table may have none: its columns are known by their numbers then.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "optics/table_fields.hpp"

namespace photic::optics {

struct TableHead {
  std::vector<std::string> names;  ///< none: there are none
  std::vector<std::string> units;  ///< of each of them, where the file lists them
  std::size_t columns = 0;
  int line = 1;  ///< of the names, or else of the first row
  char separator = comma;
  std::size_t first_row = 0;    ///< the lines before it, counted from 0, are no rows
  std::vector<double> missing;  ///< they stand for values that are not known
  bool has_numbers = false;     ///< true if some line holds nothing but numbers
};

/// Throws InputError where columns may be separated in two ways.
TableHead head_of(const std::vector<std::string>& lines, const std::string& name);

}  // namespace photic::optics
