// photic._core: what the Python package does by the library. Thin; the package is the interface.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/isa.hpp"
#include "documents.hpp"
#include "errors.hpp"
#include "gil.hpp"
#include "io/atomic_file.hpp"
#include "io/netcdf_lock.hpp"
#include "io/netcdf_probe.hpp"
#include "optics.hpp"
#include "runs.hpp"
#include "scene/read.hpp"
#include "scene/scene_paths.hpp"
#include "session/context.hpp"
#include "session/progress_line.hpp"
#include "session/quantities.hpp"

namespace photic::python {
namespace {

const char* phase_name(run::Phase phase) {
  switch (phase) {
    case run::Phase::preparing:
      return "preparing";
    case run::Phase::choosing:
      return "choosing";
    case run::Phase::running:
      return "running";
    case run::Phase::ended:
      return "ended";
  }
  return "";
}

/// io's lock, held by the thread that made this one until it calls release().
class NetcdfLock {
 public:
  NetcdfLock() : lock_(without_gil([] { return std::make_unique<io::NetcdfLock>(); })) {}
  void release() { lock_.reset(); }

 private:
  std::unique_ptr<io::NetcdfLock> lock_;
};

session::SceneText file_text(const std::string& path) {
  return {scene::text_of_scene(path), path, session::folder_of(path)};
}

/// Throws std::invalid_argument for an instruction set that there is none of.
void expect_isa(const std::string& isa) {
  if (isa.empty() || isa_of(isa)) return;
  std::string names;
  for (const Isa one : isas) names += std::string(names.empty() ? "" : ", ") + isa_name(one);
  throw std::invalid_argument("'" + isa + "' is no instruction set (choose from " + names + ")");
}

constexpr const char* progress_text =
    R"(How far a run is, as of its last batch end.

phase            "preparing" the model, "choosing" an estimator by pilot runs, "running" or "ended"
pilots_done, pilots  pilot runs, and those known so far
photons          so many, of which photons_before from an earlier run that this one goes on from
photons_asked    None if they are no limit
elapsed_s        [s] since the first batch began; max_time_s: its limit, or None
gates_converged, gates  those of all telescopes and channels that light can reach
worst_error      the largest relative standard error of these; target: its aim, or None
line(width)      all of it in so many columns, as the program draws it

Source: photic.Scene.start, and `progress` of photic.Scene.run.)";

void add_progress(py::module_& m) {
  using run::Progress;
  py::class_<Progress>(m, "Progress", progress_text)
      .def_property_readonly("phase", [](const Progress& p) { return phase_name(p.phase); })
      .def_readonly("pilots_done", &Progress::pilots_done)
      .def_readonly("pilots", &Progress::pilots)
      .def_readonly("photons", &Progress::photons)
      .def_readonly("photons_before", &Progress::photons_before)
      .def_readonly("photons_asked", &Progress::photons_asked)
      .def_readonly("elapsed_s", &Progress::elapsed_s)
      .def_readonly("max_time_s", &Progress::max_time_s)
      .def_readonly("gates_converged", &Progress::gates_converged)
      .def_readonly("gates", &Progress::gates)
      .def_readonly("worst_error", &Progress::worst_error)
      .def_readonly("target", &Progress::target)
      .def("line", &session::progress_line, py::arg("width"));
}

void add_documents(py::module_& m) {
  py::class_<session::Context>(m, "Context")
      .def(py::init([](const std::string& data_folder) {
             return without_gil([&] { return session::make_context(data_folder); });
           }),
           py::arg("data_folder"));
  py::class_<Document>(m, "Document")
      .def_static(
          "load",
          [](const session::Context& context, const std::string& path, const py::dict& changes) {
            const auto text = without_gil([&] { return file_text(path); });
            return Document::of_text(context, text, changes_of(changes));
          },
          py::arg("context"), py::arg("path"), py::arg("changes"))
      .def_static(
          "of_text",
          [](const session::Context& context, const std::string& text, const std::string& name,
             const std::string& folder, const py::dict& changes) {
            return Document::of_text(context, {text, name, folder}, changes_of(changes));
          },
          py::arg("context"), py::arg("text"), py::arg("name"), py::arg("folder"),
          py::arg("changes"))
      .def_static(
          "of_values",
          [](const session::Context& context, const py::object& values, const py::dict& changes) {
            return Document::of_values(context, values, changes_of(changes));
          },
          py::arg("context"), py::arg("values"), py::arg("changes"))
      .def(
          "change",
          [](Document& document, const py::dict& changes) { document.change(changes_of(changes)); },
          py::arg("changes"))
      .def(
          "take_away",
          [](Document& document, const std::string& path) {
            document.change({{path, std::nullopt}});
          },
          py::arg("path"))
      .def(
          "changed",
          [](const Document& document, const py::dict& changes) {
            return document.changed(changes_of(changes));
          },
          py::arg("changes"))
      .def("find", &Document::find, py::arg("path"))
      .def("toml", &Document::toml)
      .def_property_readonly("remarks", &Document::remarks)
      .def_property_readonly("name", &Document::name)
      .def_property_readonly("folder", &Document::folder);
}

void add_runs(py::module_& m) {
  py::class_<Output>(m, "Output")
      .def(py::init<std::string, std::string, bool, std::optional<double>>(), py::arg("path"),
           py::arg("scene_file"), py::arg("force"), py::arg("checkpoint_s"));
  py::class_<Run>(m, "Run")
      .def(
          py::init([](const session::Context& context, const Document& document, int threads,
                      const std::string& engine, const std::string& isa, const std::string& earlier,
                      const std::string& command, const std::optional<Output>& output) {
            expect_isa(isa);
            return std::make_unique<Run>(
                context, document,
                session::RunRequest{threads, engine, isa, earlier, command, keywords()}, output);
          }),
          py::arg("context"), py::arg("document"), py::kw_only(), py::arg("threads"),
          py::arg("engine"), py::arg("isa"), py::arg("earlier"), py::arg("command"),
          py::arg("output"))
      .def("stop", &Run::stop)
      .def("progress", &Run::progress)
      .def("end", &Run::end)
      .def("wait", &Run::wait, py::arg("milliseconds"))
      .def("so_far", &Run::so_far)
      .def("finish", &Run::finish)
      .def("lines", &Run::lines);
}

void add_texts(py::module_& m) {
  m.def("schema", [] { return text_of(scene::scene_schema(PHOTIC_VERSION)); });
  m.def("scene_paths", [] {
    std::vector<std::string> paths;
    for (const scene::ScenePath& one : scene::scene_paths()) paths.push_back(one.path);
    return paths;
  });
  m.def("starter_text", &scene::starter_scene, py::arg("kind"));
  m.def("starter_kinds", [] {
    std::map<std::string, std::string> kinds;
    for (const auto& [kind, summary] : scene::starter_kinds()) kinds[kind] = summary;
    return kinds;
  });
  m.def("photons_value", &session::photons_value, py::arg("text"));
  m.def("share_value", &session::share_value, py::arg("text"));
  m.def("seconds_value", &session::seconds_value, py::arg("text"));
  m.def("seed_value", &session::seed_value, py::arg("text"));
  m.def(
      "write_file",
      [](const std::string& path, const std::string& text) {
        without_gil([&] { io::write_atomically(path, text); });
      },
      py::arg("path"), py::arg("text"));
  m.def(
      "expect_netcdf",
      [](const std::string& path, bool groups) {
        without_gil([&] { io::expect_netcdf(path, groups); });
      },
      py::arg("path"), py::arg("groups"));
  m.def("renew_netcdf_lock", &io::NetcdfLock::renew);
  py::class_<NetcdfLock>(m, "NetcdfLock").def(py::init()).def("release", &NetcdfLock::release);
  m.def("optics_of", &optics_of, py::arg("context"), py::arg("document"), py::arg("wavelength_nm"),
        py::arg("command"));
  m.attr("version") = PHOTIC_VERSION;
}

}  // namespace
}  // namespace photic::python

PYBIND11_MODULE(_core, m) {
  using namespace photic::python;
  py::register_exception_translator(translate);
  add_progress(m);
  add_documents(m);
  add_runs(m);
  add_texts(m);
}
