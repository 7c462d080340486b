#include "io/sensitivity_table.hpp"

#include "io/columns_table.hpp"

namespace photic::io {

std::string sensitivity_table(const tally::Result& result, std::size_t step) {
  return columns_table(
      result,
      {.title = "Sensitivities: per cent that the echo changes by for 1 % of each parameter, with "
                "the standard error",
       .noun = "parameter",
       .names = result.parameter_name,
       .rows = [&](std::size_t p) { return sensitivity_rows(result, p); },
       .text =
           [](const EchoRow&, const EchoRow& row) {
             return with_error(row.logarithmic_sensitivity,
                               row.logarithmic_sensitivity_standard_error);
           }},
      step);
}

}  // namespace photic::io
