#include "lead_home.h"

#include "verdict_text.h"
#include "way_home.h"

#include "raylab/base/print.h"
#include "raylab/image/difference_picture.h"
#include "raylab/image/draw.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/json_text.h"
#include "raylab/report/ray_tree/ray_tree_difference_report.h"
#include "raylab/report/ray_tree/ray_tree_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab {

namespace {

std::string lines_below(std::string text, const std::string& indent) {
    for (auto at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) text.insert(at + 1, indent);
    return text;
}

void write_pictures(const grading::WayHome& way, const std::filesystem::path& file) {
    const Image yours = enlarged(way.yours, 4), reference = enlarged(way.reference, 4);
    write_image(difference_picture(yours, reference, compare(yours, reference)), file);
}

void write_trees(const grading::WayHome::Pixel& pixel, const std::filesystem::path& folder) {
    for (const auto* name : {"ray_trees.svg", "ray_trees.png"})
        write_diagram(difference_diagram({pixel.yours, "yours"}, {pixel.reference, "the reference"}, pixel.difference),
                      folder / name);
    write_json(json_text(to_json(pixel.yours)), folder / "ray_tree_yours.json");
    write_json(json_text(to_json(pixel.reference)), folder / "ray_tree_reference.json");
}

}  // namespace

std::string lead_home(const grading::Exercise& exercise, const grading::Workplace& workplace,
                      const StagedFolder& folder) {
    const auto [answers, way] = grading::find_way_home(exercise, workplace);
    if (!way) return fmt::format("  No traced picture: {}", to_text(exercise, answers));
    const auto* const picture = "traced.png";
    write_pictures(*way, folder.path / picture);
    const auto words = fmt::format("  A scene traced with your function, with the reference, and where they differ: "
                                   "{}\n",
                                   (folder.named / picture).string());
    if (!way->worst) return words + "    Nothing differs: this scene does not ask what the case above asks.\n";
    const auto& pixel = *way->worst;
    write_trees(pixel, folder.path);
    return words +
           fmt::format("    {} is ({}, {}): {}\n    Both ray trees of that pixel, that node in red: {}\n",
                       way->pictures_differ ? "Its worst pixel"
                                            : "The pictures are the same, the rays are not: the first such pixel",
                       pixel.x, pixel.y,
                       pixel.difference ? lines_below(to_string(*pixel.difference), "    ") : "its trees are the same",
                       (folder.named / "ray_trees.svg").string());
}

}  // namespace raylab
