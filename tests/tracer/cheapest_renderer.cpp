#include "catch.h"
#include "same_bits.h"

#include "raylab/sampling/sequence.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <array>

using namespace raylab;

namespace {

enum class SceneVariety { plain, any };

// One to eight spheres, near each other and into each other, some the same, seen from outside and from within.
Scene random_spheres(std::uint64_t seed, SceneVariety look) {
    RandomSequence random(seed, 0);
    const auto below = [&](double limit) { return limit * random.next(); };
    const auto any_of = [&](const auto& choices) {
        return choices[static_cast<std::size_t>(below(double(choices.size())))];
    };
    const auto vector = [&](double size) { return random.in_cube() * size; };

    Scene scene;
    scene.image = {21, 15};
    scene.background = {{0.2, 0.3, 0.5}, {0.1, 0.1, 0.2}};
    scene.camera.position = vector(any_of(std::array{0.5, 5.0}));
    scene.camera.target = vector(0.3) + Vec3d{0, 0, 1};
    if (below(4) < 1) scene.camera.projection = Orthographic{3};
    scene.materials = {
        {.ambient = {1, 0.5, 0.2}, .diffuse = Color{0.7, 0.5, 0.2}, .specular = {0.3, 0.3, 0.3}, .shininess = 9},
        {.ambient = {0.1, 0.2, 0.3}, .diffuse = Color{0, 1, 0}},
        {.diffuse = Color{0.1, 0.1, 0.9}, .specular = {0, 0.3, 0}, .shininess = 2, .emission = {0.2, 0, 0}}};
    for (double lights = below(3); lights > 0; --lights)
        scene.lights.push_back({PointLight{vector(any_of(std::array{0.6, 5.0}))}, {below(1), below(1), 1}});
    if (look == SceneVariety::any) {
        scene.materials[1].diffuse = Checker{{1, 0, 0}, {0, 1, 0}, 0.25};
        scene.lights.push_back({.kind = PointLight{vector(4)}, .attenuation = {0.5, 0.1, 0.01}});
        scene.lights.push_back({DistantLight{vector(1)}, {0.5, 0.6, 0.7}});
        scene.lights.push_back(
            {SpotLight{.position = vector(4), .target = vector(0.5), .cone = 20, .exponent = below(2)}});
    }
    for (double spheres = below(2) < 1 ? 1 : below(5); spheres > 0; --spheres) {
        const auto material = [&] { return static_cast<std::size_t>(below(3)); };
        Object object{.shape = Sphere{convert<float>(vector(0.8)), cast<float>(0.2 + below(1))},
                      .front = material(),
                      .back = material(),
                      .sides = any_of(std::array{Sides::both, Sides::both, Sides::front, Sides::back})};
        scene.objects.push_back(object);
        if (below(4) < 1) scene.objects.push_back({.shape = object.shape, .front = material(), .back = material()});
    }
    return scene;
}

WhittedOptions local(WhittedOptions options = {}) {
    options.shadows = WhittedOptions::Shadows::none;
    return options;
}

bool same(const WhittedPicture& a, const WhittedPicture& b) {
    return same_bits(a.image, b.image) && a.rays.primary.cast == b.rays.primary.cast &&
           a.rays.primary.hit == b.rays.primary.hit && a.rays.shadow.cast == b.rays.shadow.cast &&
           a.rays.secondary.cast == b.rays.secondary.cast &&
           a.traversal.primitive_tests == b.traversal.primitive_tests &&
           a.traversal.box_tests == b.traversal.box_tests && a.traversal.exact_decisions == b.traversal.exact_decisions;
}

struct Drawn {
    WhittedPicture picture;
    Image uncounted;
};

Drawn drawn_by(Renderer renderer, const Scene& scene, const Accelerator& accelerator, const WhittedOptions& options,
               const PixelSamples& samples) {
    REQUIRE(cheapest_renderer(scene, options) == renderer);
    const CameraFrame frame = camera_frame(scene.camera, scene.image);
    const EyePictureOptions picture{.samples = samples, .threads = 2};
    return {counted_whitted_picture(scene, accelerator, frame, options, picture),
            whitted_picture(scene, accelerator, frame, options, picture)};
}

// The least renderer's picture, which is checked to be what Whitted's model makes of the scene.
WhittedPicture checked_picture(Renderer smallest, Scene scene, const WhittedOptions& options,
                               const PixelSamples& samples = {}) {
    const auto accelerator = make_accelerator("list", scene);
    const Drawn by_least = drawn_by(smallest, scene, *accelerator, options, samples);
    scene.materials.push_back({.kt = 0.5});  // of a sphere that the list does not know
    scene.objects.push_back({.shape = Sphere{{1000, 0, 0}, 1}, .front = scene.materials.size() - 1});
    const Drawn by_whitted = drawn_by(Renderer::whitted, scene, *accelerator, options, samples);
    CHECK(same(by_least.picture, by_whitted.picture));
    CHECK(same_bits(by_least.picture.image, by_least.uncounted));
    CHECK(same_bits(by_least.uncounted, by_whitted.uncounted));
    return by_least.picture;
}

PixelSamples some_samples(std::uint64_t seed) {
    return seed % 7 == 0 ? PixelSamples{SamplePattern::jittered, 2} : PixelSamples{};
}

}  // namespace

TEST_CASE("local and direct light are the same bits and counts to a renderer that could do more", "[threads]") {
    std::uint64_t hits = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const auto lit = seed % 3 == 0 ? WhittedOptions::Lit::outer_side : WhittedOptions::Lit::viewers_side;
        const auto viewer = seed % 5 == 0 ? WhittedOptions::Viewer::at_infinity : WhittedOptions::Viewer::local;
        const Scene scene = random_spheres(seed, seed % 2 == 0 ? SceneVariety::plain : SceneVariety::any);
        INFO("seed " << seed);
        const auto shadows = seed % 4 == 0 ? WhittedOptions::Shadows::none : WhittedOptions::Shadows::cast;
        const auto smallest = seed % 4 == 0 ? Renderer::local_light : Renderer::direct_light;
        const WhittedOptions options{.viewer = viewer, .lit = lit, .shadows = shadows};
        hits += checked_picture(smallest, scene, options, some_samples(seed)).rays.primary.hit;
    }
    CHECK(hits > 5'000);
}

TEST_CASE("rays that graze spheres, and spheres that lie in each other, are the same to every renderer") {
    Scene scene = random_spheres(1, SceneVariety::plain);
    scene.lights = {{PointLight{{1, 2, 5}}}};
    scene.image = {5, 5};  // through the whole numbers from -2 to 2
    scene.camera = {.position = {0, 0, 9}, .projection = Orthographic{5}};
    scene.objects = {{.shape = Sphere{{0, 0, 0}, 2}, .front = 1}};
    CHECK(checked_picture(Renderer::local_light, scene, local()).rays.primary.hit == 13);  // four graze it
    for (const float radius : {1.0f, 2.0f, 1.0f})
        scene.objects.push_back({.shape = Sphere{{0, 0, 0}, radius}, .front = scene.objects.size() % 3, .back = 1});
    const auto several = checked_picture(Renderer::local_light, scene, local());
    CHECK(several.rays.primary.hit == 13);
    CHECK(several.traversal.exact_decisions > 0);  // which of two that are the same comes first
}

TEST_CASE("a sphere so small that rounding leaves no way from its center is drawn, not refused") {
    Scene scene = random_spheres(1, SceneVariety::plain);
    scene.image = {3, 3};
    scene.camera = {.position = {1, 1, 6}, .target = {1, 1, 1}};
    scene.objects = {{.shape = Sphere{{1, 1, 1}, 1e-30f}}};
    CHECK(checked_picture(Renderer::local_light, scene, local()).rays.primary.hit == 1);
}

TEST_CASE("the renderer is chosen for what the scene has and what is asked of it") {
    const auto chosen = [&](const WhittedOptions& options, const auto& change) {
        Scene scene = random_spheres(2, SceneVariety::plain);
        change(scene);
        return cheapest_renderer(scene, options);
    };
    const auto nothing = [](Scene&) {};
    CHECK(chosen(local(), nothing) == Renderer::local_light);
    CHECK(chosen({}, nothing) == Renderer::direct_light);
    const auto mirror = [](Scene& s) { s.materials[0].kr = 0.5; };
    CHECK(chosen(local(), mirror) == Renderer::whitted);
    CHECK(chosen(local({.depth = 1}), mirror) == Renderer::local_light);
    CHECK(chosen({}, [](Scene& s) { s.materials.push_back({.kr = 0.5, .kt = 0.5}); }) ==
          Renderer::direct_light);  // nothing is made of it
    const auto glass = [](Scene& s) { s.materials[0].kt = 0.5; };
    CHECK(chosen(local({.depth = 1}), glass) ==
          Renderer::whitted);  // through what is hidden in stronger matter, at any depth
}
