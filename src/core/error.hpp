// Kinds of failure. Bad input is collected as diagnostics and reported all at once; a failed
// environment (disk, memory, missing data file) is an exception; a bug hits a contract.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace photic {

/// The environment failed: a file that cannot be read or written, memory that is not there.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One thing wrong with what the user wrote. Printed as "file:line:column: reason (suggestion)".
struct Diagnostic {
  std::string file;  ///< the file, or "--set path=value", or empty when it concerns no place
  int line = 0;      ///< from 1; 0 when the file has no lines
  int column = 0;    ///< from 1
  std::string reason;
  std::string suggestion;  ///< the advice; may be empty
  std::string path = {};   ///< of the scene's value, as --set names it; empty where there is none

  [[nodiscard]] std::string text() const;
};

/// Everything wrong with what the user wrote, in the order of the file.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// A command that cannot be followed; the text has what to write instead.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A bug: a promise between parts of the program was broken.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Always checked; cheap conditions at the borders of a module, never inside the history loop.
void expect(bool condition, const char* promise);

}  // namespace photic
