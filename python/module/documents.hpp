// Scenes of Python.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "gil.hpp"
#include "session/document.hpp"
#include "values.hpp"

namespace photic::python {

/// A scene that several threads of Python may read and change. They wait for each other without
/// Python's lock.
class Document {
 public:
  explicit Document(session::Document document) : document_(std::move(document)) {}

  static std::unique_ptr<Document> of_text(const session::Context& context,
                                           const session::SceneText& text,
                                           const std::vector<session::Change>& changes) {
    return without_gil(
        [&] { return std::make_unique<Document>(session::Document(context, text, changes)); });
  }
  static std::unique_ptr<Document> of_values(const session::Context& context,
                                             const py::object& values,
                                             const std::vector<session::Change>& changes) {
    scene::Node tree = ValueReader().read(values, "");
    return without_gil([&] {
      return std::make_unique<Document>(session::Document(context, std::move(tree), "", changes));
    });
  }

  void change(const std::vector<session::Change>& changes) {
    without_gil([&] {
      const std::scoped_lock lock(mutex_);
      document_.change(changes);
    });
  }
  [[nodiscard]] std::unique_ptr<Document> changed(
      const std::vector<session::Change>& changes) const {
    return without_gil([&] {
      auto out = std::make_unique<Document>(now());
      if (!changes.empty()) out->document_.change(changes);
      return out;
    });
  }

  /// Throws KeyError.
  [[nodiscard]] py::object find(const std::string& path) const {
    const auto node = without_gil([&] {
      const std::scoped_lock lock(mutex_);
      return document_.find(path);
    });
    if (!node) throw py::key_error(path);
    return value_of(*node);
  }
  [[nodiscard]] py::str toml() const {
    return text_of(without_gil([&] { return now().toml(); }));
  }
  [[nodiscard]] py::list remarks() const {
    py::list out;
    for (const std::string& remark : without_gil([&] { return now().reading().remarks; }))
      out.append(text_of(remark));
    return out;
  }
  [[nodiscard]] py::str name() const {
    return text_of(without_gil([&] { return now().name(); }));
  }
  [[nodiscard]] py::str folder() const {
    return text_of(without_gil([&] { return now().folder(); }));
  }

  /// A copy of the scene as it is now. Not with Python's lock.
  [[nodiscard]] session::Document now() const {
    const std::scoped_lock lock(mutex_);
    return document_;
  }

 private:
  mutable std::mutex mutex_;
  session::Document document_;
};

}  // namespace photic::python
