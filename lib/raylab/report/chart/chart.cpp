#include "raylab/report/chart/chart.h"

#include "raylab/base/file.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/chart/curve_chart.h"
#include "raylab/report/chart/curve_data.h"
#include "raylab/report/chart/decision_chart.h"
#include "raylab/report/chart/gnuplot.h"
#include "raylab/report/chart/tradeoff_chart.h"
#include "raylab/report/experiment.h"
#include "raylab/report/json_text.h"

#include <nlohmann/json.hpp>

namespace raylab {

namespace fs = std::filesystem;

std::vector<fs::path> write_chart(const Experiment& experiment, const fs::path& folder, const std::string& name) {
    write_file(folder / (name + ".csv"), to_csv(experiment));
    write_file(folder / (name + ".json"), json_text(to_json(experiment)));
    const auto drawing = errors_are_shares(experiment) ? decision_chart(experiment) : tradeoff_chart(experiment);
    write_svg(drawing, folder / (name + ".svg"));
    write_image(to_image(drawing), folder / (name + ".png"));
    return {folder / (name + ".csv"), folder / (name + ".json"), folder / (name + ".svg"), folder / (name + ".png")};
}

std::vector<fs::path> write_chart(const CurveChart& chart, const fs::path& folder, const std::string& name) {
    write_file(folder / (name + ".csv"), to_csv(chart));
    write_file(folder / (name + ".json"), json_text(to_json(chart)));
    std::vector<fs::path> files = {folder / (name + ".csv"), folder / (name + ".json")};
    for (auto& file : draw(curve_drawing(chart), folder, name)) files.push_back(std::move(file));
    return files;
}

}  // namespace raylab
