// PHOTIC_FLATTEN: everything that the function calls becomes part of it: the loops of photons need
// that. It is off where a sanitizer would take minutes to see through the result.
// PHOTIC_APART: the function is never part of such a loop, whose registers are too few for code
// that few scenes need.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PHOTIC_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PHOTIC_SANITIZED
#endif
#endif
#if defined(PHOTIC_SANITIZED)
#define PHOTIC_FLATTEN
#else
#define PHOTIC_FLATTEN [[gnu::flatten]]
#endif
#define PHOTIC_APART [[gnu::noinline]]
