#include "pictures.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/draw.h"
#include "raylab/report/structure/structure_drawing.h"
#include "raylab/report/structure/structure_heat_map.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <fmt/format.h>

namespace raylab::grids {

namespace {

constexpr ImageSize small{300, 225};

Image heated(const Scene& scene, Cost cost, const ChapterRun& run) {
    std::vector<CostMap> maps;
    const std::vector<double> densities{1, 8, 64};
    const CameraFrame frame = camera_frame(scene.camera, run.sized(small, ImageSize{160, 120}), scene.source);
    for (const double density : densities)
        maps.push_back(cost_map(*make_accelerator(fmt::format("grid:{:g}", density), scene), frame, cost, run.threads));
    std::vector<Image> images;
    for (std::size_t i = 0; i < maps.size(); ++i)
        images.push_back(
            heat_map(maps[i], fmt::format("{}, density {:g}", words(cost), densities[i]), common_top(maps)));
    return side_by_side(images);
}

}  // namespace

Image seen(const Scene& scene, const ChapterRun& run) {
    const auto accelerator = make_accelerator("grid", scene);
    const ImageSize size = run.sized(scene.image, small);
    return whitted_picture(
        scene, *accelerator, camera_frame(scene.camera, size, scene.source), {},
        {.samples = {SamplePattern::jittered, 2, run.seed}, .threads = run.threads, .label = "rays"});
}

Image ray_through_cells(const Scene& scene) {
    const auto grid = make_accelerator("grid", scene);
    return to_image(draw_ray_through(scene, *grid, ray_over_the_table,
                                     {.title = "from above: the cells of one ray, in order", .along = 1}));
}

Image tests_a_pixel(const Scene& scene, const ChapterRun& run) { return heated(scene, Cost::primitive_tests, run); }
Image cells_a_pixel(const Scene& scene, const ChapterRun& run) { return heated(scene, Cost::steps, run); }

}  // namespace raylab::grids
