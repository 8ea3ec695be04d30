#include "pictures.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/scene/nff/read_nff.h"
#include "raylab/scene/nff/spd_sides.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <fmt/format.h>

namespace raylab::shadows {

namespace {

// A sphere with nine spheres of a third of its radius that touch it: six about its equator, three above, none at the
// point by which it is attached.
void add_sphere(std::string& text, const Vec3d& center, double radius, const Vec3d& up, int levels) {
    text += fmt::format("s {:.9g} {:.9g} {:.9g} {:.9g}\n", center.x, center.y, center.z, radius);
    if (levels == 0) return;
    const Vec3d aside = glm::normalize(cross(up, std::abs(up.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
    const Vec3d along = cross(up, aside);
    // cos and sin of multiples of 60 degrees, and of angles 30 degrees further, without std::sin, which differs between
    // machines
    const double half = 0.5, high = std::sqrt(0.75);
    const Vec3d waist[] = {aside,  aside * half + along * high,  along * high - aside * half,
                           -aside, -aside * half - along * high, aside * half - along * high};
    const Vec3d above[] = {aside * high + along * half, -aside * high + along * half, -along};
    const auto add = [&](const Vec3d& direction) {
        add_sphere(text, center + direction * (radius * 4 / 3), radius / 3, direction, levels - 1);
    };
    for (const Vec3d& direction : waist) add(direction);
    for (const Vec3d& direction : above) add(glm::normalize(direction * 0.6 + up * 0.8));
}

WhittedPicture traced(const RayStart& start, const ChapterRun& run) {
    const Scene scene = with_spd_sides(read_nff(flake_nff(3), "flake"));
    const auto accelerator = make_accelerator("auto", scene);
    WhittedOptions options{.start = start};
    options.threshold = -1;  // every ray is followed to the depth
    options.lit = WhittedOptions::Lit::outer_side;
    return counted_whitted_picture(scene, *accelerator, camera_frame(scene.camera, scene.image, scene.source), options,
                                   {.threads = run.threads, .label = "rays"});
}

std::string grouped(std::uint64_t count) {
    std::string digits = std::to_string(count);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), " ");
    return digits;
}

}  // namespace

std::string flake_nff(int levels) {
    std::string text =
        "v\nfrom 2.1 1.3 1.7\nat 0 0 0\nup 0 0 1\nangle 45\nhither 1\nresolution 256 256\nb 0.078 0.361 0.753\nl 4 "
        "3 2\nl 1 -4 4\nl -3 1 5\nf 1 0.75 0.33 1 0 0 0 0\np 4\n12 12 -0.5\n-12 12 -0.5\n-12 -12 -0.5\n12 -12 "
        "-0.5\nf 1 0.9 0.7 0.5 0.5 3 0 0\n";
    add_sphere(text, {0, 0, 0}, 0.5, {0, 0, 1}, levels);
    return text;
}

std::vector<std::string> flake_header() {
    return {"rays start", "shadow rays", "... blocked", "secondary rays", "... that hit"};
}

std::vector<std::vector<std::string>> flake_rows(const ChapterRun& run) {
    std::vector<std::vector<std::string>> rows;
    for (const std::string how : {"error_bounded", "fixed:0.001", "fixed:0.01", "fixed:0.1"}) {
        const RayCounts rays = traced(ray_start_from_words(how), run).rays;
        rows.push_back({how, grouped(rays.shadow.cast), grouped(rays.shadow.hit), grouped(rays.secondary.cast),
                        grouped(rays.secondary.hit)});
    }
    return rows;
}

}  // namespace raylab::shadows
