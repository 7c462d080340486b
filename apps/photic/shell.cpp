#include "photic/shell.hpp"

namespace photic::app {
namespace {

std::string joined(std::string out, const std::vector<std::string>& words) {
  for (const std::string& word : words) out += ' ' + quoted(word);
  return out;
}

}  // namespace

std::string quoted(const std::string& word) {
  if (!word.empty() && word.find_first_of(" \t\n'\"\\$*?[]{}();&|<>#~`!") == std::string::npos)
    return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + '\'';
}

std::string as_file(const std::string& name) { return name.starts_with('-') ? "./" + name : name; }

std::string Call::command(const std::vector<std::string>& arguments) const {
  return joined(quoted(program), arguments);
}

Call call_of(int argc, const char* const* argv) {
  Call call;
  // A name without a folder was found in the PATH, and will be again.
  if (argc > 0 && *argv[0] != '\0') call.program = argv[0];
  for (int i = 1; i < argc; ++i) call.words.emplace_back(argv[i]);
  call.line = joined("photic", call.words);
  return call;
}

}  // namespace photic::app
