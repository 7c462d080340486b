#include "scene/user_table_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "scene/reader.hpp"
#include "scene/units.hpp"

namespace photic::scene {
namespace {

/// The suggestion for a column that has another name in the file.
std::string how_to_name(const optics::DataTable& data, const std::string& column) {
  if (!data.may_be_quoted() || data.column_line() == 0) return "";
  return fmt::format("; the scene may name it: {{ {} = …, {} = … }}", file_key,
                     without_its_unit(column));
}

/// The names of a table's columns in a file.
using NamesInFile = std::vector<std::pair<std::string, optics::ColumnInFile>>;

/// Columns that are not there, and how to call them otherwise.
bool refuse_missing(const TableOrFile& rule, const optics::DataTable& data, const TableName& name,
                    ReadContext& shared) {
  const std::size_t before = shared.findings.problems().size();
  for (const TableOrFile::Column& column : rule.columns) {
    if (column.may_lack || data.has(column.name)) continue;
    shared.findings.add(name.path, {data.name(), data.column_line(), 1}, data.lack_of(column.name),
                        data.what_there_is() + how_to_name(data, column.name));
  }
  return shared.findings.problems().size() > before;
}

void read_file(const TableOrFile& rule, const std::string& path, const NamesInFile& names,
               const TableName& name, ReadContext& shared, UserTable& value) {
  try {
    auto data = rule.read(path);
    if (std::ranges::any_of(names, [](const auto& each) { return each.second.given(); }))
      data = data.with(names);
    if (refuse_missing(rule, data, name, shared)) return;
    std::vector<std::string> taken;
    for (const TableOrFile::Column& column : rule.columns) {
      if (!data.has(column.name)) continue;
      refuse_other_units(data, column.name, column.name);
      taken.emplace_back(column.name);
    }
    value = UserTable(data, taken);
    for (const std::string& remark : data.remarks())
      shared.findings.remark(name.path, data.name() + ": " + remark);
  } catch (const InputError& error) {
    for (const Diagnostic& d : error.diagnostics())
      shared.findings.add(name.path, {d.file, d.line, d.column}, d.reason, d.suggestion);
  }
}

/// { file = …, wavelength = 1, … }
void read_named_file(const TableOrFile& rule, const Node& node, const TableName& name,
                     ReadContext& shared, UserTable& value) {
  const std::size_t before = shared.findings.problems().size();
  std::string path;
  NamesInFile names;
  Reader reader(node, name, shared);
  reader.required(file_key, path, File{}, file_with_columns_meaning);
  for (const TableOrFile::Column& column : rule.columns) {
    auto& in_file = names.emplace_back(column.name, optics::ColumnInFile{}).second;
    reader.optional(without_its_unit(column.name).c_str(), in_file, ColumnOfFile{}, "");
  }
  reader.finish();
  if (shared.findings.problems().size() > before) return shared.findings.spoil(name.path);
  read_file(rule, path, names, name, shared, value);
}

/// "angle_deg 3, phase_function_per_sr 2"; empty if all are equally long.
std::string unequal_lengths(const std::vector<optics::DataTable::Column>& columns) {
  std::vector<std::string> lengths;
  for (const auto& [name, cells] : columns)
    lengths.push_back(fmt::format("{} {}", name, cells.size()));
  const bool equal = std::ranges::all_of(columns, [&](const auto& column) {
    return column.second.size() == columns.front().second.size();
  });
  return equal ? "" : fmt::format("{}", fmt::join(lengths, ", "));
}

/// The cells of a column that was read.
std::vector<optics::DataTable::Cell> cells_of(const Node& column, const std::vector<double>& read) {
  std::vector<optics::DataTable::Cell> cells;
  for (const Node& element : *column.as<Node::Array>())
    cells.push_back({number_text(read[cells.size()]), element.place.column, element.place.line});
  return cells;
}

void read_columns(const TableOrFile& rule, const Node& node, const TableName& name,
                  ReadContext& shared, UserTable& value) {
  const std::size_t before = shared.findings.problems().size();
  std::vector<optics::DataTable::Column> columns;
  std::vector<std::string> names;
  Reader reader(node, name, shared);
  for (const TableOrFile::Column& column : rule.columns) {
    std::vector<double> numbers;
    if (column.may_lack)
      reader.optional(column.name, numbers, Numbers{}, column.meaning);
    else
      reader.required(column.name, numbers, Numbers{}, column.meaning);
    if (numbers.empty()) continue;
    columns.emplace_back(column.name, cells_of(*node.find(column.name), numbers));
    names.emplace_back(column.name);
  }
  optics::DataTable::Headers beside;
  for (const TableOrFile::NumberBeside& number : rule.numbers) {
    std::optional<double> given;
    reader.optional(number.name, given, number.rule, number.meaning);
    if (given) beside[number.name] = {number_text(*given), node.find(number.name)->place.line};
  }
  reader.finish();
  if (shared.findings.problems().size() > before) return shared.findings.spoil(name.path);
  const std::string lengths = unequal_lengths(columns);
  if (!lengths.empty())
    return shared.findings.add(
        name.path, node.place,
        fmt::format("{} has columns of different lengths: {}", name.label, lengths),
        "give one number a row in each");
  value =
      UserTable(optics::DataTable::of_columns(columns, node.place.file, std::move(beside)), names);
}

/// A table of the scene: of a file, or of columns.
void read_table(const TableOrFile& rule, const Node& node, const TableName& name,
                ReadContext& shared, UserTable& value) {
  if (node.find(file_key))
    read_named_file(rule, node, name, shared, value);
  else
    read_columns(rule, node, name, shared, value);
}

/// Refuses a table of one column, which depends on nothing.
void check_dependence(const NumberOrTable& rule, const Node& node, const TableName& name,
                      ReadContext& shared, const UserTable& table) {
  if (table.columns().size() != 1) return;
  const std::string needed = fmt::format("{}", fmt::join(rule.depends_on(), " or "));
  if (const auto& data = table.data(); data.column_line() > 0)
    shared.findings.add(name.path, {data.name(), data.column_line(), 1},
                        fmt::format("no column {}", needed),
                        data.what_there_is() + how_to_name(data, rule.depends_on().front()));
  else
    shared.findings.add(name.path, node.place, fmt::format("{} needs {}", name.label, needed), "");
}

}  // namespace

std::optional<Refusal> read_user_table(const TableOrFile& rule, const Node& node,
                                       const TableName& name, ReadContext& shared,
                                       UserTable& value) {
  if (!node.as<Node::Table>()) {
    if (node.as<std::string>()) {
      std::string path;
      if (auto problem = check(File{}, node, path, shared.folder)) return problem;
      read_file(rule, path, {}, name, shared, value);
      return std::nullopt;
    }
    return Refusal{
        fmt::format("must be a file or a table, not {}", found_text(node)),
        fmt::format("name a CSV file, or write {{ {} = [ … ], … }}", rule.columns.front().name)};
  }
  read_table(rule, node, name, shared, value);
  return std::nullopt;
}

std::optional<Refusal> read_number_or_table(const NumberOrTable& rule, const Node& node,
                                            const TableName& name, ReadContext& shared,
                                            std::variant<double, UserTable>& value) {
  if (!node.as<Node::Table>()) {
    double number{};
    auto problem = check(rule.number, node, number);
    if (const auto* text = node.as<std::string>())
      problem->suggestion =
          fmt::format("a file is named in a table: {{ {} = {} }}", file_key, quoted(*text));
    value = number;
    return problem;
  }
  UserTable table;
  read_table(rule.table, node, name, shared, table);
  check_dependence(rule, node, name, shared, table);
  value = std::move(table);
  return std::nullopt;
}

std::optional<Refusal> read_word_or_table(const WordOrTable& rule, const Node& node,
                                          const TableName& name, ReadContext& shared,
                                          std::variant<std::string, UserTable>& value) {
  UserTable table;
  if (node.as<Node::Table>()) {
    read_table(rule.table, node, name, shared, table);
  } else if (const auto* text = node.as<std::string>()) {
    std::string word, path;
    const auto no_word = check(rule.words, node, word);
    if (!no_word) {
      value = word;
      return std::nullopt;
    }
    auto no_file = check(File{}, node, path, shared.folder);
    if (no_file && text->find_first_of("./") != std::string::npos) return no_file;
    if (no_file) return Refusal{no_word->reason + ", and no file", no_word->suggestion};
    read_file(rule.table, path, {}, name, shared, table);
  } else {
    return Refusal{fmt::format("must be a word, a file or a table, not {}", found_text(node)), ""};
  }
  value = std::move(table);
  return std::nullopt;
}

}  // namespace photic::scene
