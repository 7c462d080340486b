// What MODTRAN prints, of any bytes behind a first one that says which of its files.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fuzz/refuse.hpp"
#include "optics/modtran.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  photic::test::read_or_refuse([&] {
    using namespace photic::optics;
    if (is_tape6(text) && is_tape7(text)) std::abort();
    if (data[0] == '7')
      ModtranTransmittances(text, "tape7");
    else
      modtran_profile(text, "tape6");
  });
  return 0;
}
