#include "catch.h"
#include "transport/sampled.h"

#include "raylab/sampling/sequence.h"
#include "raylab/transport/path/eye_sample.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::test;

namespace {

// A glossy floor, a light of finite area above, and a wall.
std::string glossy_room(const std::string& polish) {
    return R"(
[image]
width = 6
height = 6
[camera]
position = [0, 1, 3]
target = [0, 0.4, 0]
fov_y = 60
[material.floor]
diffuse = [0.3, 0.3, 0.3]
kr = 0.6
)" + polish +
           R"(
[material.wall]
diffuse = [0.5, 0.5, 0.5]
[material.light]
diffuse = [0, 0, 0]
emission = [4, 4, 4]
[[shape]]
type = "polygon"
vertices = [[-2, 0, -2], [2, 0, -2], [2, 0, 2], [-2, 0, 2]]
material = "floor"
[[shape]]
type = "polygon"
vertices = [[-2, 0, -2], [2, 0, -2], [2, 3, -2], [-2, 3, -2]]
material = "wall"
[[shape]]
type = "sphere"
center = [0.3, 1.5, -1]
radius = 0.4
material = "light"
)";
}

double mean_of(const SampledImage& image) {
    double sum = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) sum += image.at(x, y).color.g / image.at(x, y).count;
    return sum / (image.width() * image.height());
}

}  // namespace

TEST_CASE("points on lights, directions of lobes, and both give the same picture") {
    for (const std::string polish : {"gloss = 5", "gloss = 300", "roughness = 0.5"}) {
        TransportOptions options = paths();
        options.strategy = LightStrategy::both;
        const SampledImage both = Sampled(glossy_room(polish), options).sampled(4096, 2);
        const double truth = mean_of(both);
        for (const LightStrategy strategy : {LightStrategy::lights, LightStrategy::lobes}) {
            options.strategy = strategy;
            const SampledImage one = Sampled(glossy_room(polish), options).sampled(4096, 3);
            double variance = 0;
            for (int y = 0; y < 6; ++y)
                for (int x = 0; x < 6; ++x)
                    variance += (one.variance_of_mean(x, y) + both.variance_of_mean(x, y)) / (36.0 * 36);
            INFO(polish << ": " << mean_of(one) << ", both " << truth << " +- " << std::sqrt(variance));
            CHECK(std::abs(mean_of(one) - truth) <= 4 * std::sqrt(variance));
        }
    }
}

TEST_CASE("where nothing is spread, distributed rays are Whitted's") {
    const Sampled stage(R"(
[camera]
position = [0, 1, 4]
target = [0, 0.5, 0]
[background]
color = [0.1, 0.2, 0.3]
ambient = [0.5, 0.5, 0.5]
[material.mirror]
ambient = [0.2, 0.2, 0.2]
diffuse = [0.3, 0.1, 0.1]
specular = [0.5, 0.5, 0.5]
shininess = 20
kr = 0.7
[material.floor]
ambient = [0.1, 0.1, 0.1]
diffuse = { pattern = "checker", a = [0.9, 0.8, 0.7], b = [0.1, 0.2, 0.3], size = 0.5 }
[[light]]
type = "point"
position = [3, 6, 4]
attenuation = [1, 0.1, 0]
[[light]]
type = "distant"
direction = [0.2, -1, -0.3]
color = [0.3, 0.3, 0.2]
[[shape]]
type = "sphere"
center = [0, 0.7, 0]
radius = 0.7
material = "mirror"
[[shape]]
type = "polygon"
vertices = [[-5, 0, -5], [-5, 0, 5], [5, 0, 5], [5, 0, -5]]
material = "floor"
)",
                        {.depth = 3});
    const Sampler sampler{SamplerKind::random, 64, 5};
    const auto width = static_cast<std::uint64_t>(stage.frame.image.width);
    int hits = 0;
    for (int i = 0; i < 500; ++i) {
        RandomSequence random(3, static_cast<std::uint64_t>(i));
        const int x = random.whole(0, stage.frame.image.width - 1), y = random.whole(0, stage.frame.image.height - 1);
        const SamplePlace place{static_cast<std::uint64_t>(y) * width + static_cast<std::uint64_t>(x), x, y, i % 64};
        const Ray ray = eye_sample(stage.frame, stage.scene.camera, PixelFilter::box, sampler, place).ray;
        Traversal traversal;
        const Color expected = whitted_color(stage.scene, *stage.accelerator, {.depth = 3}, ray, traversal);
        const RayTree tree = stage.picture.tree(sampler, x, y, i % 64);
        CHECK(glm::length(tree.pixel - expected) <= 1e-12);
        hits += tree.nodes.size() > 2;
    }
    CHECK(hits > 100);
}

TEST_CASE("the same bits on any number of threads, and in two pieces as in one", "[threads]") {
    const Sampled room(glossy_room("gloss = 20"), paths());
    const Sampler sampler{SamplerKind::sobol, 16, 1};
    const auto add = [&](SampledImage& image, SampleRange range, int threads) {
        room.picture.add(image, sampler, range, Summand::sample, threads);
    };
    SampledImage one(6, 6), many(6, 6), pieces(6, 6);
    for (const SampleRange range : {SampleRange{0, 8}, {8, 16}}) {
        add(one, range, 1);
        add(many, range, 7);
    }
    CHECK(one.mean().pixels() == many.mean().pixels());
    SampledImage second(6, 6);
    add(pieces, {0, 8}, 1);
    add(second, {8, 16}, 1);
    pieces.add(second);
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 6; ++x) {
            const float whole = one.mean().at(x, y).g, part = pieces.mean().at(x, y).g;
            CHECK(part >= std::nextafter(whole, 0.0f));
            CHECK(part <= std::nextafter(whole, INFINITY));
        }
}

namespace {

// A floor seen from above, 2 m below an area light of radiance 50, and no other light.
std::string below(const std::string& light) {
    return R"(
[image]
width = 8
height = 8
[camera]
type = "orthographic"
position = [0, 1, 0]
target = [0, 0, 0]
up = [0, 0, -1]
height = 1
[material.floor]
diffuse = [0.5, 0.5, 0.5]
[material.light]
diffuse = [0, 0, 0]
emission = [50, 50, 50]
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
)" + light;
}

}  // namespace

TEST_CASE(
    "a light's color is the radiance of a white surface that faces it, and a small area light's is L A / (pi r^2)") {
    const Sampled ball(below(R"(
[[shape]]
type = "sphere"
center = [0, 2, 0]
radius = 0.02
material = "light"
)"),
                       paths());
    const Sampled point(below(R"(
[[light]]
type = "point"
position = [0, 2, 0]
color = [0.02, 0.02, 0.02]
attenuation = [0, 0, 1]
)"));
    // 50 times the area pi 0.02^2 of its disk, over pi.
    CHECK(50 * 0.02 * 0.02 == Approx(0.02));
    CHECK(mean_of(ball.sampled(64)) == Approx(mean_of(point.sampled(64))).epsilon(1e-3));
    const Sampled facing(below(R"(
[[light]]
type = "distant"
direction = [0, -1, 0]
color = [0.7, 0.7, 0.7]
)"));
    CHECK(mean_of(facing.sampled(4)) == Approx(0.5 * 0.7));
}
