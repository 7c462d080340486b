#include "medium/absorbers.hpp"

#include <algorithm>

namespace photic::medium {

void Absorbers::add(const std::string& name,
                    const std::vector<std::pair<std::string, double>>& a_per_m) {
  layer.push_back(name);
  std::vector<double>& shares = share.emplace_back();
  double all = 0;
  for (const auto& [of, a] : a_per_m) {
    if (!(a > 0)) continue;
    const std::string known_as = of.empty() ? "all" : of;
    auto found = std::ranges::find(constituent, known_as);
    if (found == constituent.end()) found = constituent.insert(found, known_as);
    const auto place = static_cast<std::size_t>(found - constituent.begin());
    shares.resize(std::max(shares.size(), place + 1));
    shares[place] += a;
    all += a;
  }
  for (double& one : shares) one /= all;
}

}  // namespace photic::medium
