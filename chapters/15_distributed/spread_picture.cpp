#include "spread_picture.h"

#include "raylab/report/provenance.h"
#include "raylab/scene/read_scene.h"

#include <algorithm>

namespace raylab::spread {

Image spread_picture(const Scene& scene, ImageSize size, const Samples& samples, const ChapterRun& run) {
    const CameraFrame frame = camera_frame(scene.camera, size, scene.source);
    const auto accelerator = make_accelerator("auto", scene);
    const TransportPicture picture(scene, *accelerator, frame, samples.options, samples.filter);
    Sampler sampler = samples.sampler;
    sampler.seed = run.seed;
    sampler.count = run.sized(sampler.count, std::min(sampler.count, 4));
    SampledImage image(size.width, size.height);
    picture.add(image, sampler, {0, sampler.count}, Summand::sample, run.threads);
    return image.mean();
}

Scene scene_named(const std::string& name) {
    return read_scene(source_folder() / "chapters/15_distributed/scenes" / (name + ".toml"));
}

}  // namespace raylab::spread
