// A netCDF file opened for reading, a result above all. Nothing in it is believed: whatever is not
// of the type and size asked for is an InputError that names the file.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/netcdf_lock.hpp"

namespace photic::io {

class NetcdfReader {
 public:
  /// Throws EnvironmentError if the file cannot be read, InputError if it is no netCDF file.
  /// `wanted` says in all such errors what file it should be.
  explicit NetcdfReader(
      std::string path,
      std::string wanted = "a result is what `photic run SCENE -o out.nc` writes");
  NetcdfReader(const NetcdfReader&) = delete;
  NetcdfReader& operator=(const NetcdfReader&) = delete;
  ~NetcdfReader();

  /// Throws InputError unless the file was written by Photic in a format that is known.
  void expect_result() const;
  /// The format that Photic wrote it in; throws InputError if it did not.
  [[nodiscard]] double format() const;

  /// The contents in the place of echoes: "the optics of layers" (io/optics_file.hpp), "spectra"
  /// (io/spectral_table.hpp). Empty: echoes.
  [[nodiscard]] std::string other_content() const;

  [[nodiscard]] bool has(const std::string& attribute) const;

  /// Whatever is read afterwards comes from this group; false if there is none.
  bool enter_group(const std::string& name);

  // Attributes. Numbers may have become others that say the same, since programs that write a
  // result again have types of their own.
  [[nodiscard]] std::string text(const std::string& name) const;
  [[nodiscard]] std::uint64_t count(const std::string& name) const;
  [[nodiscard]] double number(const std::string& name) const;

  // Variables whose dimensions have these lengths, the last fastest.
  [[nodiscard]] std::vector<double> numbers(const std::string& name,
                                            const std::vector<std::size_t>& lengths) const;
  [[nodiscard]] std::vector<std::uint64_t> counts(const std::string& name,
                                                  const std::vector<std::size_t>& lengths) const;

  /// In bytes.
  [[nodiscard]] std::size_t size() const;
  /// The number netCDF knows the file by.
  [[nodiscard]] int id() const { return file_; }

  /// Throws InputError about the file.
  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  template <class T>
  [[nodiscard]] std::vector<T> values(const std::string& name, int type,
                                      const std::vector<std::size_t>& lengths) const;
  [[nodiscard]] bool is_single_number(const std::string& name) const;
  [[nodiscard]] bool is_single(const std::string& name, int type) const;
  [[nodiscard]] std::vector<std::size_t> lengths_of(int variable) const;
  void check(int status, const std::string& name) const;

  NetcdfLock lock_;
  std::string path_, wanted_;
  int file_ = -1, group_ = -1;
};

}  // namespace photic::io
