#pragma once

#include "raylab/accelerator/light_buffer/light_through_list.h"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace raylab::grading::light_list {

inline constexpr std::size_t most_entries = 8;
inline constexpr std::size_t inputs =
    3 + 2 * most_entries;  // the point's depth, the filled depth, how many, the entries

/// What the function asks, in its order: the number of an entry whose test it asks for, or that there is none such.
inline constexpr std::size_t most_asked = 24;
inline constexpr std::size_t outputs = 2 + most_asked;  // the share; how often it asked; what it asked first
inline constexpr int no_entry = 99;

struct Entry {
    double begin, through;
};

struct Arguments {
    double depth, filled;
    std::vector<Entry> entries;

    int count() const { return static_cast<int>(entries.size()); }
    const Entry* entry(int i) const { return i >= 0 && i < count() ? &entries[static_cast<std::size_t>(i)] : nullptr; }
};

inline Arguments arguments(std::span<const double> in) {
    Arguments given{in[0], in[1], {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(in[2]); ++i)
        given.entries.push_back({in[3 + 2 * i], in[4 + 2 * i]});
    return given;
}

inline std::vector<double> as_input(const Arguments& given) {
    std::vector<double> in{given.depth, given.filled, static_cast<double>(given.entries.size())};
    for (const auto& [begin, through] : given.entries) in.insert(in.end(), {begin, through});
    in.resize(inputs);
    return in;
}

/// Answers one case with a function of the slot's type. What is no entry begins nowhere and hides nothing.
inline void answer(decltype(&light_through_list) function, std::span<const double> in, std::span<double> out) {
    const Arguments given = arguments(in);
    std::vector<int> asked;
    const double share = function({.depth = given.depth,
                                   .filled = given.filled,
                                   .entries = given.count(),
                                   .begin =
                                       [&](int i) {
                                           if (const Entry* entry = given.entry(i)) return entry->begin;
                                           asked.push_back(no_entry);
                                           return std::numeric_limits<double>::infinity();
                                       },
                                   .through =
                                       [&](int i) {
                                           const Entry* entry = given.entry(i);
                                           asked.push_back(entry ? i : no_entry);
                                           return entry ? entry->through : 1;
                                       }});
    std::ranges::fill(out, -1);
    out[0] = share;
    out[1] = static_cast<double>(asked.size());
    for (std::size_t i = 0; i < std::min(asked.size(), most_asked); ++i) out[2 + i] = asked[i];
}

}  // namespace raylab::grading::light_list
