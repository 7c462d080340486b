// What a fuzzer asks of a reader of texts: what it reads, or an InputError that says something.
#pragma once

#include <cstdlib>
#include <string>

#include "core/error.hpp"

namespace photic::test {

/// Anything but an InputError with reasons ends the program, which the fuzzer reports.
template <class Reading>
void read_or_refuse(const Reading& reading) {
  try {
    reading();
  } catch (const InputError& error) {
    if (error.diagnostics().empty()) std::abort();
    for (const Diagnostic& d : error.diagnostics())
      if (d.reason.empty()) std::abort();
  }
}

}  // namespace photic::test
