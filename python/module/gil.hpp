// Python's lock, and texts on their way to Python.
#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace photic::python {

namespace py = pybind11;

/// Returns call(), made without Python's lock. The lock is taken back outside of any destructor: a
/// daemon thread that comes back when the interpreter has gone ends there, and unwinds.
template <class Call>
std::invoke_result_t<Call> without_gil(Call call) {
  using Value = std::invoke_result_t<Call>;
  std::exception_ptr failure;
  std::optional<std::conditional_t<std::is_void_v<Value>, bool, Value>> value;
  PyThreadState* const thread = PyEval_SaveThread();
  try {
    if constexpr (std::is_void_v<Value>)
      call();
    else
      value.emplace(call());
  } catch (...) {
    failure = std::current_exception();
  }
  PyEval_RestoreThread(thread);
  if (failure) std::rethrow_exception(failure);
  if constexpr (!std::is_void_v<Value>) return std::move(*value);
}

/// A text of Photic's, in which names of files may be no UTF-8.
inline py::str text_of(const std::string& text) {
  PyObject* made =
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "surrogateescape");
  if (made == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(made);
}

}  // namespace photic::python
