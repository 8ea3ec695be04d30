#include "pictures.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/report/structure/structure_drawing.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <fmt/format.h>

namespace raylab::grids {

namespace {

const Ray ray_over_the_table{{-4.4f, 0.62f, 2.3f}, {1, -0.06f, -0.45f}};

}  // namespace

Image seen(const Scene& scene, const ChapterRun& run) {
    const auto accelerator = make_accelerator("grid", scene);
    const ImageSize size = run.sized(scene.image, ImageSize{320, 240});
    return whitted_picture(scene, *accelerator, camera_frame(scene.camera, size, scene.source), {}, chapter_rays(run));
}

PlaneDrawing ray_through_cells(const Scene& scene) {
    const auto grid = make_accelerator("grid", scene);
    PlaneDrawing drawing =
        draw_ray_through(scene, *grid, ray_over_the_table, {.title = "", .along = 1, .width = 600, .height = 450});
    drawing.notes.clear();
    return drawing;
}

std::vector<CostMap> cost_maps(const Scene& scene, Cost cost, const ChapterRun& run) {
    const CameraFrame frame =
        camera_frame(scene.camera, run.sized(ImageSize{480, 360}, ImageSize{160, 120}), scene.source);
    std::vector<CostMap> maps;
    for (const int density : densities)
        maps.push_back(cost_map(*make_accelerator(fmt::format("grid:{}", density), scene), frame, cost, run.threads));
    return maps;
}

Image heated(const std::vector<CostMap>& maps, std::size_t which, Cost cost) {
    return heat_map(maps[which], fmt::format("{}, density {}", words(cost), densities[which]), common_top(maps));
}

}  // namespace raylab::grids
