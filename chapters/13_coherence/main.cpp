// Chapter 13: do neighbouring rays share work? README.md is the lesson; here is what it shows.

#include "case_sketches.h"
#include "cases.h"
#include "drawings.h"
#include "first_hit.h"
#include "pictures.h"
#include "tables.h"

#include "raylab/report/chapter.h"
#include "raylab/scene/read_scene.h"

using namespace raylab;
using namespace raylab::coherence;

namespace {

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    page.figure("colonnade", [&] { return by_item_buffer(scene, run); });
    page.figure("items", [&] { return items(scene, run); }, {.keep = Page::Keep::floats});
    page.figure("items_kept", [&] { return items_kept(scene, run); });
    page.table("same", other_pixels_header(), [&] { return other_pixels_rows(scene, run); });
    page.figure("wrong_items", [&] { return wrong_items(run); });
    page.table("saving", saving_header(), [&] { return saving_rows(run); });
    page.figure("packet", draw_packet);
    page.figure("packet_boxes", [&] { return packet_chart(run); });
    page.table("memory", memory_header(), [&] { return memory_rows(scene, run); });
    page.figure("ray_cells", draw_ray_cells);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"13_coherence", "Coherence", "Do neighbours share work?"},
                          .story = story,
                          .questions = {{"first_hit", measure_first_hit}},
                          .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
