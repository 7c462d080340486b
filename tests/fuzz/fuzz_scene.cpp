// Scene files of any bytes. A scene that is read must be written so that it reads back.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fuzz/refuse.hpp"
#include "scene/read.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  photic::test::read_or_refuse([&] {
    using namespace photic::scene;
    const Scene scene = read_scene_text(text, "fuzz.toml", "/nonexistent").scene;
    if (!(read_scene_text(write_scene(scene), "written.toml", "/nonexistent").scene == scene))
      std::abort();
  });
  return 0;
}
