// Reads a table of numbers where a scene names its file or holds its columns.
#pragma once

#include <optional>
#include <variant>

#include "scene/rules.hpp"
#include "scene/table_reader.hpp"

namespace photic::scene {

/// A problem of the value itself is returned; one in the file, or with columns, is reported at its
/// place, and `value` is left as it was.
std::optional<Refusal> read_user_table(const TableOrFile& rule, const Node& node,
                                       const TableName& name, ReadContext& shared,
                                       UserTable& value);

/// The same of what may be a number.
std::optional<Refusal> read_number_or_table(const NumberOrTable& rule, const Node& node,
                                            const TableName& name, ReadContext& shared,
                                            std::variant<double, UserTable>& value);

/// The same of what may be a word.
std::optional<Refusal> read_word_or_table(const WordOrTable& rule, const Node& node,
                                          const TableName& name, ReadContext& shared,
                                          std::variant<std::string, UserTable>& value);

}  // namespace photic::scene
