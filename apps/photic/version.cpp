#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/isa.hpp"
#include "photic/commands.hpp"
#include "photic/data_folder.hpp"
#include "photic/output.hpp"

namespace photic::app {
namespace {

#ifdef __clang__
constexpr const char* compiler = "Clang " __clang_version__;
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

std::string data_folder() {
  try {
    return find_data_folder();
  } catch (const EnvironmentError& none) {
    return none.what();
  }
}

/// The instruction sets that were built, the best first.
std::vector<std::string> instruction_sets() {
  std::vector<std::string> out;
  for (const Isa isa : isas) {
    if (is_built(isa))
      out.push_back(fmt::format("{}{}", isa_name(isa),
                                is_of_processor(isa) ? "" : " (not on this processor)"));
  }
  std::ranges::reverse(out);
  return out;
}

}  // namespace

int run(const VersionCommand& /*command*/) {
  print_out(fmt::format("photic {}\ncompiler: {}, {}\ninstruction sets: {}\ndata: {}\n",
                        PHOTIC_VERSION, compiler, PHOTIC_BUILD_TYPE,
                        fmt::join(instruction_sets(), ", "), data_folder()));
  return done;
}

}  // namespace photic::app
