// A program on Photic's library: the echo of a scene, gate by gate.
#include <cstdio>
#include <exception>

#include "session/read.hpp"
#include "session/run.hpp"

int main(int, char** argv) try {
  using namespace photic;
  const session::Context context = session::make_context(argv[1]);
  session::Run run(context, session::read_file(context, argv[2]).scene, {});
  const tally::Result result = run.result();
  for (std::size_t i = 0; i < result.echo.mean.size(); ++i)
    std::printf("%.17g %.17g\n", result.echo.mean[i], result.echo.standard_error[i]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
