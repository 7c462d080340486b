#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "estimator/model.hpp"
#include "io/netcdf_variable.hpp"
#include "photic/commands.hpp"
#include "photic/output.hpp"
#include "photic/tables.hpp"

namespace photic::app {
namespace {

std::vector<std::string> remarks_on(const CheckCommand& command) {
  return scene::read_scene(command.scene, command.overrides, optics_check(), io::netcdf_files())
      .remarks;
}

nlohmann::ordered_json as_json(const Diagnostic& d) {
  return {{"file", d.file},
          {"line", d.line},
          {"column", d.column},
          {"reason", d.reason},
          {"suggestion", d.suggestion}};
}

int check_as_json(const CheckCommand& command) {
  nlohmann::ordered_json out{{"scene", command.scene},
                             {"valid", true},
                             {"problems", nlohmann::ordered_json::array()},
                             {"remarks", nlohmann::ordered_json::array()}};
  try {
    out["remarks"] = remarks_on(command);
  } catch (const InputError& error) {
    out["valid"] = false;
    for (const Diagnostic& d : error.diagnostics()) out["problems"].push_back(as_json(d));
  }
  print_out(out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
  return out["valid"].get<bool>() ? done : bad_input;
}

}  // namespace

int run(const CheckCommand& command) {
  if (command.json) return check_as_json(command);
  for (const std::string& remark : remarks_on(command)) print_warning(remark + '\n');
  print_out(command.scene + ": no problems\n");
  return done;
}

}  // namespace photic::app
