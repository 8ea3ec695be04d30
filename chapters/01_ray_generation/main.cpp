// Chapter 01: which ray belongs to a pixel?
//
// The figures and tables of the lesson, README.md, in its order; the formulas are there.

#include "camera_drawings.h"
#include "case_sketches.h"
#include "cases.h"
#include "directions.h"
#include "drawings.h"
#include "pixel_samples.h"

#include "raylab/base/lazy.h"
#include "raylab/image/draw.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/first_hit_picture.h"

using namespace raylab;
using namespace raylab::ray_generation;

namespace {

// 1. A camera is an eye, three axes and a picture in space: README (1) and (2).
void show_camera(Page& page, const Stage& stage, const CameraFrame& frame) {
    page.figure("camera", [&] { return draw_camera(stage, frame); });
    page.figure("camera_numbers", [] { return draw_camera_numbers(); });
    page.figure("pixel_points", [] { return draw_pixel_points(); });
}

// 2. Parallel rays make another picture than rays from one point: README (3).
void show_projections(const ChapterRun& run, Page& page, const Stage& stage, const CameraFrame& frame) {
    Camera camera = stage.scene.camera;
    camera.projection = Orthographic{3.6};
    const CameraFrame parallel = camera_frame(camera, stage.scene.image, stage.scene.source);
    const EyePictureOptions nine{.samples = {SamplePattern::jittered, 3, run.seed}, .threads = run.threads};
    const auto picture = [&](const CameraFrame& from) {
        return first_hit_picture(stage.scene, stage.accelerator, from, FirstHitShading::light, nine);
    };
    page.figure("perspective_rays", [&] { return draw_bundle(stage, frame); });
    page.figure("perspective", [&] { return picture(frame); }, {.keep = Page::Keep::floats});
    page.figure("orthographic_rays", [&] { return draw_bundle(stage, parallel); });
    page.figure("orthographic", [&] { return picture(parallel); }, {.keep = Page::Keep::floats});
}

// 3. A pixel is a square and a ray has no width: where in the square should it pass?
void show_samples(const ChapterRun& run, Page& page, const Stage& stage) {
    const CameraFrame coarse = camera_frame(stage.scene.camera, {160, 120}, stage.scene.source);
    const auto detail = [&](const std::string& name, SamplePattern pattern, int per_side) {
        page.figure(name, [=, &stage, &run] {
            const EyePictureOptions options{.samples = {pattern, per_side, run.seed}, .threads = run.threads};
            const Image picture =
                first_hit_picture(stage.scene, stage.accelerator, coarse, FirstHitShading::light, options);
            return enlarged(cropped(picture, 60, 18, 80, 60), 8);
        });
    };
    page.figure("patterns", [&] { return draw_sample_patterns(run.seed); });
    detail("centre_1", SamplePattern::center, 1);
    detail("random_16", SamplePattern::random, 4);
    detail("jittered_16", SamplePattern::jittered, 4);
    page.table("sample_errors", sample_error_header(), [&] { return sample_error_rows(run); });
}

// 4. Light travels from the light source to the eye. Why is it followed the other way?
void show_directions(const ChapterRun& run, Page& page, const Stage& stage, const CameraFrame& frame) {
    const Lazy<Directions> made([&] { return compare_directions(run, stage); });
    page.figure("forward_rays", [&] { return draw_light_paths(stage, frame, run.seed); });
    page.figure("backward_rays", [&] { return draw_eye_paths(stage, frame); });
    page.figure("backward", [&] { return made().backward; }, {.keep = Page::Keep::floats});
    page.figure("forward", [&] { return made().forward; });
    page.figure("forward_more", [&] { return made().forward_more; });
    page.table("light_rays", light_ray_header(), [&] { return made().fates; });
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    const auto list = make_accelerator("list", scene);
    const Stage stage{scene, *list, run.threads};
    const CameraFrame frame = camera_frame(scene.camera, scene.image, scene.source);
    show_camera(page, stage, frame);
    show_projections(run, page, stage, frame);
    show_samples(run, page, stage);
    show_directions(run, page, stage, frame);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"01_ray_generation", "Ray generation", "Which ray belongs to a pixel?"},
                          .story = story,
                          .questions = {{"pixel_samples", measure_pixel_samples}},
                          .cases = [](const ChapterRun& run) { return with_sketches(cases(run), case_sketches()); }};
    return run_chapter(chapter, argc, argv);
}
