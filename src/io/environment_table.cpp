#include "io/environment_table.hpp"

#include "io/columns_table.hpp"

namespace photic::io {
namespace {

std::string ratio_text(const EchoRow& scene, const EchoRow& environment) {
  if (!(scene.echo > 0)) return "-";
  return with_error(1 + environment.difference / scene.echo,
                    environment.difference_standard_error / scene.echo);
}

}  // namespace

std::string environment_table(const tally::Result& result, std::size_t step) {
  return columns_table(
      result,
      {.title = "Environments: echo over that of the scene, with its standard error",
       .noun = "environment",
       .names = result.environment_name,
       .rows = [&](std::size_t e) { return environment_rows(result, e); },
       .text = ratio_text},
      step);
}

}  // namespace photic::io
