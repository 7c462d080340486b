// Python's values as those of a scene, and back.
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "gil.hpp"
#include "scene/findings.hpp"
#include "scene/node.hpp"
#include "session/document.hpp"

namespace photic::python {

/// Reads Python's values: bool, numbers, text, paths of files, dates, mappings, sequences, and what
/// becomes such by tolist() or __array__(), as what numpy and xarray have. Throws InputError, with
/// the path, for all else.
class ValueReader {
 public:
  scene::Node read(const py::handle& value, const std::string& path) {
    PyObject* const p = value.ptr();
    if (PyBool_Check(p)) return scene::to_node(p == Py_True);
    if (PyLong_Check(p)) return whole(value, path);
    if (PyFloat_Check(p)) return scene::to_node(PyFloat_AS_DOUBLE(p));
    if (PyUnicode_Check(p)) return scene::to_node(text(value, path));
    if (PyType_Check(p)) return other(value, path);
    if (is_time(value, path)) return date();
    if (py::hasattr(value, "tolist")) return nested(value, path, &ValueReader::listed);
    if (py::hasattr(value, "__array__")) return nested(value, path, &ValueReader::as_array);
    if (is_a("collections.abc", "Mapping", value)) return nested(value, path, &ValueReader::table);
    if (PyList_Check(p) || PyTuple_Check(p)) return nested(value, path, &ValueReader::array);
    return other(value, path);
  }

 private:
  [[noreturn]] static void refuse(const std::string& path, std::string reason,
                                  std::string suggestion = "") {
    throw InputError({{path, 0, 0, std::move(reason), std::move(suggestion), path}});
  }

  static bool is_a(const char* module, const char* type, const py::handle& value) {
    return py::isinstance(value, py::module_::import(module).attr(type));
  }

  static scene::Node whole(const py::handle& value, const std::string& path) {
    int overflow = 0;
    const std::int64_t number = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
    if (overflow != 0) refuse(path, "is a whole number beyond 64 bits", "write it with a point");
    return scene::to_node(number);
  }

  static std::string text(const py::handle& value, const std::string& path) {
    Py_ssize_t size = 0;
    const char* utf8 = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
    if (utf8 == nullptr) {
      PyErr_Clear();
      refuse(path, "is text with a character that UTF-8 does not have");
    }
    std::string out(utf8, static_cast<std::size_t>(size));
    if (out.find('\0') != std::string::npos) refuse(path, "is text with a null byte");
    return out;
  }

  /// The return value of a call of Python's; what it raises is a reason to refuse the value.
  template <class Call>
  static auto made(const std::string& path, const char* what, Call call) {
    try {
      return call();
    } catch (py::error_already_set& error) {
      if (!error.matches(PyExc_Exception)) throw;
      refuse(path, std::string(what) + ": " + py::str(error.value()).cast<std::string>());
    }
  }

  /// Returns whether a value is numpy's dates. Durations, which it has as integers, are refused.
  static bool is_time(const py::handle& value, const std::string& path) {
    const py::object type = py::getattr(value, "dtype", py::none());
    const py::object kind = py::getattr(type, "kind", py::none());
    if (!PyUnicode_Check(kind.ptr())) return false;
    if (kind.equal(py::str("m")))
      refuse(path, "a scene holds no value of Python's type timedelta64",
             "a number, in the unit that its key has");
    return kind.equal(py::str("M"));
  }
  static scene::Node date() {
    scene::Node date;
    date.value = scene::Date{};
    return date;
  }

  /// The value that tolist() makes of an array or of a number of numpy. Some, as long doubles, it
  /// leaves.
  scene::Node listed(const py::handle& value, const std::string& path) {
    const auto list = made(path, "cannot be made a list", [&] { return value.attr("tolist")(); });
    if (list.get_type().is(value.get_type())) return other(value, path);
    return read(list, path);
  }
  scene::Node as_array(const py::handle& value, const std::string& path) {
    const py::object numpy = py::module_::import("numpy");
    return read(made(path, "cannot be made an array", [&] { return numpy.attr("asarray")(value); }),
                path);
  }

  static scene::Node other(const py::handle& value, const std::string& path) {
    if (is_a("datetime", "date", value) || is_a("datetime", "time", value)) return date();
    if (is_a("os", "PathLike", value))
      return scene::to_node(
          text(made(path, "is no name of a file",
                    [&] { return py::module_::import("os").attr("fsdecode")(value); }),
               path));
    if (is_a("numbers", "Real", value) || is_a("decimal", "Decimal", value))
      return scene::to_node(made(path, "is no number that a scene holds",
                                 [&] { return value.attr("__float__")().cast<double>(); }));
    const auto type = value.get_type().attr("__name__").cast<std::string>();
    refuse(path, "a scene holds no value of Python's type " + type,
           "numbers, texts, true or false, lists and dicts of these");
  }

  using Part = scene::Node (ValueReader::*)(const py::handle&, const std::string&);
  scene::Node nested(const py::handle& value, const std::string& path, Part part) {
    constexpr std::size_t deepest = 64;
    for (const PyObject* around : around_)
      if (around == value.ptr()) refuse(path, "is a value that holds itself");
    if (around_.size() == deepest) refuse(path, "is more than 64 values deep");
    around_.push_back(value.ptr());
    scene::Node out = (this->*part)(value, path);
    around_.pop_back();
    return out;
  }

  scene::Node table(const py::handle& value, const std::string& path) {
    scene::Node out = scene::empty_table();
    const auto items = made(path, "has no items", [&] { return py::list(value.attr("items")()); });
    for (const py::handle item : items) {
      if (!PyTuple_Check(item.ptr()) || PyTuple_GET_SIZE(item.ptr()) != 2)
        refuse(path, "has items that are no pairs");
      const auto pair = py::reinterpret_borrow<py::tuple>(item);
      const py::object key = pair[0];
      if (!PyUnicode_Check(key.ptr()))
        refuse(path, "has the key " + py::repr(key).cast<std::string>(), "keys are text");
      std::string name = text(key, path);
      scene::Node below = read(pair[1], scene::below(path, name));
      out.add(std::move(name), std::move(below));
    }
    return out;
  }

  scene::Node array(const py::handle& value, const std::string& path) {
    scene::Node::Array out;
    for (const py::handle element : value)
      out.push_back(read(element, scene::below(path, out.size())));
    scene::Node node;
    node.value = std::move(out);
    return node;
  }

  std::vector<const PyObject*> around_;
};

/// Changes of a scene, by their paths.
inline std::vector<session::Change> changes_of(const py::dict& changes) {
  std::vector<session::Change> out;
  for (const auto& [key, value] : changes) {
    const auto path = key.cast<std::string>();
    out.push_back({path, ValueReader().read(value, path)});
  }
  return out;
}

inline py::object value_of(const scene::Node& node) {
  if (const auto* b = node.as<bool>()) return py::bool_(*b);
  if (const auto* i = node.as<std::int64_t>()) return py::int_(*i);
  if (const auto* d = node.as<double>()) return py::float_(*d);
  if (const auto* text = node.as<std::string>()) return text_of(*text);
  if (const auto* array = node.as<scene::Node::Array>()) {
    py::list out;
    for (const scene::Node& element : *array) out.append(value_of(element));
    return out;
  }
  const auto* table = node.as<scene::Node::Table>();
  expect(table != nullptr, "a scene that was checked has no dates");
  py::dict out;
  for (const scene::Entry& entry : *table) out[text_of(entry.key)] = value_of(entry.value);
  return out;
}

}  // namespace photic::python
