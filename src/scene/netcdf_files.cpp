#include "scene/netcdf_files.hpp"

#include <map>
#include <memory>
#include <tuple>

#include "scene/node.hpp"

namespace photic::scene {
namespace {

/// Keeps a function's results for the same texts, but not its exceptions.
template <class Result, class... Texts>
std::function<Result(const Texts&...)> kept(std::function<Result(const Texts&...)> read) {
  using Known = std::map<std::tuple<Texts...>, Result>;
  return [read, known = std::make_shared<Known>()](const Texts&... texts) {
    const auto at = known->find({texts...});
    return at != known->end() ? at->second
                              : known->emplace(std::tuple(texts...), read(texts...)).first->second;
  };
}

}  // namespace

std::string NetcdfHeader::text(const std::string& name) const {
  const auto at = attribute.find(name);
  return at == attribute.end() ? "" : at->second;
}

std::string NetcdfCodes::code(std::size_t i) const {
  return text.empty() ? plain_number(number[i]) : text[i];
}

std::string NetcdfCodes::code_text(std::size_t i) const {
  return text.empty() ? code(i) : quoted(shortened(text[i]));
}

NetcdfFiles read_once(const NetcdfFiles& files) {
  if (!files.contents) return files;
  return {kept(files.contents), kept(files.read), kept(files.codes)};
}

}  // namespace photic::scene
