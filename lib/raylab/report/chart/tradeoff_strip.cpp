#include "raylab/report/chart/tradeoff_strip.h"

#include "raylab/report/chart/label_layout.h"
#include "raylab/report/experiment.h"
#include "raylab/report/provenance.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

constexpr double row_height = 24, note_height = 20, padding = 10, font = 14, note_font = 12.5;

bool any_without_errors(const Tradeoffs& tradeoffs) {
    return std::ranges::any_of(tradeoffs.panels, [](const TradeoffPanel& panel) {
        return std::ranges::find(panel.dots, Dot::Kind::no_error_seen, &Dot::kind) != panel.dots.end();
    });
}

std::string sizes_note(const std::vector<std::string>& numbers) {
    std::string note = "Size: ";
    for (std::size_t i = 0; i < numbers.size(); ++i) note += (i > 0 ? " < " : "") + numbers[i];
    return note + ".";
}

std::vector<std::string> notes_of(const Tradeoffs& tradeoffs) {
    std::vector<std::string> notes;
    if (tradeoffs.numbers.size() > 1) notes.push_back(sizes_note(tradeoffs.numbers));
    if (any_without_errors(tradeoffs))
        notes.push_back("Hollow, with an arrow: no error seen in N queries, drawn at the 95 % bound 3/N.");
    notes.push_back("Grey steps and bold names: the Pareto front.");
    notes.push_back("Medians of the repeats, bars: their quartiles.");
    notes.push_back(processor_name() + ".");
    for (const auto& one : tradeoffs.left_out) notes.push_back("Not drawn, since no number: " + one + ".");
    return notes;
}

// Puts as many sentences on a line as fit.
std::vector<std::string> lines_of(const std::vector<std::string>& sentences, double width) {
    std::vector<std::string> lines;
    for (const auto& sentence : sentences) {
        const bool fits = !lines.empty() && text_width(lines.back() + "   " + sentence, note_font) < width;
        if (fits)
            lines.back() += "   " + sentence;
        else
            lines.push_back(sentence);
    }
    return lines;
}

}  // namespace

Strip::Strip(const Experiment& experiment, const Tradeoffs& tradeoffs, double width, std::size_t max_names)
    : notes_(lines_of(notes_of(tradeoffs), width)) {
    if (tradeoffs.panels.size() == 1 && tradeoffs.panels.front().dots.size() <= max_names) return;
    for (const auto& name : methods_of(experiment)) {
        methods_.push_back({name, style_of(experiment, name)});
        column_ = std::max(column_, text_width(name, font) + 46);
    }
    columns_ = std::clamp<std::size_t>(static_cast<std::size_t>(width / column_), 1, methods_.size());
}

double Strip::height() const {
    const auto rows = (methods_.size() + columns_ - 1) / columns_;
    return 2 * padding + row_height * static_cast<double>(rows) + note_height * static_cast<double>(notes_.size());
}

std::string Strip::script(const Canvas& canvas, double left) const {
    std::string script;
    double y = padding + note_height * (static_cast<double>(notes_.size()) - 0.5);
    for (const auto& note : notes_) {
        script += text_at(canvas, left, y, note, {.size = note_font, .color = quiet});
        y -= note_height;
    }
    const double first_row = height() - padding - row_height / 2;
    for (std::size_t i = 0; i < methods_.size(); ++i) {
        const double x = left + column_ * static_cast<double>(i % columns_);
        const double row_y = first_row - row_height * static_cast<double>(i / columns_);
        script += marker_at(canvas, x + 8, row_y, methods_[i].look.filled, 1.5, methods_[i].look.color) +
                  text_at(canvas, x + 24, row_y, methods_[i].text, {.size = font});
    }
    return script;
}

}  // namespace raylab
