#include "raylab/report/chart/chart_words.h"

#include "raylab/report/experiment.h"
#include "raylab/report/finding.h"
#include "raylab/report/provenance.h"

#include <fmt/format.h>

namespace raylab {

namespace {

const SketchText answer_text{.size = 17, .weight = SketchText::Weight::bold};
const SketchText question_text{.size = 13}, note_text{.size = 13};
constexpr double answer_line = 23, question_line = 18, note_line = 17, top = 14;

std::string about(const Experiment& experiment) {
    const auto plural = [](std::size_t count, const std::string& what) {
        return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
    };
    return experiment.title + " " + plural(methods_of(experiment).size(), "method") + ", " +
           plural(workloads_of(experiment).size(), "workload") + ".";
}

double times(double line, const std::vector<std::string>& lines) { return line * static_cast<double>(lines.size()); }

}  // namespace

ChartWords::ChartWords(const Experiment& experiment, double width)
    : answer_(lines_in(answer_of(experiment), width, answer_text)),
      question_(lines_in(about(experiment), width, question_text)) {}

double ChartWords::height() const {
    return top + times(answer_line, answer_) + 4 + times(question_line, question_) + 8;
}

void ChartWords::draw(Sketch& sketch, double left) const {
    double y = top + answer_line / 2;
    for (const auto& line : answer_) sketch.text(left, y, line, answer_text), y += answer_line;
    y += 2;
    auto quiet = question_text;
    quiet.color = quiet_color;
    for (const auto& line : question_) sketch.text(left, y, line, quiet), y += question_line;
}

ChartNotes::ChartNotes(std::vector<std::string> sentences, double width) {
    sentences.push_back(processor_name() + ".");
    std::string text;
    for (const auto& sentence : sentences) text += sentence + " ";
    lines_ = lines_in(text, width, note_text);
}

double ChartNotes::height() const { return times(note_line, lines_) + 6; }

void ChartNotes::draw(Sketch& sketch, double left, double top) const {
    auto quiet = note_text;
    quiet.color = quiet_color;
    for (std::size_t i = 0; i < lines_.size(); ++i)
        sketch.text(left, top + note_line * (static_cast<double>(i) + 0.5), lines_[i], quiet);
}

}  // namespace raylab
