// Chapter 03: does a ray hit a triangle, a polygon?
//
// The scene, the question, the computation, the evidence, in this order. The formulas are in README.md, which tells the
// same story.

#include "mesh_pictures.h"
#include "microscope.h"
#include "polygon_pictures.h"
#include "questions.h"
#include "stability.h"
#include "stage.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/image/draw.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/chapter.h"
#include "raylab/tracer/picture/first_hit_picture.h"

#include <fmt/format.h>

using namespace raylab;

namespace {

// 1. Most shapes that a ray tracer is given consist of triangles in the end.
void tell_mesh(const ChapterRun& run, Page& page) {
    const auto [scene, mesh, triangles] = set_stage(run.scene);
    const CameraFrame frame = camera_frame(scene.camera, scene.image, scene.source);
    const auto accelerator = make_accelerator("auto", scene);
    const EyePictureOptions options{.samples = {SamplePattern::jittered, 3, run.seed}, .threads = run.threads};
    const Image lit = first_hit_picture(scene, *accelerator, frame, FirstHitShading::light, options);
    const Image normals = first_hit_picture(scene, *accelerator, frame, FirstHitShading::normals, options);

    page.heading("In the end it is triangles");
    page.text(
        fmt::format("{} triangles stand on one polygon. Each pixel asks one question, many times: does this ray hit "
                    "that triangle, and where?",
                    triangles));
    if (mesh == "knot") page.text("(The elephant has not been fetched: a generated knot stands in for it.)");
    page.figures({{write_picture(lit, run.out, mesh), "Lit from over the shoulder."},
                  {write_picture(normals, run.out, mesh + "_normals"), "Coloured by the normals of its triangles."}});
}

// 2. The answer is three numbers, t, u and v: README (1) and (2).
void tell_weights(const ChapterRun& run, Page& page) {
    const int side = run.sized(320, 160);
    const auto ball = [&](Interpolated interpolated, const std::string& name) {
        return write_picture(enlarged(ball_picture(interpolated, {side, side}, run.threads), 320 / side), run.out,
                             name);
    };
    page.heading("Where it hits: the weights u and v");
    page.text("A hit is `t` along the ray, and weights of the three vertices: 1 - u - v of a, u of b, v of c. With "
              "them anything known at the vertices is known everywhere between.");
    page.figures({{ball(Interpolated::nothing, "flat"), "80 triangles, each with its one normal."},
                  {ball(Interpolated::colors, "weights"), "The weights themselves: a red, b green, c blue."},
                  {ball(Interpolated::normals, "smooth"),
                   "The vertices' normals mixed by the weights: only the outline still tells."}});
}

// 3. Seven methods answer, and no two of them round alike: README (3) to (7).
void tell_methods(const ChapterRun& run, Page& page) {
    const auto methods = ray_triangle_methods();
    const auto figures = [&](const Specimen& specimen, const std::string& of) {
        std::vector<Page::Figure> all;
        for (const auto* title :
             {"plane and edges, float", "Badouel, float", "Moeller-Trumbore, float", "Baldwin-Weber, float",
              "Pluecker, float", "watertight, float", "Moeller-Trumbore, double", "filtered exact, double + exact"}) {
            const auto file = fmt::format("{}_{}", of, all.size() + 1);
            all.push_back({write_picture(microscope(find_method(methods, title), specimen, 40), run.out, file), title});
        }
        return all;
    };
    page.heading("Seven methods under the microscope");
    page.text("In real numbers they all agree. In these pictures each ray differs from its neighbour in the last "
              "bit of one coordinate. Two triangles share the edge in the middle. A slanted stroke: one of them is "
              "hit, and the slant says which. A cross on white: both. *A ring on black: none*, the ray slips "
              "between them.");
    page.figures(figures(shared_edge(), "edge"));
    page.text("Six triangles around one vertex. *Watertight* keeps its promise: no ring anywhere. It does not "
              "promise to be right: compare its borders with the exact ones.");
    page.figures(figures(shared_vertex(), "vertex"));
    std::vector<std::vector<std::string>> sources;
    for (const auto& method : methods) sources.push_back({method.name, method.number, method.source});
    page.table({"method", "computes in", "source"}, sources, "Every method of the charts below.");
}

// 4. Rounding of one bit can open a hole through which light comes.
void tell_leaks(const ChapterRun& run, Page& page) {
    const TriangleMethod leaky = find_method(ray_triangle_methods(), "Moeller-Trumbore, float");
    const Mesh mesh = icosphere(3);
    const Vec3d eye{0.1, 0.2, 0.15};
    const Vec3d target = leakiest_point(leaky, mesh, convert<float>(eye));
    const auto view = [&](double fov_y, ImageSize size) {
        const CameraFrame frame =
            camera_frame({.position = eye, .target = target, .projection = Perspective{fov_y}}, size);
        return enlarged(mesh_picture(leaky, mesh, frame, run.threads), 320 / size.width);
    };
    const ImageSize small = run.sized(ImageSize{80, 60}, ImageSize{40, 30});
    page.heading("Light leaks");
    page.text("From inside a closed ball of 1280 triangles there is nothing bright to be seen. Moeller and "
              "Trumbore's test in float sees light all the same, where two triangles meet.");
    page.figures({{write_picture(view(70, run.sized(ImageSize{320, 240}, ImageSize{160, 120})), run.out, "inside"),
                   "Inside the ball, 70 degrees wide."},
                  {write_picture(view(0.07, small), run.out, "inside_1000"), "One edge, a thousand times closer."},
                  {write_picture(view(0.0002, small), run.out, "inside_350000"),
                   "350 000 times closer, where a pixel is about as wide as a float is fine: light leaks."}});
}

// 5. A polygon is flat, so whether it is hit is a question in two dimensions: README (8).
void tell_polygons(const ChapterRun& run, Page& page) {
    const auto star = [&](StarMethod method, const std::string& name) {
        return write_picture(star_picture(method, {320, 320}, run.threads), run.out, name);
    };
    page.heading("Polygons, convex and not");
    page.text("Dropping the coordinate in which the normal is longest keeps most of the polygon. In the plane, a "
              "half-line from the point crosses the border an odd number of times if the point is inside.");
    page.figures({{write_picture(projection_picture({480, 400}, run.threads), run.out, "projection"),
                   "Three projections of one star."},
                  {write_picture(crossings_picture({480, 400}), run.out, "crossings"), "Crossings counted."}});
    page.figures({{star(StarMethod::even_odd, "star_even_odd"), "Even-odd: right for every polygon."},
                  {star(StarMethod::half_planes, "star_half_planes"), "Inside all edges: right for convex ones."},
                  {star(StarMethod::fan, "star_fan"), "A fan of triangles: right for convex ones."}});
}

void story(const ChapterRun& run, Page& page) {
    tell_mesh(run, page);
    tell_weights(run, page);
    tell_methods(run, page);
    tell_leaks(run, page);
    tell_polygons(run, page);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{
        .title = {"03_triangles_and_polygons", "Triangles and polygons", "Does a ray hit a triangle, a polygon?"},
        .story = story,
        .questions = {{"ray_triangle", ray_triangle},
                      {"closed_mesh", closed_mesh},
                      {"ray_polygon", ray_polygon},
                      {"interpolation", interpolation}},
        .cases = stability_cases};
    return run_chapter(chapter, argc, argv);
}
