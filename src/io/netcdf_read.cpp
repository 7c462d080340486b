#include <fmt/format.h>
#include <netcdf.h>

#include <filesystem>
#include <system_error>

#include "core/error.hpp"
#include "io/netcdf.hpp"

namespace photic::io {
namespace {

namespace fs = std::filesystem;

constexpr const char* what_is_wanted = "a result is what `photic run SCENE -o out.nc` writes";

[[noreturn]] void refuse(const std::string& path, const std::string& reason,
                         const std::string& suggestion = what_is_wanted) {
  throw InputError({{.file = path, .reason = reason, .suggestion = suggestion}});
}

/// An open netCDF file.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {
    // Asked of the file system first: netCDF would take some paths for addresses on the network.
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
      const std::string reason = error ? error.message() : "it is not a regular file";
      throw EnvironmentError(fmt::format("{}: cannot read the file: {}", path, reason));
    }
    const int status = nc_open(path.c_str(), NC_NOWRITE, &file_);
    if (status > 0)  // an errno of the system
      throw EnvironmentError(
          fmt::format("{}: cannot read the file: {}", path, nc_strerror(status)));
    if (status == NC_ENOTNC) refuse(path, "not a netCDF file");
    if (status != NC_NOERR)
      refuse(path, fmt::format("a damaged netCDF file: {}", nc_strerror(status)));
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { nc_close(file_); }

  [[nodiscard]] int format() const {
    int format = 0;
    if (nc_get_att_int(file_, NC_GLOBAL, "photic_format", &format) != NC_NOERR)
      refuse(path_, "a netCDF file, but not a result of Photic: it has no attribute photic_format");
    return format;
  }

  [[nodiscard]] std::string text(const char* name) const {
    nc_type type = NC_NAT;
    std::size_t length = 0;
    if (nc_inq_att(file_, NC_GLOBAL, name, &type, &length) != NC_NOERR || type != NC_STRING ||
        length != 1)
      refuse(path_, fmt::format("a damaged result: it has no attribute {} that is a text", name));
    char* text = nullptr;
    if (const int status = nc_get_att_string(file_, NC_GLOBAL, name, &text); status != NC_NOERR)
      refuse(path_, fmt::format("a damaged result: {}: {}", name, nc_strerror(status)));
    std::string copy = text;
    nc_free_string(1, &text);
    return copy;
  }

 private:
  std::string path_;
  int file_ = -1;
};

}  // namespace

std::string read_scene_attribute(const std::string& path) {
  const Reader reader(path);
  if (reader.format() > photic_format)
    refuse(path,
           fmt::format("written by a newer Photic (result format {}; this program reads up to {})",
                       reader.format(), photic_format),
           "use the newer Photic");
  return reader.text("scene");
}

}  // namespace photic::io
