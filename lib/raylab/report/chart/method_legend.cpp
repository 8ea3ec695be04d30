#include "raylab/report/chart/method_legend.h"

#include "raylab/report/chart/tradeoff_panels.h"
#include "raylab/report/experiment.h"

#include <algorithm>

namespace raylab {

namespace {

constexpr double legend_row = 22;
const SketchText legend_text{.size = 13};

}  // namespace

MethodLegend::MethodLegend(const Experiment& experiment, double width) {
    for (const auto& name : methods_of(experiment)) {
        entries_.push_back({name, style_of(experiment, name)});
        column_ = std::max(column_, label_width(name, legend_text.size) + 40);
    }
    columns_ = std::clamp<std::size_t>(static_cast<std::size_t>(width / column_), 1, entries_.size());
}

double MethodLegend::height() const {
    return legend_row * static_cast<double>((entries_.size() + columns_ - 1) / columns_);
}

void MethodLegend::draw(Sketch& sketch, double left, double top) const {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const double x = left + column_ * static_cast<double>(i % columns_);
        const double y = top + legend_row * (static_cast<double>(i / columns_) + 0.5);
        sketch.marker(x + 7, y, 5, entries_[i].look);
        sketch.text(x + 20, y, entries_[i].name, legend_text);
    }
}

}  // namespace raylab
