#include "scene/netcdf_files.hpp"

#include <map>
#include <memory>
#include <utility>

namespace photic::scene {
namespace {

using NamesOfFiles = std::map<std::string, std::vector<std::string>>;
/// What a function gave for a path and a name is given again. What it throws is not kept.
template <class Read>
auto kept(const Read& read) {
  using Known = std::map<std::pair<std::string, std::string>, NetcdfVariable>;
  return [read, known = std::make_shared<Known>()](const std::string& path, const std::string& name,
                                                   auto... more) {
    const auto at = known->find({path, name});
    return at != known->end()
               ? at->second
               : known->emplace(std::pair(path, name), read(path, name, more...)).first->second;
  };
}

}  // namespace

NetcdfFiles read_once(const NetcdfFiles& files) {
  if (!files.names) return files;
  const auto names = [read = files.names,
                      known = std::make_shared<NamesOfFiles>()](const std::string& path) {
    const auto at = known->find(path);
    return at != known->end() ? at->second : known->emplace(path, read(path)).first->second;
  };
  return {names, kept(files.read), kept(files.flags)};
}

}  // namespace photic::scene
