#include <algorithm>

#include "photic/commands.hpp"
#include "photic/output.hpp"
#include "scene/scene_paths.hpp"

namespace photic::app {
namespace {

/// A word that may stand in the place of the one being completed, or the pattern of files that may:
/// "*.toml".
struct Candidate {
  std::string word;
  std::string meaning;  ///< may be empty
};

/// The choices that the words before the last one leave open.
struct Typed {
  const CommandManual& photic;
  const CommandManual* command;
  const OptionManual* awaiting = nullptr;  ///< the option whose value comes next
  bool free = true;                        ///< other words than its value may come as well
  std::size_t arguments = 0;               ///< their number so far
  std::vector<std::string> given = {};
};

const OptionManual* option_named(const CommandManual& command, const std::string& name) {
  for (const OptionManual& option : command.options)
    if (!option.positional && std::ranges::count(names_of(option), name) > 0) return &option;
  return nullptr;
}

/// The argument in that place; null: none is expected there.
const OptionManual* argument_at(const CommandManual& command, std::size_t place) {
  for (const OptionManual& option : command.options)
    if (option.positional && (option.repeated || place-- == 0)) return &option;
  return nullptr;
}

Typed read_words(const CommandManual& photic, const std::vector<std::string>& words) {
  Typed typed{.photic = photic, .command = &photic};
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const std::string& word = words[i];
    if (word.starts_with('-')) {
      typed.given.push_back(word.substr(0, word.find('=')));
      typed.awaiting = option_named(*typed.command, word);
      if (typed.awaiting != nullptr && typed.awaiting->value.empty()) typed.awaiting = nullptr;
      typed.free = typed.awaiting == nullptr || typed.awaiting->repeated;
    } else if (typed.awaiting != nullptr) {
      if (!typed.awaiting->repeated) typed.awaiting = nullptr;
      typed.free = true;
    } else if (!typed.command->commands.empty()) {
      for (const CommandManual& command : photic.commands)
        if (command.name == word) typed.command = &command;
    } else {
      ++typed.arguments;
    }
  }
  return typed;
}

/// "sea.layer.*.jerlov" for the word "sea.layer.2.je": with the 2, or with 0 where the word ends
/// before it.
std::string filled_path(const std::string& path, const std::string& word) {
  std::string out;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::size_t end = out.size() <= word.size() ? word.find('.', out.size()) : word.npos;
    if (path[i] != '*')
      out += path[i];
    else
      out += end == word.npos ? "0" : word.substr(out.size(), end - out.size());
  }
  return out;
}

/// Paths of a scene's values, or after one and "=" its values.
std::vector<Candidate> settings_of(const std::string& prefix, const std::string& word) {
  std::vector<Candidate> found;
  for (const scene::ScenePath& value : scene::scene_paths()) {
    if (!value.path.starts_with(prefix)) continue;
    const std::string key = filled_path(value.path, prefix + word).substr(prefix.size()) + '=';
    if (!word.starts_with(key)) found.push_back({key, value.meaning});
    if (word.starts_with(key))
      for (const auto& [choice, meaning] : value.choices) found.push_back({key + choice, meaning});
  }
  return found;
}

/// The candidates for one of the alternatives in the name of a value: "SCENE" of "SCENE|RESULT.nc".
std::vector<Candidate> candidates_by_name(const std::string& name, const std::string& word,
                                          const CommandManual& photic) {
  if (name == "SCENE") return {{"*.toml", ""}};
  if (name == "PATH=VALUE") return settings_of("", word);
  if (name == "KEY=VALUE") return settings_of("sea.layer.*.", word);
  std::vector<Candidate> found;
  if (name == "COMMAND")
    for (const CommandManual& command : photic.commands)
      found.push_back({command.name, command.meaning});
  if (name == "KIND")
    for (const auto& [kind, summary] : scene::starter_kinds()) found.push_back({kind, summary});
  if (name.starts_with("FILE")) found.push_back({"*", ""});
  if (const auto dot = name.rfind('.'); dot != std::string::npos)
    found.push_back({"*" + name.substr(dot), ""});
  return found;
}

std::vector<Candidate> values_of(const OptionManual& option, const std::string& word,
                                 const CommandManual& photic) {
  std::vector<Candidate> found;
  for (const std::string& choice : option.choices) found.push_back({choice, ""});
  for (std::size_t begin = 0; begin < option.value.size();) {
    const std::size_t end = std::min(option.value.find('|', begin), option.value.size());
    std::ranges::move(candidates_by_name(option.value.substr(begin, end - begin), word, photic),
                      std::back_inserter(found));
    begin = end + 1;
  }
  return found;
}

/// The options that may still be given.
std::vector<Candidate> options_left(const Typed& typed) {
  std::vector<Candidate> found;
  for (const OptionManual& option : typed.command->options) {
    const std::vector<std::string> names = names_of(option);
    const bool given = std::ranges::find_first_of(names, typed.given) != names.end();
    if (!option.positional && (option.again || !given))
      found.push_back({names.back(), option.meaning});
  }
  return found;
}

/// "--engine=l": the option's values, with its name before each.
std::vector<Candidate> values_after(const std::string& name, const Typed& typed,
                                    const std::string& word) {
  const OptionManual* option = option_named(*typed.command, name);
  if (option == nullptr) return {};
  std::vector<Candidate> found = values_of(*option, word, typed.photic);
  for (Candidate& candidate : found)
    if (!candidate.word.starts_with('*')) candidate.word.insert(0, name + '=');
  return found;
}

std::vector<Candidate> candidates_at(const Typed& typed, const std::string& word) {
  if (const auto equals = word.find('='); word.starts_with('-') && equals != std::string::npos)
    return values_after(word.substr(0, equals), typed, word.substr(equals + 1));
  if (!typed.free) return values_of(*typed.awaiting, word, typed.photic);
  if (word.starts_with('-')) return options_left(typed);
  std::vector<Candidate> found;
  for (const CommandManual& command : typed.command->commands)
    found.push_back({command.name, command.meaning});
  const OptionManual* expected =
      typed.awaiting != nullptr ? typed.awaiting : argument_at(*typed.command, typed.arguments);
  if (expected != nullptr) found = values_of(*expected, word, typed.photic);
  return found.empty() ? options_left(typed) : found;
}

}  // namespace

int run(const CompleteCommand& command) {
  const std::string& word = command.words.back();
  std::string out;
  for (const Candidate& candidate :
       candidates_at(read_words(command.program, command.words), word)) {
    if (!candidate.word.starts_with('*') && !candidate.word.starts_with(word)) continue;
    out += candidate.word + (candidate.meaning.empty() ? "" : '\t' + candidate.meaning) + '\n';
  }
  print_out(out);
  return done;
}

}  // namespace photic::app
