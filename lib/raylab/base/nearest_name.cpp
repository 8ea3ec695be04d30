#include "raylab/base/nearest_name.h"

#include "raylab/base/small_letters.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace raylab {

namespace {

constexpr std::size_t longest_compared = 64;  // because the work grows with the product of both lengths

std::string in_quotes(std::string_view name) { return '"' + std::string(name) + '"'; }

}  // namespace

// Optimal string alignment: the rows of Wagner and Fischer (1974), with swaps of neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last = std::exchange(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string with_suggestion(std::string_view name, std::span<const std::string> known) {
    if (name.size() > longest_compared) return in_quotes(name.substr(0, longest_compared)) + "...";
    const auto distance = [&](const std::string& other) {
        return edit_distance(in_small_letters(name), in_small_letters(other));
    };
    const auto nearest = std::ranges::min_element(known, {}, distance);
    // With a third of the letters wrong it is still a typing error; with more it is another word.
    const std::size_t max_slips = std::max<std::size_t>(1, name.size() / 3);
    if (nearest == known.end() || distance(*nearest) > max_slips) return in_quotes(name);
    return in_quotes(name) + " (did you mean " + in_quotes(*nearest) + "?)";
}

}  // namespace raylab
