// A dataset in memory, copied without Python's lock and handed to numpy without another copy.
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "gil.hpp"
#include "io/dataset.hpp"

namespace photic::python {

class Arrays : public io::Dataset {
 public:
  void add_dimension(const std::string& name, std::size_t size) override { size_[name] = size; }
  void add_global(const std::string& name, const io::AttributeValue& value) override {
    globals_.emplace_back(name, value);
  }
  void add_variable(const std::string& name, const std::vector<std::string>& dimensions,
                    io::Values values, const io::Attributes& attributes) override {
    variables_.push_back(
        {name, dimensions, std::make_shared<const Column>(copied(values)), attributes});
  }

  /// {"attributes": {name: value}, "variables": {name: (dimensions, array, attributes)}}, of the
  /// types that netCDF4 gives. Its arrays share their memory with this; what breaks it off, as
  /// Ctrl-C, takes nothing away.
  [[nodiscard]] py::dict hand_over() const {
    py::dict variables;
    for (const Variable& one : variables_) {
      py::list dimensions;
      std::vector<py::ssize_t> shape;
      for (const std::string& name : one.dimensions) {
        dimensions.append(text_of(name));
        shape.push_back(static_cast<py::ssize_t>(size_.at(name)));
      }
      const auto as_array = [&](const auto& column) { return array_of(column, one.column, shape); };
      variables[text_of(one.name)] = py::make_tuple(dimensions, std::visit(as_array, *one.column),
                                                    attributes_of(one.attributes));
    }
    py::dict out;
    out["attributes"] = attributes_of(globals_);
    out["variables"] = variables;
    return out;
  }

 private:
  using Column =
      std::variant<std::vector<double>, std::vector<float>, std::vector<std::int32_t>,
                   std::vector<std::int8_t>, std::vector<std::uint64_t>, std::vector<std::string>>;
  struct Variable {
    std::string name;
    std::vector<std::string> dimensions;
    std::shared_ptr<const Column> column;
    io::Attributes attributes;
  };

  static Column copied(const io::Values& values) {
    return std::visit(
        [](const auto& span) -> Column { return std::vector(span.begin(), span.end()); }, values);
  }

  using Owner = std::shared_ptr<const Column>;
  template <class Number>
  static py::array array_of(const std::vector<Number>& column, const Owner& all,
                            const std::vector<py::ssize_t>& shape) {
    auto kept = std::make_unique<Owner>(all);
    const py::capsule owner(kept.get(), [](void* p) { delete static_cast<Owner*>(p); });
    static_cast<void>(kept.release());
    return py::array_t<Number>(shape, column.data(), owner);
  }

  static py::array array_of(const std::vector<std::string>& column, const Owner&,
                            const std::vector<py::ssize_t>& shape) {
    py::list texts;
    for (const std::string& text : column) texts.append(text_of(text));
    const py::object empty = py::module_::import("numpy").attr("empty");
    py::array out = empty(py::cast(column.size()), "O");
    out[py::ellipsis()] = texts;
    return out.attr("reshape")(py::tuple(py::cast(shape)));
  }

  static py::dict attributes_of(const io::Attributes& attributes) {
    py::dict out;
    for (const auto& [name, value] : attributes)
      out[text_of(name)] = std::visit([](const auto& v) { return attribute(v); }, value);
    return out;
  }

  static py::object attribute(const std::string& text) { return text_of(text); }
  static py::object attribute(const io::LongText& text) { return text_of(text.text); }
  template <class Number>
  static py::object attribute(const Number& number) {
    return attribute(std::vector<Number>{number});
  }
  /// A single number is a scalar of numpy, as netCDF4 gives it.
  template <class Number>
  static py::object attribute(const std::vector<Number>& numbers) {
    const py::array_t<Number> array(static_cast<py::ssize_t>(numbers.size()), numbers.data());
    return numbers.size() == 1 ? py::object(array[py::int_(0)]) : py::object(array);
  }

  std::map<std::string, std::size_t> size_;
  io::Attributes globals_;
  std::vector<Variable> variables_;
};

}  // namespace photic::python
