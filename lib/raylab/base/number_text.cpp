#include "raylab/base/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace raylab {

namespace {

// "5.6·10⁷"
std::string with_power_of_ten(double value) {
    const auto text = fmt::format("{:.2e}", value);
    const auto e = text.find('e');
    auto digits = text.substr(0, e);
    while (digits.back() == '0') digits.pop_back();
    if (digits.back() == '.') digits.pop_back();
    return digits + "·10" + superscript(std::stoi(text.substr(e + 1)));
}

}  // namespace

std::string superscript(int number) {
    constexpr std::array digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = number < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(number))) text += digits[static_cast<std::size_t>(digit - '0')];
    return text;
}

std::string count_text(std::size_t count) {
    auto digits = std::to_string(count);
    for (auto at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, 1, ' ');
    return digits;
}

std::string number_text(double value) {
    if (!std::isfinite(value)) return std::isnan(value) ? "not a number" : value > 0 ? "∞" : "−∞";
    const double size = std::abs(value);
    if (size == 0) return "0";
    if (size < 9.995e-4 || size >= 999'999.5) return with_power_of_ten(value);
    if (size < 999.5) return fmt::format("{:.3g}", value);
    return (value < 0 ? "-" : "") + count_text(static_cast<std::size_t>(std::llround(size)));
}

std::string share_text(double share) {
    if (!std::isfinite(share)) return number_text(share);
    if (share == 0) return "0";
    if (share < 9.95e-5) return fmt::format("{:.2g} ppm", 1e6 * share);
    if (100 * share >= 99.5 && share < 1) return fmt::format("{:.1f} %", 100 * std::min(share, 0.999));
    return share > 0.0995 ? fmt::format("{:.0f} %", 100 * share) : fmt::format("{:.2g} %", 100 * share);
}

std::string ratio_text(double ratio) {
    if (ratio < 1.995) return fmt::format("{:.2f} ×", ratio);
    if (ratio < 9.95) return fmt::format("{:.1f} ×", ratio);
    const double step = std::pow(10.0, std::floor(std::log10(ratio)) - 1);  // of the second digit
    return number_text(std::round(ratio / step) * step) + " ×";
}

std::string duration_text(double nanoseconds) {
    constexpr std::array<std::pair<double, const char*>, 4> units = {
        {{1e9, " s"}, {1e6, " ms"}, {1e3, " µs"}, {1, " ns"}}};
    for (const auto& [size, name] : units)
        if (nanoseconds >= size) return number_text(nanoseconds / size) + name;
    return number_text(nanoseconds) + " ns";
}

}  // namespace raylab
