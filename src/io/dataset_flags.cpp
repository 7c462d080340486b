#include "io/dataset_flags.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tally/result.hpp"

namespace photic::io {
namespace {

void add(Dataset& dataset, const Flagged& of, const std::string& name, Values values,
         Attributes attributes) {
  if (!of.coordinates.empty()) attributes.emplace_back("coordinates", of.coordinates);
  dataset.add_variable(of.prefix + name, of.dimensions, values, attributes);
}

}  // namespace

void add_flags(Dataset& dataset, const Flagged& of, const std::vector<std::int32_t>& all_flags) {
  std::vector<std::int8_t> converged;
  for (const std::int32_t flags : all_flags) converged.push_back(flags == 0 ? 1 : 0);
  add(dataset, of, "converged", converged,
      {{"long_name", "whether the " + of.what + " and its standard error can be relied on"},
       {"flag_values", std::vector<std::int8_t>{0, 1}},
       {"flag_meanings", "no yes"}});
  std::vector<std::int32_t> masks;
  std::vector<std::string> names, explanations;
  for (const auto& meaning : tally::flag_meanings()) {
    masks.push_back(meaning.flag);
    names.emplace_back(meaning.name);
    explanations.push_back(fmt::format("{}: {}", meaning.name, meaning.explanation));
  }
  add(dataset, of, "convergence_flags", all_flags,
      {{"long_name", "why the " + of.what + " has not converged; 0 where it has"},
       {"flag_masks", masks},
       {"flag_meanings", fmt::format("{}", fmt::join(names, " "))},
       {"comment", fmt::format("{}", fmt::join(explanations, "; "))}});
}

}  // namespace photic::io
