#include "raylab/report/chart/axis.h"

#include "raylab/base/number_text.h"
#include "raylab/report/chart/label_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

constexpr double few_decades = 2.9;  // axes that span fewer decades are marked at 2 and 5 too

std::vector<Tick> decade_ticks(double low, double high) {
    const double decades = std::log10(high) - std::log10(low);
    // More than eight marks crowd a small panel.
    const int step = std::max(1, static_cast<int>(std::ceil(decades / 8)));
    std::vector<Tick> ticks;
    for (int power = static_cast<int>(std::floor(std::log10(low))); power <= std::log10(high); ++power) {
        if (power % step != 0) continue;
        for (const int digit : {1, 2, 5}) {
            const double at = digit * std::pow(10.0, power);
            if (at >= low && at <= high && (digit == 1 || decades < few_decades)) ticks.push_back({at, power_text(at)});
        }
    }
    return ticks;
}

std::vector<Tick> round_ticks(double low, double high) {
    const double rough = (high - low) / 6;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double step = power * (rough / power < 1.5 ? 1 : rough / power < 3.5 ? 2 : rough / power < 7.5 ? 5 : 10);
    std::vector<Tick> ticks;
    for (double count = std::ceil(low / step); count * step <= high; ++count)
        ticks.push_back({count * step, fmt::format("{:.6g}", count * step + 0.0)});  // + 0.0 avoids "-0"
    return ticks;
}

}  // namespace

double AxisScale::share(double value) const {
    if (kind == AxisKind::linear) return (value - low) / (high - low);
    return (std::log(value) - std::log(low)) / (std::log(high) - std::log(low));
}

double AxisScale::value(double share) const {
    if (kind == AxisKind::linear) return low + share * (high - low);
    return std::exp(std::lerp(std::log(low), std::log(high), share));
}

std::vector<Tick> marks_with_room(const AxisScale& scale, double length, double font_size) {
    auto ticks = scale.ticks;
    const auto crowded = [&] {
        for (std::size_t i = 1; i < ticks.size(); ++i) {
            const double room = length * (scale.share(ticks[i].at) - scale.share(ticks[i - 1].at));
            const double wanted = label_width(ticks[i - 1].text, font_size) + label_width(ticks[i].text, font_size);
            if (room < wanted / 2 + font_size / 2) return true;
        }
        return false;
    };
    const auto is_power = [](const Tick& tick) {
        const double power = std::log10(tick.at);
        return std::abs(power - std::round(power)) < 1e-6;
    };
    if (crowded() && scale.kind == AxisKind::logarithmic && std::ranges::count_if(ticks, is_power) > 1)
        std::erase_if(ticks, [&](const Tick& tick) { return !is_power(tick); });
    while (ticks.size() > 2 && crowded())
        for (std::size_t i = 1; i < ticks.size(); ++i) ticks.erase(ticks.begin() + static_cast<std::ptrdiff_t>(i));
    return ticks;
}

AxisScale axis_for(const std::vector<double>& values, AxisKind kind, double margin) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : values) {
        if (!std::isfinite(value) || (kind == AxisKind::logarithmic && value <= 0)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (low > high) low = high = 1;
    if (kind == AxisKind::logarithmic) {
        const double smallest = std::log10(2.0);  // even a single value gets an axis around it
        const double length = std::max(std::log10(high) - std::log10(low), smallest) / (1 - 2 * margin);
        const double middle = std::sqrt(low) * std::sqrt(high);
        // Doubles end at 1e308, so an axis over all of them has no margin.
        low = std::max(middle * std::pow(10.0, -length / 2), 1e-305);
        high = std::min(middle * std::pow(10.0, length / 2), 1e305);
        auto ticks = decade_ticks(low, high);
        // A single number says nothing of the axis's scale.
        if (ticks.size() < 2) ticks = round_ticks(low, high);
        return {kind, low, high, ticks};
    }
    const double length = (high > low ? high - low : std::max(std::abs(high), 1.0)) / (1 - 2 * margin);
    const double middle = low + (high - low) / 2;
    low = middle - length / 2;
    high = middle + length / 2;
    return {kind, low, high, round_ticks(low, high)};
}

std::string power_text(double value) {
    if (value >= 0.00999 && value < 9'999) {
        const auto text = fmt::format("{:.6g}", value);
        return value < 1000 ? text : text.substr(0, 1) + " " + text.substr(1);
    }
    const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
    const int digit = static_cast<int>(std::lround(value / std::pow(10.0, power)));
    return (digit == 1 ? "" : std::to_string(digit) + "·") + "10" + superscript(power);
}

}  // namespace raylab
