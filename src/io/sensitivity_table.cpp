#include "io/sensitivity_table.hpp"

#include <fmt/format.h>

#include "io/columns_table.hpp"

namespace photic::io {

std::string sensitivity_table(const tally::Result& result, std::size_t step,
                              const TableLayout& layout) {
  std::vector<std::string> meanings;
  for (std::size_t p = 0; p < result.parameter_name.size(); ++p)
    meanings.push_back(
        fmt::format("{}, {:g} in the scene", result.parameter_name[p], result.parameter_value[p]));
  return columns_table(
      result,
      {.title = "Sensitivities: change of the echo in per cent for 1 % of each parameter, with "
                "the standard error",
       .meanings = meanings,
       .rows = [&](std::size_t p) { return sensitivity_rows(result, p); },
       .text =
           [](const EchoRow&, const EchoRow& row) {
             return with_error(row.logarithmic_sensitivity,
                               row.logarithmic_sensitivity_standard_error);
           }},
      step, layout);
}

}  // namespace photic::io
