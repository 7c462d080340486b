#include "io/environment_table.hpp"

#include "io/columns_table.hpp"

namespace photic::io {
namespace {

std::string ratio_text(const EchoRow& scene, const EchoRow& environment) {
  if (!(scene.echo > 0)) return "-";
  return with_error(1 + environment.difference / scene.echo,
                    environment.difference_standard_error / scene.echo);
}

/// Its name, and the values that are not in the name.
std::string meaning(const tally::Result& result, std::size_t environment) {
  const std::string& values = result.environment_changes[environment];
  return result.environment_name[environment] + (values.empty() ? "" : ": " + values);
}

}  // namespace

std::string environment_table(const tally::Result& result, std::size_t step,
                              const TableLayout& layout) {
  std::vector<std::string> meanings;
  for (std::size_t e = 0; e < result.environment_name.size(); ++e)
    meanings.push_back(meaning(result, e));
  return columns_table(
      result,
      {.title = "Environments: echo over that of the scene, with its standard error",
       .meanings = meanings,
       .rows = [&](std::size_t e) { return environment_rows(result, e); },
       .text = ratio_text},
      step, layout);
}

}  // namespace photic::io
