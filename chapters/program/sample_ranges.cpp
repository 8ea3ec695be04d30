#include "sample_ranges.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace raylab {

std::string in_words(const SampleRanges& ranges) {
    std::string words;
    for (const auto& [first, last] : ranges) words += fmt::format("{}{}-{}", words.empty() ? "" : ",", first, last);
    return words;
}

SampleRanges sample_ranges(const std::string& words, const std::filesystem::path& file) {
    SampleRanges ranges;
    std::istringstream text(words);
    for (std::string part; std::getline(text, part, ',');) {
        const auto ends = two_integers(part, '-');
        if (!ends || (*ends)[0] > (*ends)[1] || (!ranges.empty() && (*ends)[0] < ranges.back().last))
            throw Error({file.string()}, "ranges of samples (\"0-16,32-48\")", '"' + words + '"');
        ranges.push_back({(*ends)[0], (*ends)[1]});
    }
    return ranges;
}

int next_stop(const SampleRange& all, int done) {
    constexpr int most_stops = 32;
    const int count = all.last - all.first;
    const int step = std::max(1, (count + most_stops - 1) / most_stops);
    return std::min(all.first + (done / step + 1) * step, all.last);
}

std::optional<SampleRanges> joined(SampleRanges a, const SampleRanges& b) {
    a.insert(a.end(), b.begin(), b.end());
    std::ranges::sort(a, {}, &SampleRange::first);
    SampleRanges all;
    for (const SampleRange& range : a) {
        if (!all.empty() && range.first < all.back().last) return std::nullopt;
        if (!all.empty() && range.first == all.back().last)
            all.back().last = range.last;
        else
            all.push_back(range);
    }
    return all;
}

}  // namespace raylab
