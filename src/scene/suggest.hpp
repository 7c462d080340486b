// "Did you mean": what to propose for a word that is not known.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace photic::scene {

/// "did you mean 'x'?" if one of the known words is close to `word`: the same but for case, for its
/// unit or for few letters, or longer by whole words ('half_divergence_mrad' for
/// 'divergence_mrad'). Differences besides letters are stated: the unit, or that 'x' is half of an
/// angle. Else "<lead>: a, b, c".
std::string suggestion_for(const std::string& word, const std::vector<std::string>& known,
                           const std::string& lead);

/// The same only of a known word that is the same but for case or for its unit.
std::optional<std::string> same_word(const std::string& word,
                                     const std::vector<std::string>& known);

/// The parts of a word between "_", "-" and blanks, in lower case.
std::vector<std::string> parts_of(const std::string& word);

/// "a, b and c" with the given last joint ("and", "or").
std::string joined(const std::vector<std::string>& words, const std::string& last_joint);

/// "a, b, c, d, e, …": the first of them.
std::string first_of(const std::vector<std::string>& words);

}  // namespace photic::scene
