#include "scene/user_table.hpp"

#include <utility>

#include "core/error.hpp"

namespace photic::scene {
namespace {

std::vector<UserTable::Column> columns_of(const optics::DataTable& data,
                                          const std::vector<std::string>& names) {
  std::vector<UserTable::Column> columns;
  std::vector<Diagnostic> problems;
  for (const std::string& name : names) {
    try {
      columns.push_back({name, data.numbers(name)});
    } catch (const InputError& error) {
      const auto& found = error.diagnostics();
      problems.insert(problems.end(), found.begin(), found.end());
    }
  }
  if (!problems.empty()) throw InputError(problems);
  return columns;
}

}  // namespace

UserTable::UserTable(const optics::DataTable& data, const std::vector<std::string>& columns)
    : content_(std::make_shared<const Content>(Content{data, columns_of(data, columns)})) {}

const optics::DataTable& UserTable::data() const {
  expect(!columns().empty(), "only tables that were read are looked into");
  return content_->data;
}

const std::vector<UserTable::Column>& UserTable::columns() const { return content_->columns; }

Node to_node(const UserTable& table) {
  Node node = empty_table();
  for (const UserTable::Column& column : table.columns())
    node.add(column.name, to_node(column.values));
  return node;
}

Node to_node(const std::variant<double, UserTable>& value) {
  return std::visit([](const auto& one) { return to_node(one); }, value);
}
Node to_node(const std::variant<std::string, UserTable>& value) {
  return std::visit([](const auto& one) { return to_node(one); }, value);
}

}  // namespace photic::scene
