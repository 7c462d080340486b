// "Did you mean": what to propose for a word that is not known.
#pragma once

#include <string>
#include <vector>

namespace photic::scene {

/// "did you mean 'x'?" if one of the known words is close to `word`, else "<lead>: a, b, c".
std::string suggestion_for(const std::string& word, const std::vector<std::string>& known,
                           const std::string& lead);

/// "a, b and c" with the given last joint ("and", "or").
std::string joined(const std::vector<std::string>& words, const std::string& last_joint);

}  // namespace photic::scene
