// Chapter 05: how bright is a point, locally?
//
// A local model uses a point, its normal, its material, the lights and the eye, and nothing else of the scene. The
// formulas are in README.md, numbered as here, which tells the same story.

#include "cases.h"
#include "local_pictures.h"
#include "mach_bands.h"
#include "normal_pictures.h"
#include "questions.h"
#include "surfaces.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/geometry/mesh/vertex_normals.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::lighting;

namespace {

// 1. The lights: README (1) to (3).
void tell_lights(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("Four kinds of light");
    page.text("*Ambient* light comes from everywhere. A *point* light falls off with the distance. A *spot* has a "
              "direction and a cone. A *distant* light has a direction and nothing else. Light adds up: the scene "
              "is the sum of four pictures.");
    page.figures({{write_picture(lit(scene, run), run.out, "lit"),
                   "The scene. The small ball glows, and lights nothing; the bowl has another material inside."}});
    page.figures({{write_picture(lights_apart(scene, run), run.out, "lights_apart"), "The same by each light alone."}});
    page.figures({{write_picture(falloffs(run), run.out, "falloffs"),
                   "A light over a floor; at 2 metres all three are alike."}});
    page.figures({{write_picture(spots(run), run.out, "spots"), "A spot of 20 degrees on a wall."}});
}

// 2. How a surface reflects light: README (4) and (5).
void tell_phong(const ChapterRun& run, Page& page) {
    page.heading("Phong's model");
    page.text("A surface sends out what it *emits*, its share of the *ambient* light, and of each light in front of "
              "it a *diffuse* part, which goes all ways, and a *specular* part, which goes about the mirror "
              "direction. Three numbers a term, for red, green and blue: they stand in for a spectrum.");
    page.figures({{write_picture(phong_terms(run), run.out, "phong_terms"), "Term by term."}});
    page.figures({{write_picture(viewers(run), run.out, "viewers"),
                   "A plane under a distant light has a highlight only where the viewer is somewhere: at infinity all "
                   "of it is alike."}});
}

void show_agreement(const ChapterRun& run, Page& page) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& surface : two_way_surfaces()) {
        rows.push_back({surface.name, surface.implicit, surface.parametric});
        rows.back().push_back(worst_lean(surface, surface.by_tangents, run.seed) < 1e-14 ? "below 1e-14" : "more");
        for (const double step : {0.1, 0.01, 0.0001})
            rows.back().push_back(fmt::format("{:.1g}", worst_lean_by_three_points(surface, step, run.seed)));
    }
    page.table({"surface", "F", "P", "tangents", "three points, 0.1 apart", "0.01", "0.0001"}, rows,
               "The worst angle to the gradient's normal, in radians, at 1000 points.");
}

// 3. The normal determines the brightness: README (6) to (8).
void tell_normals(const ChapterRun& run, Page& page) {
    page.heading("Where normals come from");
    page.text("From the *gradient* where a function is zero on the surface, from two *tangents* where the surface "
              "is a function of two parameters, and from *three points* where it is neither. The first two agree to "
              "the last digits; the third comes nearer with nearer points, until what rounding left of their "
              "differences is all that counts.");
    page.figures({{write_picture(draw_three_normals(run), run.out, "three_normals"),
                   "The normals of an ellipsoid, as colours."}});
    show_agreement(run, page);
}

// 4. Where on a mesh the model is evaluated: README (9) to (11).
void tell_meshes(const ChapterRun& run, Page& page) {
    page.heading("Flat, Gouraud, Phong");
    page.text("A mesh has few normals, and its points are many. *Flat* shading asks once a triangle, *Gouraud's* "
              "once a vertex and mixes colours, *Phong's* at every point, with a mixed normal. The mesh is the "
              "same, the rim as well: only the brightness changes.");
    const auto mesh = std::make_shared<const Mesh>(with_vertex_normals(bumpy_sphere(3)));
    page.figures(
        {{write_picture(three_shadings(mesh, run), run.out, "three_shadings"), "One mesh of 1280 triangles."}});
    page.text("The eye looks for edges, and exaggerates them: a step of brightness looks darker before it and "
              "lighter behind it, and even a kink shows as a band. Ernst Mach described these bands in 1865.");
    page.figures({{write_picture(draw_mach_bands(run), run.out, "mach_bands"),
                   "Black: brightness along the marked line; blue: the exact sphere's. Steps, kinks, nearly none."}});
}

// 5. What is missing.
void tell_limits(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("What a local model cannot show");
    page.text("Nothing here knew of any other surface: no shadow falls, no light comes back from the floor, nothing "
              "is mirrored, and the glowing ball is a light for nobody. All that takes asking the scene, which is "
              "what the next chapters do.");
    page.figures({{write_picture(local_and_shadowed(scene, run), run.out, "local_and_shadowed"),
                   "Expected failure on the left: balls that float, because nothing says where they stand."}});
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    tell_lights(run, page, scene);
    tell_phong(run, page);
    tell_normals(run, page);
    tell_meshes(run, page);
    tell_limits(run, page, scene);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{
        .title = {"05_lighting", "Lighting", "How bright is a point, locally?"},
        .story = story,
        .questions = {{"mesh_shading", measure_mesh_shading}, {"phong_specular", measure_phong_specular}},
        .cases = cases};
    return run_chapter(chapter, argc, argv);
}
