// PHOTIC_FLATTEN: everything that the function calls becomes part of it, which the loops of photons
// live by. Not where a sanitizer would take minutes to see through what comes out.
// PHOTIC_APART: never part of such a loop, whose registers are too few for what few scenes need.
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
