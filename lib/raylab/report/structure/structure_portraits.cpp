#include "raylab/report/structure/structure_portraits.h"

#include "raylab/image/draw.h"
#include "raylab/report/page/html.h"
#include "raylab/report/structure/structure_diagram.h"
#include "raylab/report/structure/structure_heat_map.h"

namespace raylab {

void tell_portraits(const ChapterRun& run, Page& page, const std::vector<StructureMethod>& methods, const Scene& scene,
                    const Ray& ray, const StructureView& view) {
    std::vector<Page::Figure> ways, trees;
    for (const StructureMethod& method : methods) {
        const auto structure = method.make(scene);
        const std::string file = "_of_" + anchor_name(method.name) + ".svg";
        StructureView titled = view;
        titled.title = method.name;
        write_svg(draw_ray_through(scene, *structure, ray, titled), run.out / ("way" + file));
        ways.push_back({"way" + file, method.name + ": where a ray goes."});
        const auto visits = structure->visits(ray);
        write_diagram(structure_diagram(structure->outline(), method.name, {.largest = 26, .visits = visits}),
                      run.out / ("tree" + file));
        trees.push_back({"tree" + file, method.name + ": its upper nodes; numbers and thick lines: the same ray."});
    }
    page.figures(ways);
    for (const Page::Figure& tree : trees) page.figures({tree});  // they are too wide to stand side by side
}

Image tests_of_each(const ChapterRun& run, const std::vector<StructureMethod>& methods, const Scene& scene) {
    const int side = run.sized(300, 120);
    const CameraFrame frame = camera_frame(scene.camera, {side, side}, scene.source);
    std::vector<CostMap> maps;
    for (const StructureMethod& method : methods)
        maps.push_back(cost_map(*method.make(scene), frame, Cost::primitive_tests, run.threads));
    std::vector<Image> pictures;
    for (std::size_t i = 0; i < maps.size(); ++i)
        pictures.push_back(heat_map(maps[i], "tests a pixel, " + methods[i].name, common_top(maps)));
    return side_by_side(pictures);
}

}  // namespace raylab
