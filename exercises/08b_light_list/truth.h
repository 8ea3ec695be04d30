#pragma once

#include "arguments.h"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <string>

// The truth: everything in the way is multiplied, from the point back to the light. And what a function asked is gone
// through again, test by test: whether its result could change anything, and whether it was its turn.

namespace raylab::grading::light_list {

inline bool is_behind_what_fills(const Arguments& given) { return given.depth > given.filled; }

/// The entries that begin before the point, or as deep as it: the first of the list.
inline int reached(const Arguments& given) {
    return static_cast<int>(
        std::ranges::count_if(given.entries, [&](const Entry& entry) { return entry.begin <= given.depth; }));
}

inline double truth(const Arguments& given) {
    if (is_behind_what_fills(given)) return 0;
    long double share = 1;
    for (int i = reached(given) - 1; i >= 0; --i) share *= given.entries[static_cast<std::size_t>(i)].through;
    return static_cast<double>(share);
}

/// A test that a right search does not make.
struct Wasted {
    enum class Why {
        twice,         // it was made before
        stranger,      // there is no such entry
        filled,        // the point is behind what fills the cell
        beyond,        // the entry begins deeper than the point
        dark,          // something opaque was found before
        out_of_order,  // one that begins nearer to the light was not tested yet
    } why;
    int asked;
};

inline std::vector<int> asked_of(std::span<const double> answer) {
    std::vector<int> all;
    for (std::size_t i = 0; i < most_asked && static_cast<double>(i) < answer[1]; ++i) {
        const double what = answer[2 + i];
        all.push_back(what >= 0 && what < static_cast<double>(most_entries) ? static_cast<int>(what) : no_entry);
    }
    return all;
}

inline std::optional<Wasted> first_wasted(const Arguments& given, const std::vector<int>& asked) {
    using enum Wasted::Why;
    std::set<int> before;
    bool is_dark = false;
    for (const int i : asked) {
        const Entry* entry = given.entry(i);
        if (!entry) return Wasted{stranger, i};
        if (!before.insert(i).second) return Wasted{twice, i};
        if (is_behind_what_fills(given)) return Wasted{filled, i};
        if (entry->begin > given.depth) return Wasted{beyond, i};
        if (is_dark) return Wasted{dark, i};
        if (i > 0 && !before.contains(i - 1)) return Wasted{out_of_order, i};
        is_dark = entry->through == 0;
    }
    return std::nullopt;
}

inline std::string in_words(const Wasted& wasted) {
    const std::string what = fmt::format("entry {}", wasted.asked);
    switch (wasted.why) {
        case Wasted::Why::twice:
            return what + " was tested before";
        case Wasted::Why::stranger:
            return "an entry was asked for that there is not";
        case Wasted::Why::filled:
            return what + " was tested, though the point is behind what fills the cell";
        case Wasted::Why::beyond:
            return what + " was tested, which begins deeper than the point";
        case Wasted::Why::dark:
            return what + " was tested, though nothing was left of the light";
        default:
            return fmt::format("{} was tested before entry {}", what, wasted.asked - 1);
    }
}

}  // namespace raylab::grading::light_list
