// Chapter 06: is a point lit?
//
// A shadow ray to the light tells, as Appel (1968) and Whitted (1980) trace it. The subject of this chapter is where it
// starts. The formulas are in README.md, numbered as here, which tells the same story.

#include "cases.h"
#include "pictures.h"
#include "shadow_rays.h"

#include "raylab/image/draw.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::shadows;

namespace {

// 1. The scene: README (1).
void tell_scene(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("A shadow ray to every light");
    page.text("From a point that is to be shaded a ray goes to each light. If it arrives, the light's two terms are "
              "added; if anything is in its way, they are not, and what remains is the *ambient* term. Occluders "
              "are opaque: the first one found ends the search, whichever it is. A light behind the surface needs "
              "no shadow ray.");
    page.figures({{write_picture(shaded(scene, run), run.out, "shadows"),
                   "Two lights, two shadows each; where they overlap only ambient light is left. The edges are "
                   "sharp: a point sees a point or does not."}});
    page.figures({{write_picture(lights_apart(scene, run), run.out, "lights_apart"), "The sum, term by term."}});
}

// 2. The question: where does a shadow ray start? README (2) to (4).
void tell_starts(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("Where does it start?");
    page.text("At the hit point, on paper. In floats that point lies a little above its surface or a little below, "
              "and from below the first thing that a shadow ray hits is the surface that it leaves.");
    page.figures({{write_picture(draw_starts(), run.out, "starts"),
                   "Grey: the floats. The nearest to the hit point may be on the wrong side."}});
    const RayStart nowhere{RayStart::Point::along_ray, RayStart::Offset::none, 0, RayStart::Leaving::forgotten};
    page.figures(
        {{write_picture(with_shadows(scene, nowhere, run), run.out, "acne"),
          "Expected failure: *shadow acne*. Shadow rays start at O + t d; half of the points shade "
          "themselves."},
         {write_picture(with_shadows(scene, {}, run), run.out, "no_acne"), "The same, started beside the surface."}});
}

// 3. An offset along the ray is a cure where its length is right. README (5).
void tell_fixed(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("A hair's breadth, but whose?");
    page.text("The usual cure lets the shadow ray begin a little further on. But how little is little? A thousandth "
              "of a metre is nothing on a table, the whole scene on a pinhead, and less than a float's spacing in a "
              "landscape.");
    const RayStart millimetre = ray_start_from_words("fixed:0.001");
    const auto side = [&](const RayStart& start, double scale, const Vec3d& by) {
        return with_shadows(elsewhere(scene, scale, by), start, run);
    };
    page.figures({{write_picture(side(millimetre, 1e-3, {0, 0, 0}), run.out, "peter_panning"),
                   "Expected failure: *Peter-Panning*. A table of some millimetres, shadow rays from t = 0.001: "
                   "things have lost the shadows that tied them down."},
                  {write_picture(side({}, 1e-3, {0, 0, 0}), run.out, "contact"),
                   "The same table, started beside the surface."}});
    page.figures({{write_picture(side(millimetre, 1, {1e5, 7e4, -4e4}), run.out, "acne_far"),
                   "Expected failure: the same millimetre, a hundred kilometres from the origin, where floats are 8 "
                   "mm apart."},
                  {write_picture(side({}, 1, {1e5, 7e4, -4e4}), run.out, "far"),
                   "Beside the surface, there. The shapes are exact; only starts are 8 mm apart."}});
}

// 4. What counts of rays reveal. README, "What published counts teach".
void tell_counts(const ChapterRun& run, Page& page) {
    page.heading("What published counts teach");
    page.text("Spheres that touch, and mirror one another. A ray that starts a hundredth of a metre further on "
              "starts inside the neighbour, near where they touch, and is mirrored about in there. One cannot see "
              "it; one can count it.");
    page.figures(
        {{write_picture(flake({}, run), run.out, "flake"), "820 spheres on a floor, three lights, five rays deep."}});
    page.table(flake_header(), flake_rows(run), "Rays for the picture above.");
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    tell_scene(run, page, scene);
    tell_starts(run, page, scene);
    tell_fixed(run, page, scene);
    tell_counts(run, page);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"06_shadows", "Shadows", "Is a point lit?"},
                          .story = story,
                          .questions = {{"shadow_ray", measure_shadow_rays}},
                          .cases = cases};
    return run_chapter(chapter, argc, argv);
}
