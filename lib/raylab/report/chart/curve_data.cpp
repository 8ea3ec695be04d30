#include "raylab/report/chart/curve_data.h"

#include "raylab/report/table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cassert>

namespace raylab {

std::string to_csv(const CurveChart& chart) {
    std::string text = csv_record({"curve", chart.x_label, chart.y_label, "low", "high"});
    for (const auto& curve : chart.curves) {
        assert(curve.x.size() == curve.y.size() && curve.low.size() == curve.high.size());
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            const bool barred = i < curve.low.size();
            text += csv_record({curve.name, fmt::format("{}", curve.x[i]), fmt::format("{}", curve.y[i]),
                                barred ? fmt::format("{}", curve.low[i]) : "",
                                barred ? fmt::format("{}", curve.high[i]) : ""});
        }
    }
    return text;
}

nlohmann::ordered_json to_json(const CurveChart& chart) {
    auto curves = nlohmann::ordered_json::array();
    for (const auto& curve : chart.curves)
        curves.push_back(
            {{"name", curve.name}, {"x", curve.x}, {"y", curve.y}, {"low", curve.low}, {"high", curve.high}});
    return {{"title", chart.title},
            {"x_label", chart.x_label},
            {"y_label", chart.y_label},
            {"x_axis", chart.x_axis == AxisKind::linear ? "linear" : "logarithmic"},
            {"y_axis", chart.y_axis == AxisKind::linear ? "linear" : "logarithmic"},
            {"curves", curves}};
}

}  // namespace raylab
