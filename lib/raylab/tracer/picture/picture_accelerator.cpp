#include "raylab/tracer/picture/picture_accelerator.h"

#include "raylab/accelerator/light_buffer/light_buffered.h"
#include "raylab/accelerator/on_demand.h"
#include "raylab/scene/needs.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <cmath>
#include <limits>
#include <memory>

namespace raylab {

namespace {

// Fewer primitives are found as fast without: there is little to be saved (chapter 13 has the measurements).
constexpr std::size_t few = 64;

// To draw a triangle, and to keep it, costs as much as bvh8 saves for some 16 eye rays: of the time without, the
// bunny's picture took 1.10 with 6 rays a triangle, 1.09 with 12 and .93 with 25 (one thread, the least of five each).
constexpr double rays_for_one_primitive = 16;

double eye_rays(const CameraFrame& frame, const PixelSamples& samples) {
    return 1.0 * frame.image.width * frame.image.height * samples.count();
}

bool pays(std::size_t primitives, const CameraFrame& frame, const PixelSamples& samples, bool eye_rays_only) {
    if (primitives <= few) return false;
    if (eye_rays_only) return true;  // drawing is less work than any tree
    return eye_rays(frame, samples) >= rays_for_one_primitive * static_cast<double>(primitives);
}

// Up to so many primitives a list is faster (tests/bench/mirror_and_glass.toml: 320 instructions a shadow ray, 520 with
// buffers).
constexpr std::size_t few_to_shadow = 16;

// A light buffer saves a shadow ray some 270 instructions of bvh8's 800 (chapter 08's scene; none of 650 among the
// SPD's balls). To make one costs 13 000 for each primitive, and some 1200 for each cell (counted in both).
constexpr double shadow_rays_for_one_primitive = 52, shadow_rays_for_one_cell = 5;

// Entries a list, from where bvh8 is faster, although shadow rays test few of them, since lists are sorted and shadows
// begin near the light. (Times of those without, one thread: chapter 08's scene .93; SPD with 13 in the mean, balls,
// 1.13, with 41, rings, 1.15, both at 1600 x 1200; with 121, tetra, 2.4, and with 2700, mount, 20, both at 800 x 800.)
constexpr double longest_lists = 8;

LightBufferOptions light_buffer_for(std::size_t primitives) {
    return {.resolution = primitives <= 1000 ? 64 : primitives <= 20'000 ? 128 : 256};
}

// Each light has its own buffer and its own shadow rays, at least about one for each eye ray.
bool light_buffers_pay(std::size_t primitives, const CameraFrame& frame, const PixelSamples& samples) {
    if (primitives <= few_to_shadow) return false;
    const double cells = 6 * std::pow(light_buffer_for(primitives).resolution, 2);
    return eye_rays(frame, samples) >=
           shadow_rays_for_one_primitive * static_cast<double>(primitives) + shadow_rays_for_one_cell * cells;
}

}  // namespace

PictureAccelerator::PictureAccelerator(const std::string& name, const Scene& scene, const CameraFrame& frame,
                                       const WhittedOptions& options, const PixelSamples& samples,
                                       BufferUse item_buffer, BufferUse light_buffers, const BuildOptions& build)
    : name_(chosen_accelerator(name, scene, eye_rays(frame, samples))) {
    const bool shadow_rays = options.shadows == WhittedOptions::Shadows::cast && !scene.lights.empty();
    const bool eye_rays_only = cheapest_renderer(scene, options) == Renderer::local_light;
    const std::size_t primitives = primitive_count(scene);
    const auto chosen = [&](BufferUse use, bool pays) {
        return use == BufferUse::always || (use == BufferUse::where_it_pays && name == "auto" && pays);
    };
    const bool draws = chosen(item_buffer, pays(primitives, frame, samples, eye_rays_only));
    if (draws && eye_rays_only)
        structure_ = std::make_unique<OnDemand>(name_, scene, build);
    else
        structure_ = make_accelerator(name_, scene, build);
    if (shadow_rays && chosen(light_buffers, light_buffers_pay(primitives, frame, samples))) {
        const bool always = light_buffers == BufferUse::always;
        LightBufferOptions buffer = light_buffer_for(primitives);
        buffer.threads = build.threads;
        auto buffered = std::make_unique<LightBuffered>(
            std::move(structure_), scene, buffer, always ? std::numeric_limits<double>::infinity() : longest_lists);
        light_buffers_ = buffered->buffers();
        structure_ = std::move(buffered);
    }
    if (draws) buffer_.emplace(scene, frame, *structure_, build);
}

const Accelerator& PictureAccelerator::finds() const {
    if (buffer_) return *buffer_;
    return *structure_;
}

}  // namespace raylab
