#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/chart/sketch.h"

#include <string>
#include <vector>

namespace raylab {

/// The words above a chart: the answer as its title, and the question below it.
class ChartWords {
public:
    ChartWords() = default;
    ChartWords(const Experiment& experiment, double width);

    double height() const;
    void draw(Sketch& sketch, double left) const;

private:
    std::vector<std::string> answer_, question_;  // lines
};

/// The sentences below a chart that explain its signs, and the machine on which it was measured.
class ChartNotes {
public:
    ChartNotes(std::vector<std::string> sentences, double width);

    double height() const;
    void draw(Sketch& sketch, double left, double top) const;

private:
    std::vector<std::string> lines_;
};

}  // namespace raylab
