#include "raylab/report/chapter_picture.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/tracer/picture/whitted_picture.h"

namespace raylab {

EyePictureOptions chapter_rays(const ChapterRun& run, int per_side) {
    return {.samples = {SamplePattern::jittered, run.sized(per_side, 1), run.seed},
            .threads = run.threads,
            .label = "rays"};
}

Image chapter_picture(const Scene& scene, ImageSize size, const ChapterRun& run, const WhittedOptions& options) {
    return whitted_picture(scene, *make_accelerator("auto", scene), camera_frame(scene.camera, size, scene.source),
                           options, chapter_rays(run));
}

}  // namespace raylab
