#include <fmt/format.h>

#include <cmath>

#include "scene/annotate.hpp"
#include "scene/rules.hpp"
#include "scene/units.hpp"

namespace photic::scene {
namespace {

Node typed(const char* type) {
  Node schema = empty_table();
  schema.add("type", to_node(type));
  return schema;
}

Node three_numbers() {
  Node schema = typed("array");
  schema.add("items", typed("number"));
  schema.add("minItems", to_node(std::int64_t{3}));
  schema.add("maxItems", to_node(std::int64_t{3}));
  return schema;
}

/// A table that holds the columns.
Node columns_schema(const TableOrFile& rule) {
  Node columns = empty_table();
  std::vector<std::string> needed;
  for (const TableOrFile::Column& column : rule.columns) {
    Node schema = schema_of(Numbers{});
    annotate(schema, column.meaning, unit_of(column.name), Level::basic);
    columns.add(column.name, std::move(schema));
    if (!column.may_lack) needed.emplace_back(column.name);
  }
  for (const TableOrFile::NumberBeside& number : rule.numbers) {
    Node schema = schema_of(number.rule);
    annotate(schema, number.meaning, unit_of(number.name), Level::basic);
    columns.add(number.name, std::move(schema));
  }
  Node table = typed("object");
  table.add("properties", std::move(columns));
  table.add("required", to_node(needed));
  table.add("additionalProperties", to_node(false));
  return table;
}

/// A table that names a file and what it calls the columns.
Node file_schema(const TableOrFile& rule) {
  Node keys = empty_table();
  Node name = schema_of(File{});
  annotate(name, file_with_columns_meaning, "", Level::basic);
  keys.add(file_key, std::move(name));
  for (const TableOrFile::Column& column : rule.columns) {
    Node schema = schema_of(ColumnOfFile{});
    annotate(schema, meaning_in_file(column), "", Level::basic);
    keys.add(without_its_unit(column.name), std::move(schema));
  }
  Node table = typed("object");
  table.add("properties", std::move(keys));
  table.add("required", to_node(std::vector<std::string>{file_key}));
  table.add("additionalProperties", to_node(false));
  return table;
}

Node one_of_these(Node::Array schemas) {
  Node schema = empty_table();
  schema.add("anyOf", {.value = std::move(schemas)});
  return schema;
}

}  // namespace

Node schema_of(const Number& rule) {
  Node schema = typed("number");
  if (std::isfinite(rule.low))
    schema.add(rule.low_open ? "exclusiveMinimum" : "minimum", to_node(rule.low));
  if (std::isfinite(rule.high))
    schema.add(rule.high_open ? "exclusiveMaximum" : "maximum", to_node(rule.high));
  return schema;
}

Node schema_of(const Wavelength&) { return schema_of(Number{.low = Wavelength::shortest_nm}); }

Node schema_of(const Count& rule) {
  Node schema = typed("integer");
  schema.add("minimum", to_node(rule.low));
  schema.add("maximum", to_node(rule.high));
  return schema;
}

Node schema_of(const YesOrNo&) { return typed("boolean"); }

Node schema_of(const Numbers&) {
  Node schema = typed("array");
  schema.add("items", typed("number"));
  schema.add("minItems", to_node(std::int64_t{2}));
  return schema;
}

Node schema_of(const Choice& rule) {
  Node::Array words;
  for (const Word& one : rule.words) {
    Node& word = words.emplace_back(empty_table());
    word.add("const", to_node(one.word));
    word.add("description", to_node(one.meaning));
  }
  Node schema = typed("string");
  schema.add("oneOf", {.value = std::move(words)});
  return schema;
}

Node schema_of(const Text& rule) {
  Node schema = typed("string");
  if (!rule.may_be_empty) schema.add("minLength", to_node(std::int64_t{1}));
  return schema;
}

Node schema_of(const File&) { return schema_of(Text{}); }

std::string meaning_in_file(const TableOrFile::Column& column) {
  return fmt::format(
      "the column of {}: its name in the file, or its number from 1; by default \"{}\"",
      column.name, column.name);
}

Node schema_of(const ColumnOfFile&) {
  return one_of_these({schema_of(Text{}), schema_of(Count{})});
}

Node schema_of(const TableOrFile& rule) {
  return one_of_these({schema_of(File{}), file_schema(rule), columns_schema(rule)});
}

Node schema_of(const NumberOrTable& rule) {
  Node::Array ways;
  for (const std::string& column : rule.depends_on())
    ways.emplace_back(empty_table()).add("required", to_node(std::vector<std::string>{column}));
  Node table = columns_schema(rule.table);
  table.add("anyOf", {.value = std::move(ways)});
  return one_of_these({schema_of(rule.number), file_schema(rule.table), std::move(table)});
}

Node schema_of(const WordOrTable& rule) {
  return one_of_these({schema_of(rule.words), schema_of(File{}), file_schema(rule.table),
                       columns_schema(rule.table)});
}

Node schema_of(const Position&) { return three_numbers(); }
Node schema_of(const Direction&) { return three_numbers(); }

}  // namespace photic::scene
