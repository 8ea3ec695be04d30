#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/chart/sketch.h"

#include <string>
#include <vector>

namespace raylab {

/// The marks of an experiment's methods with their names, in columns.
class MethodLegend {
public:
    MethodLegend(const Experiment& experiment, double width);

    double height() const;
    void draw(Sketch& sketch, double left, double top) const;

private:
    struct Entry {
        std::string name;
        MarkerStyle look;
    };
    std::vector<Entry> entries_;
    double column_ = 1;  // its width
    std::size_t columns_ = 1;
};

}  // namespace raylab
