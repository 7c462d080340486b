#include "medium/row.hpp"

#include <span>

namespace photic::medium {

RowTables::RowTables(const Row& row, std::int32_t layers, bool beds)
    : has_faces_(row.has_faces()), columns_(row.columns()) {
  std::vector<std::int32_t> first = row.first_layer;
  first.push_back(layers);
  std::vector<std::int32_t> column_of;
  for (std::size_t k = 0; k + 1 < first.size(); ++k)
    column_of.insert(column_of.end(), static_cast<std::size_t>(first[k + 1] - first[k]),
                     static_cast<std::int32_t>(k));
  for (std::int32_t k = 0; beds && k < columns_; ++k) column_of.push_back(k);
  first_layer_ = IndexTableOwner(first);
  column_of_ = IndexTableOwner(column_of);
  std::vector<double> faces;
  for (const double x : row.face_m) faces.push_back(x - row.origin_x_m);
  face_ = TwinTable(faces);
  side_ = TwinTable(std::vector{row.y_min_m - row.origin_y_m, row.y_max_m - row.origin_y_m});
}

RowView RowTables::view() const {
  return {columns_, has_faces_, face_.view(), side_.view(), first_layer_.view(), column_of_.view()};
}

}  // namespace photic::medium
