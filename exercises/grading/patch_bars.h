#pragma once

#include "flat_view.h"

#include "raylab/radiosity/radiosity_system.h"

#include <fmt/format.h>

#include <array>

namespace raylab::grading {

/// Lists of one colour for each patch, as they are right and as they were given.
struct PatchLists {
    std::string name;  // "radiosity"
    Radiosities right, yours;
};

/// The channel in which they differ most; what is no number differs most of all.
inline int worst_channel(const std::vector<PatchLists>& lists) {
    std::array<double, 3> most{};
    for (const auto& [name, right, yours] : lists)
        for (std::size_t i = 0; i < right.size(); ++i)
            for (int channel = 0; channel < 3; ++channel) {
                const double off = std::abs(right[i][channel] - yours[i][channel]);
                most[static_cast<std::size_t>(channel)] =
                    std::max(most[static_cast<std::size_t>(channel)], std::isfinite(off) ? off : 1e300);
            }
    return static_cast<int>(std::ranges::max_element(most) - most.begin());
}

/// Two bars for each patch, in the channel in which the lists differ most.
inline PlaneDrawing patch_bars(const std::vector<PatchLists>& lists, const std::string& title) {
    const int channel = worst_channel(lists);
    double highest = 0, width = 0;
    for (const auto& [name, right, yours] : lists) {
        for (const Color& color : right) highest = std::max(highest, color[channel]);
        width += static_cast<double>(right.size()) + 1;
    }
    highest = highest > 0 ? highest : 1;
    const double unit = 0.6 * width / highest;
    constexpr std::array names{"red", "green", "blue"};
    FlatView view({0, -0.12 * width, 0}, {width, 0.75 * width, 0}, title,
                  fmt::format("{} light of each patch, from patch 0 on", names[static_cast<std::size_t>(channel)]));
    double x = 0;
    for (const auto& [name, right, yours] : lists) {
        view.text({x + static_cast<double>(right.size()) / 2, -0.1 * width, 0}, case_ink::given, name);
        for (std::size_t i = 0; i < right.size(); ++i, x += 1) {
            const auto bar = [&](double from, double value, const char* color) {
                const double shown = std::isfinite(value) ? std::clamp(value, -0.1 * highest, 1.25 * highest) : 0;
                view.box({x + from, 0, 0}, {x + from + 0.35, unit * shown, 0}, {.line = color, .fill = color});
            };
            bar(0.1, right[i][channel], case_ink::right);
            bar(0.5, yours[i][channel], case_ink::yours);
            view.text({x + 0.5, -0.04 * width, 0}, case_ink::given, std::to_string(i));
        }
        x += 1;
    }
    return view.drawn();
}

}  // namespace raylab::grading
