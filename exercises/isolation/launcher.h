#pragma once

#include <array>

// What the launcher and those who start it have to agree on: its words are the level, the kind of work, the
// processor's seconds, the scratch folder, the program and the program's own words.

namespace raylab::grading {

inline constexpr std::array<const char*, 5> words_for_work{"compile", "answer", "load-and-answer", "draw",
                                                           "render"};  // as Work counts
inline constexpr int exit_not_isolated = 125;

}  // namespace raylab::grading
