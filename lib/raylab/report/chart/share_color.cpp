#include "raylab/report/chart/share_color.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab {

namespace {

constexpr const char* none = "#e4f2ea";  // green: nothing is wrong
// Below 1 ppm, then one for each decade: 10 ppm, 100 ppm, 0.1 %, 1 %, 10 %, 100 %.
constexpr std::array decades = {"#fff6e5", "#feebcb", "#fdd9a3", "#fbb86a", "#f08a3c", "#cd4f1c", "#8f2508"};

// The relative luminance of a colour by WCAG 2.2.
double luminance_of(const std::string& color) {
    const auto linear = [&](std::size_t at) {
        const double value = std::stoi(color.substr(at, 2), nullptr, 16) / 255.0;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(1) + 0.7152 * linear(3) + 0.0722 * linear(5);
}

std::string background(double share) {
    if (share == 0) return none;
    if (!std::isfinite(share)) return decades.back();
    const double decade = std::floor(std::log10(1e6 * share) + 1e-9) + 1;
    return decades[static_cast<std::size_t>(std::clamp(decade, 0.0, 6.0))];
}

}  // namespace

double contrast_ratio(const std::string& a, const std::string& b) {
    const double one = luminance_of(a), other = luminance_of(b);
    return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

ShareColor share_color(double share) {
    const auto back = background(share);
    const bool black = contrast_ratio(back, "#000000") >= contrast_ratio(back, "#ffffff");
    return {back, black ? "#000000" : "#ffffff"};
}

}  // namespace raylab
