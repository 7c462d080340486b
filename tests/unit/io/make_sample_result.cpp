// make_sample_result OUT.nc [ENVIRONMENT …]: writes the made-up result, for tests of what reads
// results.
#include <cstdio>
#include <exception>

#include "io/netcdf.hpp"
#include "unit/io/sample_result.hpp"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: make_sample_result OUT.nc [ENVIRONMENT ...]\n", stderr);
    return 2;
  }
  try {
    const std::vector<std::string> environments(argv + 2, argv + argc);
    photic::io::write_netcdf(photic::test::sample_result_in(environments), argv[1],
                             {"made up for a test"});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
