// Files that appear whole or not at all: whatever fails, what was there before stays as it was.
#pragma once

#include <string>
#include <string_view>

namespace photic::io {

/// Puts `content` at `path` in one step: a temporary file in the same folder is written, forced to
/// the disk and renamed. Symbolic links are followed; what is neither a regular file nor missing is
/// refused. Throws EnvironmentError, which names the file and the reason; then the temporary is
/// gone. What is there already goes to `keep_as`, a name in the same folder, if one is given, and
/// replaces what has that name; else it is gone.
void write_atomically(const std::string& path, std::string_view content,
                      const std::string& keep_as = "");

/// The file that a path stands for where it is a link, there or not yet; else the path. Throws
/// EnvironmentError for links in a circle.
std::string behind_links(const std::string& path);

/// Throws what write_atomically would throw for a small file now, and leaves nothing behind:
/// to be asked before a long run, not after it.
void check_writable(const std::string& path);

}  // namespace photic::io
