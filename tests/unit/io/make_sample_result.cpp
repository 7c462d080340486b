// make_sample_result OUT.nc [ENVIRONMENT …] [-- PARAMETER …] [--tallies]: writes the made-up
// result, for tests of what reads results; `make_sample_result OUT.nc --tallies-alone`: one without
// echoes.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "io/netcdf.hpp"
#include "unit/io/sample_result.hpp"
#include "unit/io/sample_tallies.hpp"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs(
        "usage: make_sample_result OUT.nc [ENVIRONMENT ...] [-- PARAMETER ...] "
        "[--tallies | --tallies-alone]\n",
        stderr);
    return 2;
  }
  try {
    const std::string last = argv[argc - 1];
    const bool alone = last == "--tallies-alone", beside = last == "--tallies";
    char** const end = argv + argc - (alone || beside ? 1 : 0);
    char** const dashes = std::find(argv + 2, end, std::string("--"));
    const std::vector<std::string> environments(argv + 2, dashes);
    const std::vector<std::string> parameters(dashes == end ? end : dashes + 1, end);
    photic::tally::Result result = alone ? photic::test::sample_tallies_alone()
                                         : photic::test::sample_result_in(environments, parameters);
    if (beside) photic::test::add_sample_tallies(result);
    photic::io::write_netcdf(result, argv[1], {"made up for a test"});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
