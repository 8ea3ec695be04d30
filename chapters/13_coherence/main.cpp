// Chapter 13: do neighbouring rays share work?
//
// The rays of a picture are related: those from one eye, those that begin side by side, those to one light. Here are
// four ways to do common work once. The formulas are in README.md, which tells the same story.

#include "cases.h"
#include "first_hit.h"
#include "pictures.h"
#include "tables.h"

#include "raylab/image/picture_files/files.h"
#include "raylab/report/chapter.h"
#include "raylab/report/chart/chart.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::coherence;

namespace {

// 1. README, "All from one eye".
void tell_item_buffer(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("All from one eye");
    page.text("The first hit of every eye ray is what a drawing shows: so draw. Every primitive is projected into "
              "the picture, and every pixel keeps what may be seen through it, the nearest first: an *item buffer*. "
              "The ray then tests what its pixel has kept, and stops where nothing nearer can come.");
    const Image picture = by_item_buffer(scene, run);
    const std::size_t others = other_pixels(scene, picture, run);
    page.figures({{write_picture(picture, run.out, "colonnade"),
                   fmt::format("Eye rays by an item buffer, all others by a tree. Pixels that a tree alone makes "
                               "different: {}.",
                               others)},
                  {write_picture(items(scene, run), run.out, "items"),
                   "The first item of each pixel, each in a colour of its own."},
                  {write_picture(items_kept(scene, run), run.out, "items_kept"), "How many items each pixel keeps."}});
}

// 2. README, "Exact, and why".
void tell_exact(const ChapterRun& run, Page& page) {
    page.heading("Exact, and why");
    page.text("The published buffer kept one item a pixel: the nearest at the pixel's middle, by a z-buffer's "
              "rounded numbers. That is another picture than the rays'. Kept is here whatever a ray through the "
              "closed pixel *may* hit, rounding included, and the ray decides.");
    page.figures({{write_picture(wrong_items(run), run.out, "wrong_items"),
                   "Expected failure: red is where a z-buffer in floats has another triangle than the ray, from ten "
                   "thousand radii away."}});
    page.table(saving_header(), saving_rows(run),
               "A bumpy ball. Where pixels are many, drawing is little work for "
               "each.");
}

// 3. README, "Side by side".
void tell_packets(const ChapterRun& run, Page& page) {
    page.heading("Side by side");
    page.text("Rays through neighbouring pixels take nearly the same way through a tree. A packet of 8 x 8 goes "
              "down together: a box that none of them hits costs one test, and so does one that all hit; only in "
              "between is each ray asked.");
    const auto files = write_chart(packet_chart(run), run.out, "packet_boxes");
    for (const auto& file : files)
        if (file.extension() == ".svg") page.figures({{"packet_boxes.svg", "Boxes tested; no machine changes it."}});
}

// 4. README, "The same light".
void tell_memory(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("The same light");
    page.text("What stopped the last shadow ray to a light mostly stops the next. So it is asked first: one number "
              "a light is all the memory that it takes, and where it is wrong, one test is lost.");
    page.table(memory_header(), memory_rows(scene, run), "Shadow rays in the order of the picture, through bvh.");
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    tell_item_buffer(run, page, scene);
    tell_exact(run, page);
    tell_packets(run, page);
    tell_memory(run, page, scene);
    page.heading("Five dimensions");
    page.text("A ray is a point: three numbers for where it begins, two for where it goes. Cells of such points "
              "share a list of what their rays may hit: *ray-space subdivision*. It asks no tree at all, and pays "
              "with memory. The chart has it beside the others, on rays of the camera, on bounces, and on rays that "
              "have nothing in common.");
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"13_coherence", "Coherence", "Do neighbours share work?"},
                          .story = story,
                          .questions = {{"first_hit", measure_first_hit}},
                          .cases = cases};
    return run_chapter(chapter, argc, argv);
}
