#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/chart/gnuplot_canvas.h"
#include "raylab/report/chart/tradeoff_panels.h"

#include <string>
#include <vector>

namespace raylab {

/// The legend below a chart: it tells methods apart where their names do not stand beside them, and explains the signs
/// that are used.
class Strip {
public:
    Strip(const Experiment& experiment, const Tradeoffs& tradeoffs, double width, std::size_t max_names);

    double height() const;
    std::string script(const Canvas& canvas, double left) const;

private:
    struct Entry {
        std::string text;
        MarkerStyle look;
    };
    std::vector<Entry> methods_;
    std::vector<std::string> notes_;  // lines
    double column_ = 0;               // width of a column
    std::size_t columns_ = 1;
};

}  // namespace raylab
