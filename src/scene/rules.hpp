// The rules for single values. A rule checks values and describes itself as JSON Schema.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/vec3.hpp"
#include "scene/choices.hpp"
#include "scene/node.hpp"
#include "scene/scene.hpp"
#include "scene/user_table.hpp"

namespace photic::scene {

/// The reason why a value is refused, without the key's name: "must be …, not …".
struct Refusal {
  std::string reason;
  std::string suggestion;
};

/// A finite number between bounds; whole numbers serve as well.
struct Number {
  using Value = double;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;
  const char* advice = "";  ///< to those who give another one
};
inline constexpr Number any_number{};
inline constexpr Number positive{.low = 0.0, .low_open = true};
inline constexpr Number not_negative{.low = 0.0};
constexpr Number from_to(double low, double high) { return {.low = low, .high = high}; }
constexpr Number between(double low, double high) {
  return {.low = low, .high = high, .low_open = true, .high_open = true};
}

/// A wavelength of light in nm: no optics are known of shorter ones, and whoever gives one means
/// another unit.
struct Wavelength {
  using Value = double;
  static constexpr double shortest_nm = 100;
};

/// A whole number between bounds; 1e7 serves as well.
struct Count {
  using Value = std::int64_t;
  std::int64_t low = 1;
  std::int64_t high = std::numeric_limits<std::int64_t>::max();
};

/// true or false.
struct YesOrNo {
  using Value = bool;
};

/// [a, b, …]: two or more finite numbers.
struct Numbers {
  using Value = std::vector<double>;
};

/// [a, b, …]: so many numbers or more.
struct NumberList {
  using Value = std::vector<double>;
  Number number;
  std::size_t least = 1;
};

/// [[zenith, azimuth], …]: directions in which light travels.
struct TravelDirections {
  using Value = std::vector<TravelDirection>;
};

/// A word to choose, and what it stands for.
struct Word {
  std::string word, meaning;
};

/// One of some words; `instead` is what to write for words that are none.
struct Choice {
  using Value = std::string;
  std::vector<Word> words;
  std::vector<Word> instead = {};
};

/// One of the values of an enum (choices.hpp).
template <class E>
struct ChoiceOf : Choice {
  using Value = E;
  explicit ChoiceOf(const std::vector<Word>& write_instead = {}) {
    for (const auto& [value, word, meaning] : alternatives(E{})) words.push_back({word, meaning});
    instead = write_instead;
  }
};

/// One line of text.
struct Text {
  using Value = std::string;
  bool may_be_empty = false;
};

/// A regular file that can be read, relative to the scene file; the value becomes its absolute
/// path.
struct File {
  using Value = std::string;
};

/// A column of a file: its name there, or its number from 1.
struct ColumnOfFile {
  using Value = optics::ColumnInFile;
};

/// The key that names a file in a table of its own, beside those that name columns.
inline constexpr const char* file_key = "file";

/// A table of numbers in a file of text: its name, { file = …, … } with what the file calls the
/// columns; or the columns in the scene.
struct TableOrFile {
  using Value = UserTable;
  struct Column {
    const char* name;
    const char* meaning;
    bool may_lack = false;
  };
  /// A number beside the columns in the scene, as files have it in their comments.
  struct NumberBeside {
    const char* name;
    const char* meaning;
    Number rule;
  };
  std::vector<Column> columns;
  optics::DataTable (*read)(const std::string& path) = optics::DataTable::read;  ///< a file
  std::vector<NumberBeside> numbers = {};
};
inline constexpr const char* file_with_columns_meaning =
    "a file of text with these columns, by their names there or their numbers";
/// "what the file calls its wavelength_nm, or its number from 1; by default wavelength_nm".
[[nodiscard]] std::string meaning_in_file(const TableOrFile::Column& column);

/// A number, or what it is at one or more of the columns that a table may lack: { file = … }, or
/// the columns.
struct NumberOrTable {
  using Value = std::variant<double, UserTable>;
  Number number;
  TableOrFile table;

  /// The columns of which there must be one.
  [[nodiscard]] std::vector<std::string> depends_on() const;
};

/// A word, or a table as above.
struct WordOrTable {
  using Value = std::variant<std::string, UserTable>;
  Choice words;
  TableOrFile table;
};

/// [x, y, z], finite.
struct Position {
  using Value = Vec3<double>;
};

/// [x, y, z], finite and not zero.
struct Direction {
  using Value = Vec3<double>;
};

/// True if the values of a rule are numbers, which have a unit.
template <class Rule>
inline constexpr bool is_quantity = requires {
  requires(std::is_arithmetic_v<typename Rule::Value> &&
           !std::is_same_v<typename Rule::Value, bool>) ||
              std::is_same_v<typename Rule::Value, NumberOrTable::Value> ||
              std::is_same_v<typename Rule::Value, std::vector<double>> ||
              std::is_same_v<typename Rule::Value, std::vector<TravelDirection>> ||
              std::is_same_v<typename Rule::Value, Vec3<double>>;
};

/// Checks a value and stores it if it passes. `folder` is where relative files lie; without one no
/// file may be named.
std::optional<Refusal> check(const Number& rule, const Node& node, double& value);
std::optional<Refusal> check(const Wavelength& rule, const Node& node, double& value);
std::optional<Refusal> check(const Count& rule, const Node& node, std::int64_t& value);
std::optional<Refusal> check(const YesOrNo& rule, const Node& node, bool& value);
std::optional<Refusal> check(const Numbers& rule, const Node& node, std::vector<double>& value);
std::optional<Refusal> check(const NumberList& rule, const Node& node, std::vector<double>& value);
std::optional<Refusal> check(const TravelDirections& rule, const Node& node,
                             std::vector<TravelDirection>& value);
std::optional<Refusal> check(const Choice& rule, const Node& node, std::string& value);
template <class E>
std::optional<Refusal> check(const ChoiceOf<E>& rule, const Node& node, E& value) {
  std::string word;
  if (auto problem = check(static_cast<const Choice&>(rule), node, word)) return problem;
  value = value_of<E>(word);
  return std::nullopt;
}
std::optional<Refusal> check(const Text& rule, const Node& node, std::string& value);
std::optional<Refusal> check(const File& rule, const Node& node, std::string& value,
                             const std::optional<std::string>& folder);
std::optional<Refusal> check(const ColumnOfFile& rule, const Node& node,
                             optics::ColumnInFile& value);
std::optional<Refusal> check(const Position& rule, const Node& node, Vec3<double>& value);
std::optional<Refusal> check(const Direction& rule, const Node& node, Vec3<double>& value);

/// A value of a choice in the tree of a scene.
template <class E>
  requires std::is_enum_v<E>
Node to_node(E value) {
  return to_node(word_of(value));
}

Node to_node(const std::vector<TravelDirection>& value);

/// The rule as JSON Schema.
Node schema_of(const Number& rule);
Node schema_of(const Wavelength& rule);
Node schema_of(const Count& rule);
Node schema_of(const YesOrNo& rule);
Node schema_of(const Numbers& rule);
Node schema_of(const NumberList& rule);
Node schema_of(const TravelDirections& rule);
Node schema_of(const Choice& rule);
Node schema_of(const Text& rule);
Node schema_of(const File& rule);
Node schema_of(const ColumnOfFile& rule);
Node schema_of(const TableOrFile& rule);
Node schema_of(const NumberOrTable& rule);
Node schema_of(const WordOrTable& rule);
Node schema_of(const Position& rule);
Node schema_of(const Direction& rule);

}  // namespace photic::scene
