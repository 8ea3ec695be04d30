#include "catch.h"

#include "raylab/sampling/random.h"
#include "raylab/tracer/whitted_picture.h"

#include <array>
#include <cstring>

using namespace raylab;

namespace {

// A list that does not say so: who asks it takes it for any structure.
class Disguised final : public Accelerator {
public:
    explicit Disguised(const Scene& scene) : list_(make_accelerator("list", scene)) {}

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override { return list_->closest(ray, traversal); }
    bool occluded(const Ray& ray, Traversal& traversal) const override { return list_->occluded(ray, traversal); }
    std::size_t bytes() const override { return list_->bytes(); }

private:
    std::unique_ptr<Accelerator> list_;
};

// Two to five spheres, near each other and into each other, some the same, seen from outside and from within.
Scene random_spheres(std::uint64_t seed) {
    std::uint64_t drawn = 0;
    const auto below = [&](double limit) { return limit * random_number({.seed = seed, .dimension = drawn++}); };
    const auto any_of = [&](const auto& choices) { return choices[static_cast<std::size_t>(below(double(choices.size())))]; };
    const auto vector = [&](double size) { return Vec3d(below(2) - 1, below(2) - 1, below(2) - 1) * size; };

    Scene scene;
    scene.image = {21, 15};
    scene.background = {{0.2, 0.3, 0.5}, {0.1, 0.1, 0.2}};
    scene.camera.position = vector(any_of(std::array{0.5, 5.0}));
    scene.camera.target = vector(0.3) + Vec3d{0, 0, 1};
    if (below(4) < 1) scene.camera.projection = Orthographic{3};
    scene.materials = {{.ambient = {1, 0.5, 0.2}, .diffuse = Color{0.7, 0.5, 0.2}, .specular = {0.3, 0.3, 0.3}, .shininess = 9},
                       {.ambient = {0.1, 0.2, 0.3}, .diffuse = Checker{{1, 0, 0}, {0, 1, 0}, 0.25}},
                       {.diffuse = Color{0.1, 0.1, 0.9}, .specular = {0, 0.3, 0}, .shininess = 2, .emission = {0.2, 0, 0}}};
    for (double lights = below(3); lights > 0; --lights)
        scene.lights.push_back({.kind = PointLight{vector(any_of(std::array{0.6, 5.0}))},
                                .attenuation = any_of(std::array{Vec3d{1, 0, 0}, Vec3d{0.5, 0.1, 0.01}})});
    if (below(2) < 1) scene.lights.push_back({DistantLight{vector(1)}, {0.5, 0.6, 0.7}});
    if (below(2) < 1)
        scene.lights.push_back({SpotLight{.position = vector(4), .target = vector(0.5), .cone = 20, .exponent = below(2)}});
    for (double spheres = 1 + below(4); spheres > 0; --spheres) {
        const auto material = [&] { return static_cast<std::size_t>(below(3)); };
        Object object{.shape = Sphere{convert<float>(vector(0.8)), cast<float>(0.2 + below(1))},
                      .front = material(),
                      .back = material(),
                      .sides = any_of(std::array{Sides::both, Sides::both, Sides::front, Sides::back})};
        scene.objects.push_back(object);
        if (below(3) < 1) scene.objects.push_back({.shape = object.shape, .front = material(), .back = material()});
    }
    return scene;
}

WhittedOptions local(WhittedOptions options = {}) {
    options.shadows = WhittedOptions::Shadows::none;
    return options;
}

bool same_bits(const Image& a, const Image& b) {
    bool same = true;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) same = same && std::memcmp(&a.at(x, y), &b.at(x, y), sizeof(Pixel)) == 0;
    return same;
}

bool same(const WhittedPicture& a, const WhittedPicture& b) {
    return same_bits(a.image, b.image) && a.rays.primary.cast == b.rays.primary.cast &&
           a.rays.primary.hit == b.rays.primary.hit && a.rays.shadow.cast == b.rays.shadow.cast &&
           a.rays.secondary.cast == b.rays.secondary.cast && a.traversal.primitive_tests == b.traversal.primitive_tests &&
           a.traversal.box_tests == b.traversal.box_tests && a.traversal.exact_decisions == b.traversal.exact_decisions;
}

// All renderers draw the scene.
struct Drawn {
    WhittedPicture spheres, local_light, whitted;
    Image uncounted;
};

Drawn drawn(Scene scene, const WhittedOptions& options, const PixelSamples& samples = {}) {
    const CameraFrame frame = camera_frame(scene.camera, scene.image);
    const EyePictureOptions picture{.samples = samples, .threads = 2};
    const auto list = make_accelerator("list", scene);
    const Disguised disguised(scene);
    REQUIRE(least_renderer(scene, *list, options) == Renderer::local_light_on_spheres);
    REQUIRE(least_renderer(scene, disguised, options) == Renderer::local_light);
    Drawn all{.spheres = counted_whitted_picture(scene, *list, frame, options, picture),
              .local_light = counted_whitted_picture(scene, disguised, frame, options, picture),
              .whitted = {},
              .uncounted = whitted_picture(scene, *list, frame, options, picture)};
    scene.materials.push_back({.kt = 0.5});  // nothing is made of it
    REQUIRE(least_renderer(scene, disguised, options) == Renderer::whitted);
    all.whitted = counted_whitted_picture(scene, disguised, frame, options, picture);
    return all;
}

}  // namespace

TEST_CASE("the least renderer and those that can do more draw spheres with the same bits and counts") {
    std::uint64_t hits = 0;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        const Scene scene = random_spheres(seed);
        const auto lit = seed % 3 == 0 ? WhittedOptions::Lit::outer_side : WhittedOptions::Lit::viewers_side;
        const auto viewer = seed % 5 == 0 ? WhittedOptions::Viewer::at_infinity : WhittedOptions::Viewer::local;
        const PixelSamples samples = seed % 7 == 0 ? PixelSamples{SamplePattern::jittered, 2} : PixelSamples{};
        const Drawn by = drawn(scene, local({.viewer = viewer, .lit = lit}), samples);
        INFO("seed " << seed);
        CHECK(same(by.spheres, by.local_light));
        CHECK(same(by.spheres, by.whitted));
        CHECK(same_bits(by.spheres.image, by.uncounted));
        hits += by.spheres.rays.primary.hit;
    }
    CHECK(hits > 10'000);
}

TEST_CASE("rays that graze spheres, and spheres that lie in each other, are the same to every renderer") {
    Scene scene = random_spheres(1);
    scene.image = {5, 5};  // through the whole numbers from -2 to 2
    scene.camera = {.position = {0, 0, 9}, .projection = Orthographic{5}};
    scene.objects.clear();
    for (const float radius : {1.0f, 2.0f, 1.0f, 2.0f})
        scene.objects.push_back({.shape = Sphere{{0, 0, 0}, radius}, .front = scene.objects.size() % 3, .back = 1});
    const Drawn by = drawn(scene, local());
    CHECK(by.spheres.rays.primary.hit == 13);  // grazing ones among them
    CHECK(by.spheres.traversal.exact_decisions > 0);
    CHECK(same(by.spheres, by.local_light));
    CHECK(same(by.spheres, by.whitted));
}

TEST_CASE("the renderer is chosen for what the scene has and what is asked of it") {
    Scene scene = random_spheres(2);
    const auto list = make_accelerator("list", scene);
    const auto chosen = [&](const WhittedOptions& options) { return least_renderer(scene, *list, options); };
    CHECK(chosen(local()) == Renderer::local_light_on_spheres);
    CHECK(chosen({}) == Renderer::whitted);  // feelers
    scene.materials[0].kr = 0.5;
    CHECK(chosen(local()) == Renderer::whitted);
    CHECK(chosen(local({.depth = 1})) == Renderer::local_light_on_spheres);
    scene.materials[0].kt = 0.5;
    CHECK(chosen(local({.depth = 1})) == Renderer::whitted);  // through surfaces within stronger matter at any depth
    scene.materials[0].kr = scene.materials[0].kt = 0;
    scene.objects.back().placement.columns[0].x = 2;
    CHECK(chosen(local()) == Renderer::local_light);
    scene.objects.back() = {.shape = Disk{{0, 0, 0}, {0, 0, 1}, 1}};
    CHECK(chosen(local()) == Renderer::local_light);
    scene.objects.clear();
    CHECK(chosen(local()) == Renderer::local_light);
}
