// Tables of any bytes behind a first one that says what they are read as.
#include <cstdint>
#include <string>

#include "fuzz/refuse.hpp"
#include "optics/atmosphere.hpp"
#include "optics/fluorescence.hpp"
#include "optics/phase_from_table.hpp"
#include "optics/phytoplankton_table.hpp"
#include "optics/size_distribution.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  photic::test::read_or_refuse([&] {
    using namespace photic::optics;
    const DataTable table = DataTable::parse(text, "fuzz.csv");
    switch (data[0]) {
      case 'a':
        air_profile(with_all_humidities(table));
        break;
      case 'c':
        cdom_fluorescence(table, 355.0);
        break;
      case 'n':
        static_cast<void>(table.with({{"x", {"", 1}}, {"y", {"", 2}}}).numbers("y"));
        break;
      case 'p':
        phase_from_table(table);
        break;
      case 'r':
        size_table(table);
        break;
      default:
        phytoplankton_table(table);
        break;
    }
  });
  return 0;
}
