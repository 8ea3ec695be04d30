#include "raylab/report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace raylab {

std::size_t length_shown(const std::string& text) {
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
    return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, continues));
}

std::string text_table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& cell : header) widths.push_back(length_shown(cell));
    for (const auto& row : rows) {
        assert(row.size() == header.size());
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], length_shown(row[i]));
    }
    const auto line = [&](const std::vector<std::string>& row) {
        std::string text;
        for (std::size_t i = 0; i < row.size(); ++i)
            text += "  " + row[i] + (i + 1 < row.size() ? std::string(widths[i] - length_shown(row[i]), ' ') : "");
        return text + "\n";
    };
    std::string text = line(header);
    std::vector<std::string> rule;
    for (const auto width : widths) rule.push_back(std::string(width, '-'));
    text += line(rule);
    for (const auto& row : rows) text += line(row);
    return text;
}

std::string csv_record(const std::vector<std::string>& cells) {
    std::string record;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i > 0) record += ",";
        if (cells[i].find_first_of(",\"\r\n") == std::string::npos) {
            record += cells[i];
            continue;
        }
        record += '"';
        for (const char c : cells[i]) record += c == '"' ? std::string("\"\"") : std::string(1, c);
        record += '"';
    }
    return record + "\r\n";
}

std::string number_text(double value) {
    if (!std::isfinite(value)) return std::isnan(value) ? "not a number" : value > 0 ? "∞" : "−∞";
    const double size = std::abs(value);
    if (size == 0) return "0";
    if (size < 9.995e-4 || size >= 999'999.5) return fmt::format("{:.2e}", value);
    if (size < 999.5) return fmt::format("{:.3g}", value);
    const auto whole = fmt::format("{:.0f}", value);
    return fmt::format("{} {}", whole.substr(0, whole.size() - 3), whole.substr(whole.size() - 3));
}

std::string duration_text(double nanoseconds) {
    constexpr std::array<std::pair<double, const char*>, 4> units = {
        {{1e9, " s"}, {1e6, " ms"}, {1e3, " µs"}, {1, " ns"}}};
    for (const auto& [size, name] : units)
        if (nanoseconds >= size) return number_text(nanoseconds / size) + name;
    return number_text(nanoseconds) + " ns";
}

}  // namespace raylab
