// Chapter 02: where does a ray hit an implicit surface?
//
// A surface is where a function of space is zero. The ray inserted into the function leaves an equation in t; for
// spheres and the other quadrics it is quadratic, which is easy to solve on paper. The formulas are in README.md, which
// tells the same story.

#include "evidence.h"
#include "pictures.h"
#include "questions.h"
#include "stability.h"

#include "raylab/image/picture_files/files.h"
#include "raylab/report/chapter.h"
#include "raylab/report/chart/chart.h"
#include "raylab/scene/read_scene.h"

using namespace raylab;

namespace {

void show(const std::vector<Step>& steps, const ChapterRun& run, Page& page) {
    std::vector<Page::Figure> figures;
    for (const Step& step : steps) {
        write_image(step.image, run.out / step.file);
        figures.push_back({step.file, step.caption});
    }
    page.figures(figures);
}

// 1. The scene: one shape of each kind.
void tell_scene(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("A still life of quadrics");
    page.text("A vase (hyperboloid), a bowl (paraboloid) with an orange in it (sphere), a party hat and a beaker "
              "(cones), a drum and a napkin ring (cylinders), an egg (ellipsoid). One equation finds them all.");
    const Step picture = still_life(scene, run);
    show({picture}, run, page);
    write_image(picture.image, run.out / "still_life.exr");  // the file that reference_images/ keeps
    page.text("A picture takes four answers per ray; these are the first three, the fourth is how bright it is there.");
    show(still_life_steps(scene, run), run, page);
}

// 2. The question: README (1) to (3), and what a float makes of it.
void tell_question(const ChapterRun& run, Page& page) {
    page.heading("A quadratic, and its discriminant");
    page.text("Where does a ray `O + t d` hit a sphere `|P - C|^2 = r^2`? With `f = O - C` where `a t^2 + 2 b t + "
              "c = 0`, `a = d.d`, `b = f.d`, `c = f.f - r^2`. Whether there is such a `t` says the discriminant `D "
              "= b^2 - a c`; which, the roots `(-b +- sqrt(D)) / a`. On paper that is the end of it.");
    page.text("In float, from 4096 radii away, `b^2` and `a c` agree in all the digits there are:");
    page.table(cancellation_header(), cancellation_rows(), "A ray that passes a unit sphere's center at 0.4 radii.");
    show(far_sphere_steps(run), run, page);
}

// 3. The computation: three repairs, README (4) to (6), and what they do not repair.
void tell_computation(const ChapterRun& run, Page& page) {
    page.heading("Three repairs");
    page.text("*Stable* roots add where the school formula subtracts: `q = -(b + sign(b) sqrt(D))`, `t = q / a` and "
              "`t = c / q`. That mends where the ray hits, not whether.");
    page.text("The *reformulated* discriminant measures how far the line passes from the center: `D = a (r^2 - |f - "
              "(b / a) d|^2)`. Nothing of the size of the distance is left to cancel. That mends whether.");
    page.text("What neither mends is `c = |f|^2 - r^2` for an eye just above a huge sphere. The *factored* form `c "
              "= (|f| + r)(|f| - r)` is right there only by luck. Other numbers help (double), or another shape: "
              "nobody needs the Earth's curvature under a table.");
    show(floor_steps(run), run, page);
}

// The other quadrics, README (7) to (11), and their normals, README (12).
void tell_quadrics(const ChapterRun& run, Page& page, const Scene& scene) {
    page.heading("Cylinder, cone, paraboloid, hyperboloid");
    page.text("The other quadrics differ in `a`, `b` and `c` only. On a surface of revolution, `rho^2 = q(s)` with "
              "`s` from 0 at the base to 1 at the top, a root counts where `0 <= s <= 1`, and a cap is a disk that "
              "may come first.");
    show(quadric_steps(run), run, page);
    page.heading("A gradient is a normal, once it is normalised");
    page.text("The function whose zeros are the surface grows fastest straight away from it. How fast is another "
              "matter: the gradients below are shorter on the hat's tip than at its brim, and longest on the egg.");
    show(gradient_steps(scene, run), run, page);
    page.table(normal_header(), normal_rows(run), "Angles between computed and exact normals, side walls only.");
}

// 4. The evidence. Charts and stability cases are added to the page automatically.
void tell_evidence(const ChapterRun& run, Page& page) {
    page.heading("Every method on every workload");
    page.text("The oracle, which computes without rounding, judges. Wrong decisions in parts per million: misses / "
              "false hits.");
    page.table(decisions_header(run), decisions_rows(run));
    page.text("The further away a sphere, the more of its rays are decided wrongly. A method that is not drawn made "
              "no mistake at any distance.");
    for (const auto& file : write_chart(wrong_by_distance(run), run.out, "wrong_by_distance"))
        if (file.extension() == ".svg")
            page.figures({{file.filename().string(), "Wrong decisions by distance, for rays within 1.2 radii."}});
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    tell_scene(run, page, scene);
    tell_question(run, page);
    tell_computation(run, page);
    tell_quadrics(run, page, scene);
    tell_evidence(run, page);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{
        .title = {"02_spheres_and_quadrics", "Spheres and quadrics", "Where does a ray hit an implicit surface?"},
        .story = story,
        .questions = {{"ray_sphere", ray_sphere}, {"ray_sphere_t", ray_sphere_t}, {"ray_quadric", ray_quadric}},
        .cases = stability_cases};
    return run_chapter(chapter, argc, argv);
}
