// make_sample_result OUT.nc [ENVIRONMENT …] [-- PARAMETER …]: writes the made-up result, for tests
// of what reads results.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "io/netcdf.hpp"
#include "unit/io/sample_result.hpp"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: make_sample_result OUT.nc [ENVIRONMENT ...] [-- PARAMETER ...]\n", stderr);
    return 2;
  }
  try {
    char** const end = argv + argc;
    char** const dashes = std::find(argv + 2, end, std::string("--"));
    const std::vector<std::string> environments(argv + 2, dashes);
    const std::vector<std::string> parameters(dashes == end ? end : dashes + 1, end);
    photic::io::write_netcdf(photic::test::sample_result_in(environments, parameters), argv[1],
                             {"made up for a test"});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
