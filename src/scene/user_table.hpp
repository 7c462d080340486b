// A table of numbers that a user gives: in a file of text, or in the scene itself. A scene keeps
// its numbers, so that it means the same wherever the file goes.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "optics/data_table.hpp"
#include "scene/node.hpp"

namespace photic::scene {

class UserTable {
 public:
  struct Column {
    std::string name;
    std::vector<double> values;
    friend bool operator==(const Column&, const Column&) = default;
  };

  UserTable() = default;
  /// Takes the columns of a table that a scene uses. Throws InputError with all that is wrong in
  /// them.
  UserTable(const optics::DataTable& data, const std::vector<std::string>& columns);

  /// For the optics: it knows the place of every number, for messages.
  [[nodiscard]] const optics::DataTable& data() const;
  /// None where none was read.
  [[nodiscard]] const std::vector<Column>& columns() const;

  /// Wherever the numbers stand.
  friend bool operator==(const UserTable& a, const UserTable& b) {
    return a.content_ == b.content_ || a.columns() == b.columns();
  }

 private:
  struct Content {
    optics::DataTable data;
    std::vector<Column> columns;
  };

  std::shared_ptr<const Content> content_ =
      std::make_shared<const Content>();  ///< shared by all environments
};

/// As the scene file has it: { angle_deg = [ … ], … }.
Node to_node(const UserTable& table);
Node to_node(const std::variant<double, UserTable>& value);
Node to_node(const std::variant<std::string, UserTable>& value);

}  // namespace photic::scene
