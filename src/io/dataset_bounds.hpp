// Cells between edges, as CF-1.10 section 7.1 has them.
#pragma once

#include <cstddef>
#include <vector>

namespace photic::io {

/// Pairs of neighbouring edges; `rows` rows of edges after each other.
inline std::vector<double> bounds(const std::vector<double>& edges, std::size_t rows = 1) {
  const std::size_t per_row = edges.size() / rows;
  std::vector<double> pairs;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (i % per_row + 1 < per_row) pairs.insert(pairs.end(), {edges[i], edges[i + 1]});
  return pairs;
}

inline std::vector<double> centres(const std::vector<double>& pairs) {
  std::vector<double> out;
  for (std::size_t i = 0; i < pairs.size(); i += 2) out.push_back(0.5 * (pairs[i] + pairs[i + 1]));
  return out;
}

}  // namespace photic::io
