#include "raylab/report/table.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace raylab {

namespace {

using Row = std::vector<std::string>;

constexpr std::size_t gap = 2;  // blanks before each column

std::vector<std::size_t> widths_of(const Row& header, const std::vector<Row>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& cell : header) widths.push_back(length_shown(cell));
    for (const auto& row : rows) {
        assert(row.size() == header.size());
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], length_shown(row[i]));
    }
    return widths;
}

/// Takes what is too much from the widest columns.
std::vector<std::size_t> narrowed(std::vector<std::size_t> widths) {
    constexpr std::size_t narrowest = 8;
    const auto total = [&] { return std::accumulate(widths.begin(), widths.end(), gap * widths.size()); };
    while (total() > terminal_width) {
        auto& widest = *std::ranges::max_element(widths);
        if (widest <= narrowest) break;
        --widest;
    }
    return widths;
}

/// A row as one line or, where a cell is wrapped, as several.
std::string lines_of(const Row& row, const std::vector<std::size_t>& widths) {
    std::vector<std::vector<std::string>> cells;
    std::size_t height = 1;
    for (std::size_t i = 0; i < row.size(); ++i) {
        cells.push_back(length_shown(row[i]) > widths[i] ? wrapped(row[i], widths[i]) : std::vector{row[i]});
        height = std::max(height, cells.back().size());
    }
    std::string text;
    for (std::size_t line = 0; line < height; ++line) {
        std::string shown;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto part = line < cells[i].size() ? cells[i][line] : "";
            const auto missing = std::max(widths[i], length_shown(part)) - length_shown(part);
            shown += std::string(gap, ' ') + part + std::string(missing, ' ');
        }
        text += shown.substr(0, shown.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

}  // namespace

std::string text_table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows) {
    const auto widths = narrowed(widths_of(header, rows));
    std::vector<std::string> rule;
    for (const auto width : widths) rule.push_back(std::string(width, '-'));
    auto text = lines_of(header, widths) + lines_of(rule, widths);
    for (const auto& row : rows) text += lines_of(row, widths);
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

}  // namespace raylab
