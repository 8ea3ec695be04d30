#include "spread_picture.h"

#include "raylab/image/color_map.h"
#include "raylab/report/provenance.h"
#include "raylab/scene/read_scene.h"
#include "raylab/transport/path/adaptive_counts.h"

#include <algorithm>
#include <cmath>

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

Image sample_counts(const Scene& scene, ImageSize size, const ChapterRun& run) {
    constexpr int mean = 32, fewest = 4;
    const CameraFrame frame = camera_frame(scene.camera, size, scene.source);
    const auto accelerator = make_accelerator("auto", scene);
    const TransportPicture picture(scene, *accelerator, frame, {});
    SampledImage first(size.width, size.height);
    picture.add(first, {SamplerKind::sobol, 8, run.seed}, {0, 8}, Summand::sample, run.threads);
    const std::vector<int> counts = adaptive_counts(first, mean, fewest);
    Image image(size.width, size.height);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const int count = counts[static_cast<std::size_t>(y * size.width + x)];
            image.at(x, y) = heat_color(std::min(1.0, std::log2(count / double{fewest}) / 5));
        }
    return image;
}

Scene scene_named(const std::string& name) {
    return read_scene(source_folder() / "chapters/15_distributed/scenes" / (name + ".toml"));
}

}  // namespace raylab::spread
