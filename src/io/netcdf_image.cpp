#include "io/netcdf_image.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <netcdf.h>
#include <netcdf_mem.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <type_traits>

#include "core/error.hpp"

namespace photic::io {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

void check(int status, const std::string& what) {
  if (status != NC_NOERR)
    throw EnvironmentError(fmt::format("netCDF, {}: {}", what, nc_strerror(status)));
}

/// An empty HDF5 file in memory that keeps the order of creation, as netCDF-4 files do.
/// nc_create_mem leaves that out (netCDF-C 4.9.0), and then no program may add to the file:
/// "NetCDF: Can't write file".
NC_memio empty_file() {
  constexpr unsigned ordered = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
  const hid_t in_memory = H5Pcreate(H5P_FILE_ACCESS), creation = H5Pcreate(H5P_FILE_CREATE);
  H5Pset_fapl_core(in_memory, 4096, false);
  H5Pset_link_creation_order(creation, ordered);
  H5Pset_attr_creation_order(creation, ordered);
  const hid_t file = H5Fcreate("photic", H5F_ACC_TRUNC, creation, in_memory);
  H5Fflush(file, H5F_SCOPE_GLOBAL);
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  NC_memio memory{};
  if (size > 0)
    memory = {static_cast<std::size_t>(size), std::malloc(static_cast<std::size_t>(size)), 0};
  if (memory.memory != nullptr) H5Fget_file_image(file, memory.memory, memory.size);
  H5Fclose(file);
  H5Pclose(creation);
  H5Pclose(in_memory);
  check(memory.memory == nullptr ? NC_ENOMEM : NC_NOERR, "making a file in memory");
  return memory;
}

int type_of(const Values& values) {
  return std::visit(Overloaded{[](std::span<const double>) { return NC_DOUBLE; },
                               [](std::span<const float>) { return NC_FLOAT; },
                               [](std::span<const std::int32_t>) { return NC_INT; },
                               [](std::span<const std::int8_t>) { return NC_BYTE; },
                               [](std::span<const std::uint64_t>) { return NC_UINT64; },
                               [](std::span<const std::string>) { return NC_STRING; }},
                    values);
}

/// The pieces that a variable is compressed in: values that lie one behind the other, as the last
/// dimensions have them. The choice of netCDF would cut all dimensions, and its pieces are gathered
/// from afar.
std::vector<std::size_t> chunk_of(std::vector<std::size_t> lengths) {
  std::size_t room = std::size_t{1} << 15;  // values; some 1e5 bytes fit a processor's cache
  for (auto length = lengths.rbegin(); length != lengths.rend(); ++length) {
    *length = std::clamp<std::size_t>(room, 1, *length);
    room /= *length;
  }
  return lengths;
}

/// Pieces that wait to be compressed: each is written once, and whole. By default every variable
/// would keep 16 MB of them until the file is finished.
constexpr std::size_t cache_bytes = std::size_t{1} << 20, cache_slots = 101;

int put_values(int file, int variable, const Values& values) {
  return std::visit(
      [&](auto span) {
        if constexpr (std::is_same_v<typename decltype(span)::value_type, std::string>) {
          std::vector<const char*> texts;
          for (const std::string& text : span) texts.push_back(text.c_str());
          return nc_put_var_string(file, variable, texts.data());
        } else {
          return nc_put_var(file, variable, span.data());
        }
      },
      values);
}

/// The chunks that are not all zeros.
template <class Number>
int put_nonzero(int file, int variable, std::span<const Number> values,
                const std::vector<std::size_t>& lengths, std::vector<std::size_t> count) {
  // A chunk has some of one dimension, all of those after it, and one of each before it.
  std::size_t cut = lengths.size() - 1;
  while (cut > 0 && count[cut] == lengths[cut]) --cut;
  std::size_t after = 1;
  for (std::size_t d = cut + 1; d < lengths.size(); ++d) after *= lengths[d];
  const std::size_t step = count[cut];
  for (std::size_t first = 0; first < values.size();) {
    std::vector<std::size_t> start(lengths.size(), 0);
    std::size_t row = first / after;
    for (std::size_t d = cut + 1; d-- > 0; row /= lengths[d]) start[d] = row % lengths[d];
    count[cut] = std::min(step, lengths[cut] - start[cut]);
    const auto block = values.subspan(first, count[cut] * after);
    first += block.size();
    if (std::ranges::all_of(block, [](Number value) { return value == 0; })) continue;
    const int status = nc_put_vara(file, variable, start.data(), count.data(), block.data());
    if (status != NC_NOERR) return status;
  }
  return NC_NOERR;
}

}  // namespace

NetcdfImage::NetcdfImage() {
  NC_memio memory = empty_file();  // netCDF takes it over
  check(nc_open_memio("photic", NC_WRITE, &memory, &file_), "making a file in memory");
  group_ = file_;
}

NetcdfImage::~NetcdfImage() {
  if (file_ >= 0) nc_abort(file_);
}

void NetcdfImage::enter_group(const std::string& name) {
  check(nc_def_grp(file_, name.c_str(), &group_), name);
}

void NetcdfImage::add_dimension(const std::string& name, std::size_t size) {
  expect(size > 0, "a dimension of at least 1: 0 would mean unlimited");
  int id = 0;
  check(nc_def_dim(group_, name.c_str(), size, &id), name);
  dimensions_[name] = {id, size};
}

void NetcdfImage::add_global(const std::string& name, const AttributeValue& value) {
  put_attribute(NC_GLOBAL, name, value);
}

void NetcdfImage::put_attribute(int variable, const std::string& name,
                                const AttributeValue& value) {
  const char* key = name.c_str();
  const int status = std::visit(
      Overloaded{
          [&](const std::string& text) {
            return nc_put_att_text(group_, variable, key, text.size(), text.data());
          },
          [&](const LongText& long_text) {
            const char* text = long_text.text.c_str();
            return nc_put_att_string(group_, variable, key, 1, &text);
          },
          [&](double number) {
            return nc_put_att_double(group_, variable, key, NC_DOUBLE, 1, &number);
          },
          [&](float number) {
            return nc_put_att_float(group_, variable, key, NC_FLOAT, 1, &number);
          },
          [&](std::int32_t number) {
            return nc_put_att_int(group_, variable, key, NC_INT, 1, &number);
          },
          [&](std::uint64_t number) {
            return nc_put_att(group_, variable, key, NC_UINT64, 1, &number);
          },
          [&](const std::vector<std::int32_t>& numbers) {
            return nc_put_att_int(group_, variable, key, NC_INT, numbers.size(), numbers.data());
          },
          [&](const std::vector<std::int8_t>& numbers) {
            return nc_put_att_schar(group_, variable, key, NC_BYTE, numbers.size(), numbers.data());
          }},
      value);
  check(status, "attribute " + name);
}

void NetcdfImage::add_variable(const std::string& name, const std::vector<std::string>& dimensions,
                               Values values, const Attributes& attributes, Zeros zeros) {
  std::vector<int> ids;
  std::vector<std::size_t> lengths;
  std::size_t size = 1;
  for (const auto& dimension : dimensions) {
    const auto& [id, length] = dimensions_.at(dimension);
    ids.push_back(id);
    lengths.push_back(length);
    size *= length;
  }
  expect(std::visit([](auto span) { return span.size(); }, values) == size,
         "as many values as the dimensions of a variable ask for");
  int variable = 0;
  check(nc_def_var(group_, name.c_str(), type_of(values), static_cast<int>(ids.size()), ids.data(),
                   &variable),
        name);
  const auto chunk = chunk_of(lengths);
  if (ids.size() > 1) {
    check(nc_def_var_chunking(group_, variable, NC_CHUNKED, chunk.data()), name);
    check(nc_set_var_chunk_cache(group_, variable, cache_bytes, cache_slots, 1), name);
    check(nc_def_var_deflate(group_, variable, NC_SHUFFLE, 1, 1), name);
  }
  for (const auto& [key, value] : attributes) put_attribute(variable, key, value);
  if (zeros == Zeros::written) return check(put_values(group_, variable, values), name);
  std::visit(
      [&](auto span) {
        using Number = std::remove_const_t<typename decltype(span)::element_type>;
        if constexpr (std::is_arithmetic_v<Number>) {
          const Number zero = 0;
          check(nc_def_var_fill(group_, variable, NC_FILL, &zero), name);
          check(put_nonzero(group_, variable, span, lengths, chunk), name);
        }
      },
      values);
}

std::string NetcdfImage::finish() {
  NC_memio memory{};
  check(nc_close_memio(std::exchange(file_, -1), &memory), "finishing the file in memory");
  const std::unique_ptr<void, decltype(&std::free)> owner(memory.memory, &std::free);
  return {static_cast<const char*>(memory.memory), memory.size};
}

}  // namespace photic::io
