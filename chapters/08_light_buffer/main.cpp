// Chapter 08: can shadows be cheaper?
//
// Half of all rays are shadow rays, and all shadow rays to one light end in one point. Haines and Greenberg (1986) put
// a cube of cells around it. The formulas are in README.md, numbered as here, which tells the same story.

#include "cases.h"
#include "light_methods.h"
#include "pictures.h"

#include "raylab/image/draw.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/scene/read_scene.h"

using namespace raylab;
using namespace raylab::lantern;

namespace {

// 1. The scene, and the cube about its light: README (1).
void tell_cube(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("All shadow rays end in one point");
    page.text("A light hangs in a cage of thin bars. Every shadow ray ends in it: seen from the light, a shadow ray "
              "is a *direction*, and what may stop it lies in that direction. A cube is put around the light, its "
              "faces are cut into cells, and each cell lists what is seen through it.");
    page.figures({{write_picture(shaded(scene, run), run.out, "lantern"), "Thin bars, wide shadows."}});
    page.figures(
        {{write_picture(seen_by_light(scene, run), run.out, "seen_by_light"),
          "What the light sees, on the six faces of the cube. It sees no shadow: what it does not see is in shadow."},
         {write_picture(cell_lists(scene, 32, run), run.out, "cells"), "How many primitives each cell lists."}});
}

// 2. One shadow ray: README (2) and (3).
void tell_cell(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("One cell, sorted by depth");
    page.text("A shadow ray is answered by its cell alone. Its list begins with what is nearest to the light, and "
              "ends for this shadow ray where the depth of its own starting point is reached: what is further away "
              "than that cannot be in between.");
    write_svg(draw_cell(scene), run.out / "one_cell.svg");
    page.figures({{write_picture(to_image(draw_cell(scene)), run.out, "one_cell"),
                   "From above: the light in its cage, one face of the cube (blue), and one of its 8 x 8 cells with a "
                   "shadow ray in it."}});
    page.table(cell_header(), cell_rows(scene), "What that cell lists.");
}

// 3. What a cell has to list: README (4) to (6).
void tell_centers(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("What belongs into a list?");
    page.text("All that is seen through any point of the cell. It is tempting to ask for its centre only, as a "
              "picture of the light's view would be drawn; and then bars that pass between the centres cast no "
              "shadow, or half of one.");
    page.figures({{write_picture(side_by_side({shaded_by_centers(scene, 16, run), shaded_by_centers(scene, 64, run)}),
                                 run.out, "centres"),
                   "Expected failure: lists made by the cells' centres. More cells make finer holes."}});
    page.text("The lab proves instead that a primitive is *not* seen through a cell, by a plane through the light "
              "that has the one on this side and the other on that. Where no such plane is found it is listed. "
              "Nothing is missing, and the pictures are the same to the bit.");
}

// 4. The cost: README, "What it costs".
void tell_cost(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("How many cells?");
    page.table(resolution_header(), resolution_rows(run), "20 000 shadow rays of the lantern's scene.");
    page.figures({{write_picture(shadow_ray_costs(scene, run), run.out, "shadow_ray_costs"),
                   "Where the tests are: boxes and primitives."}});
    write_chart(build_chart(run), run.out, "build");
    page.figures({{"build.svg", "Every primitive is taken down to its cells by quarters; what is large fills many."}});
    write_chart(distance_chart(run), run.out, "distance");
    page.figures(
        {{"distance.svg",
          "500 triangles in a cube of two metres. From 64 metres away they fill one cell of 16 x 16, and the buffer "
          "is a list."}});
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    tell_cube(run, page, scene);
    tell_cell(run, page, scene);
    tell_centers(run, page, scene);
    tell_cost(run, page, scene);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"08_light_buffer", "Light buffer", "Can shadows be cheaper?"},
                          .story = story,
                          .questions = {{"light_buffer", measure_light_buffers}},
                          .cases = cases};
    return run_chapter(chapter, argc, argv);
}
