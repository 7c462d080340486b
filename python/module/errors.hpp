// Failures as exceptions of photic.errors.
#pragma once

#include <new>

#include "core/error.hpp"
#include "gil.hpp"

namespace photic::python {

inline void set_error(const char* kind, const py::tuple& arguments) {
  const py::object type = py::module_::import("photic.errors").attr(kind);
  PyErr_SetObject(type.ptr(), type(*arguments).ptr());
}

/// A scene's problems, each a photic.Problem.
inline py::tuple problems_of(const InputError& error) {
  const py::object problem = py::module_::import("photic.errors").attr("Problem");
  py::list problems;
  for (const Diagnostic& d : error.diagnostics())
    problems.append(problem(text_of(d.file), d.line, d.column, text_of(d.path), text_of(d.reason),
                            text_of(d.suggestion)));
  return py::make_tuple(text_of(error.what()), problems);
}

inline void translate(std::exception_ptr failure) {
  constexpr int failed = 1, bad_input = 2;
  try {
    if (failure) std::rethrow_exception(failure);
  } catch (const InputError& error) {
    set_error("SceneError", problems_of(error));
  } catch (const UsageError& error) {
    set_error("Error", py::make_tuple(text_of(error.what()), bad_input));
  } catch (const EnvironmentError& error) {
    set_error("Error", py::make_tuple(text_of(error.what()), failed));
  } catch (const std::bad_alloc&) {
    set_error(
        "Error",
        py::make_tuple("not enough memory (fewer gates, orders or telescopes need less)", failed));
  } catch (const ContractViolation& error) {
    set_error("Error", py::make_tuple(
                           text_of(std::string("this is a bug, please report it: ") + error.what()),
                           failed));
  }
}

}  // namespace photic::python
