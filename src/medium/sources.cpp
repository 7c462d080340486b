#include "medium/sources.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "medium/layer_optics.hpp"

namespace photic::medium {

void add_source(const std::string& quantity, const std::string& source, double nm,
                std::vector<Source>& sources) {
  const auto known = std::ranges::find_if(
      sources, [&](const Source& s) { return s.quantity == quantity && s.source == source; });
  if (known == sources.end()) {
    sources.push_back({quantity, nm, nm, source});
    return;
  }
  known->first_nm = std::min(known->first_nm, nm);
  known->last_nm = std::max(known->last_nm, nm);
}

void add_source(const Contribution& contribution, double nm, std::vector<Source>& sources) {
  const auto& [name, a, b, source] = contribution;
  if (!a && !b) return;
  const std::string which = !b ? "a" : a ? "a and b" : "b";
  add_source(which + (name.empty() ? "" : " of " + name), source, nm, sources);
}

std::string source_line(const Source& source) {
  if (source.last_nm == 0) return fmt::format("{}: {}", source.quantity, source.source);
  const std::string where = source.first_nm == source.last_nm
                                ? fmt::format("{:.6g}", source.first_nm)
                                : fmt::format("{:.6g}-{:.6g}", source.first_nm, source.last_nm);
  return fmt::format("{}, {} nm: {}", source.quantity, where, source.source);
}

}  // namespace photic::medium
