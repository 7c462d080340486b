// Files that appear whole or not at all: whatever fails, what was there before stays as it was.
#pragma once

#include <string>
#include <string_view>

namespace photic::io {

/// Puts `content` at `path` in one step: a temporary file in the same folder is written, forced to
/// the disk and renamed. Symbolic links are followed; what is neither a regular file nor missing is
/// refused. Throws EnvironmentError, which names the file and the reason; then the temporary is
/// gone.
void write_atomically(const std::string& path, std::string_view content);

/// Throws what write_atomically would throw for a small file now, and leaves nothing behind:
/// to be asked before a long run, not after it.
void check_writable(const std::string& path);

}  // namespace photic::io
