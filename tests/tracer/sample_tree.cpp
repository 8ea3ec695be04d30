#include "catch.h"
#include "tracer/random_scene.h"

#include "raylab/tracer/picture/only_needed.h"
#include "raylab/tracer/picture/picture_accelerator.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <cstring>

using namespace raylab;
using raylab::test::random_scene;

namespace {

/// One way to ask for a picture: each differs from the first in something that changes a ray, or what finds its hits.
struct Asked {
    std::string accelerator = "auto";
    WhittedOptions options = {};
    PixelSamples samples = {};
    BufferUse item_buffer = BufferUse::where_it_pays, light_buffers = BufferUse::never;
};

std::vector<Asked> all_ways() {
    std::vector<Asked> ways{
        {},
        {.options = {.depth = 2}},
        {.options = {.depth = 12, .threshold = 0.05}},
        {.options = {.reflectance = WhittedOptions::Reflectance::fresnel}},
        {.options = {.viewer = WhittedOptions::Viewer::at_infinity}},
        {.options = {.threshold = -1, .lit = WhittedOptions::Lit::outer_side}},
        {.options = {.shadows = WhittedOptions::Shadows::none}},
        {.options = {.start = ray_start_from_words("none")}},
        {.options = {.start = ray_start_from_words("fixed:0.01")}},
        {.options = {.start = ray_start_from_words("scaled:1e-5")}},
        {.samples = {SamplePattern::jittered, 2}},
        {.samples = {SamplePattern::random, 3, 7}},
        {.samples = {SamplePattern::corner, 1}},
        {.item_buffer = BufferUse::always},
        {.light_buffers = BufferUse::always},
    };
    for (const std::string& name : accelerator_names()) ways.push_back({.accelerator = name});
    return ways;
}

// The samples' trees, added and divided in the picture's order, and rounded as it rounds.
Pixel pixel_of_trees(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame, const Asked& asked,
                     int x, int y) {
    Color sum{0, 0, 0};
    for (int i = 0; i < asked.samples.count(); ++i)
        sum += sample_tree(scene, accelerator, frame, asked.options, asked.samples, {x, y, i}).pixel;
    return to_pixel(sum / static_cast<double>(asked.samples.count()));
}

}  // namespace

TEST_CASE("the trees of a pixel's samples make the picture's pixel, to the bit, however it is asked for") {
    const auto ways = all_ways();
    int pixels = 0, branched = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed)
        for (std::size_t way = 0; way < ways.size(); ++way) {
            Asked asked = ways[way];
            Scene scene = random_scene(seed);
            scene.image = {10, 10};
            if (way % 2 == 0) {  // as `render` does
                scene = with_lights(scene, seen_lights(scene, asked.options));
                asked.options = only_needed(scene, asked.options);
            }
            const CameraFrame frame = camera_frame(scene.camera, scene.image);
            const PictureAccelerator accelerator(asked.accelerator, scene, frame, asked.options, asked.samples,
                                                 asked.item_buffer, asked.light_buffers);
            const Image image = whitted_picture(scene, accelerator.finds(), frame, asked.options,
                                                {.samples = asked.samples, .threads = 1});
            INFO("seed " << seed << ", way " << way);
            int different = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x, ++pixels) {
                    const Pixel by_trees = pixel_of_trees(scene, accelerator.finds(), frame, asked, x, y);
                    different += std::memcmp(&image.at(x, y), &by_trees, sizeof(Pixel)) != 0;
                }
            CHECK(different == 0);
            branched +=
                sample_tree(scene, accelerator.finds(), frame, asked.options, asked.samples, {5, 5}).nodes.size() > 3;
        }
    CHECK(pixels == 50 * 100 * static_cast<int>(ways.size()));
    CHECK(branched > 100);
}
