#include "raylab/report/chart.h"

#include "raylab/base/file.h"
#include "raylab/report/experiment.h"
#include "raylab/report/curve_data.h"
#include "raylab/report/json_text.h"

#include <nlohmann/json.hpp>

namespace raylab {

namespace fs = std::filesystem;

std::vector<fs::path> write_chart(const Experiment& experiment, const fs::path& folder, const std::string& name) {
    write_file(folder / (name + ".csv"), to_csv(experiment));
    write_file(folder / (name + ".json"), json_text(to_json(experiment)));
    return {folder / (name + ".csv"), folder / (name + ".json")};
}

std::vector<fs::path> write_chart(const CurveChart& chart, const fs::path& folder, const std::string& name) {
    write_file(folder / (name + ".csv"), to_csv(chart));
    write_file(folder / (name + ".json"), json_text(to_json(chart)));
    return {folder / (name + ".csv"), folder / (name + ".json")};
}

}  // namespace raylab
