// Chapter 01: which ray belongs to a pixel?
//
// The scene, the question, the computation, the evidence, in this order. The formulas are in README.md, which tells the
// same story.

#include "cases.h"
#include "directions.h"
#include "drawings.h"
#include "pixel_samples.h"

#include "raylab/image/draw.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/chapter.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/first_hit_picture.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::ray_generation;

namespace {

// 1. A camera is an eye, three axes and a picture rectangle: README (1) and (2).
void tell_frame(const ChapterRun& run, Page& page, const Stage& stage, const CameraFrame& frame) {
    page.heading("A camera is a frame and a rectangle");
    page.text("An eye, a target and a hint which way is up make three axes at right angles. At distance 1 along "
              "`forward` stands the picture; the ray of pixel (i, j) goes from the eye through the centre of its "
              "square.");
    page.figures({{write_picture(draw_camera(stage, frame), run.out, "camera"),
                   "The camera seen by a bystander: its axes, 8 x 6 of its pixels, one ray up to what it hits."}});
}

// 2. Parallel rays make another picture than rays from one point: README (3).
void tell_projections(const ChapterRun& run, Page& page, const Stage& stage, const CameraFrame& frame) {
    Camera camera = stage.scene.camera;
    camera.projection = Orthographic{3.6};
    const CameraFrame parallel = camera_frame(camera, stage.scene.image, stage.scene.source);
    const EyePictureOptions nine{.samples = {SamplePattern::jittered, 3, run.seed}, .threads = run.threads};
    const auto picture = [&](const CameraFrame& from) {
        return first_hit_picture(stage.scene, stage.accelerator, from, FirstHitShading::light, nine);
    };
    page.heading("Perspective and orthographic");
    page.text("Only the rays differ: all through one eye, or all along one direction. What shrinks with distance in "
              "the first keeps its size in the second, and the horizon is gone.");
    page.figures({{write_picture(draw_bundle(stage, frame), run.out, "perspective_rays"), "Rays through one eye."},
                  {write_picture(picture(frame), run.out, "perspective"), "What they see."}});
    page.figures(
        {{write_picture(draw_bundle(stage, parallel), run.out, "orthographic_rays"), "Rays along one direction."},
         {write_picture(picture(parallel), run.out, "orthographic"), "What they see."}});
}

// 3. A pixel is a square and a ray has no width: where in the square should it pass?
void tell_samples(const ChapterRun& run, Page& page, const Stage& stage) {
    const CameraFrame coarse = camera_frame(stage.scene.camera, {160, 120}, stage.scene.source);
    const auto detail = [&](SamplePattern pattern, int per_side, const std::string& name, const std::string& caption) {
        const EyePictureOptions options{.samples = {pattern, per_side, run.seed}, .threads = run.threads};
        const Image picture =
            first_hit_picture(stage.scene, stage.accelerator, coarse, FirstHitShading::light, options);
        return Page::Figure{write_picture(enlarged(cropped(picture, 60, 18, 80, 60), 4), run.out, name), caption};
    };
    page.heading("Where in the pixel?");
    page.text("One ray at the centre sees an edge or does not: stairs, and a floor that boils towards the horizon. "
              "One at the corner sees the same half a pixel away. The mean of many rays tells how much of the pixel "
              "is covered: spread by chance they clump, one to each cell of a grid (*jittered*) they do not.");
    page.figures(
        {{write_picture(draw_sample_patterns(run.seed), run.out, "patterns"), "Nine pixels and their samples."}});
    page.figures({detail(SamplePattern::center, 1, "centre_1", "1 ray, pixel centre"),
                  detail(SamplePattern::random, 4, "random_16", "16 rays, anywhere in the pixel"),
                  detail(SamplePattern::jittered, 4, "jittered_16", "16 rays, one in each of 4 x 4 cells")});
    page.table(sample_error_header(), sample_error_rows(run),
               "RMS error of the share that N rays give, in pixels that a slanted edge crosses.");
}

// 4. Light travels from the light source to the eye. Why is it followed the other way?
void tell_directions(const ChapterRun& run, Page& page, const Stage& stage, const CameraFrame& frame) {
    page.heading("Backward and forward");
    page.text("Forward, a ray leaves the light in any direction and is scattered at random until a surface absorbs "
              "it or the sky takes it. It *reaches the eye* if it hits a disk of the given radius there, and the "
              "picture if it came through a pixel. Backward, every ray is one that the picture needs.");
    page.figures({{write_picture(draw_light_paths(stage, frame, run.seed), run.out, "forward_rays"),
                   "Forward: 60 rays from the light."},
                  {write_picture(draw_eye_paths(stage, frame), run.out, "backward_rays"),
                   "Backward: 30 rays from the eye, each sent on to the light."}});
    const Directions made = compare_directions(run, stage);
    page.figures(
        {{write_picture(made.backward, run.out, "backward"), fmt::format("Backward, {} eye rays.", made.eye_rays)},
         {write_picture(made.forward, run.out, "forward"), "Forward, as many light rays, an eye of radius 0.5 m."},
         {write_picture(made.forward_more, run.out, "forward_more"),
          fmt::format("Forward, {} times as many.", made.times)}});
    page.table(made.header, made.fates, made.pupil);
}

void story(const ChapterRun& run, Page& page) {
    const Scene scene = read_scene(run.scene);
    const auto list = make_accelerator("list", scene);
    const Stage stage{scene, *list, run.threads};
    const CameraFrame frame = camera_frame(scene.camera, scene.image, scene.source);
    tell_frame(run, page, stage, frame);
    tell_projections(run, page, stage, frame);
    tell_samples(run, page, stage);
    tell_directions(run, page, stage, frame);
}

}  // namespace

int main(int argc, char** argv) {
    const Chapter chapter{.title = {"01_ray_generation", "Ray generation", "Which ray belongs to a pixel?"},
                          .story = story,
                          .questions = {{"pixel_samples", measure_pixel_samples}},
                          .cases = cases};
    return run_chapter(chapter, argc, argv);
}
