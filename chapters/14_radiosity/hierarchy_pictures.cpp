#include "hierarchy_pictures.h"

#include "raylab/image/color_map.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>

namespace raylab::cornell {

namespace {

// A picture of the patches in colours that are no radiosities.
Image in_colors(const SceneHierarchy& solved, const std::vector<Color>& colors, const Scene& scene, ImageSize size,
                int rays_a_side, const ChapterRun& run) {
    Radiosities shown;
    for (const Color& color : colors) shown.push_back(std::numbers::pi * color);
    const RadiosityView view{*solved.mesh, *solved.visibility, shown, shown};
    return radiosity_picture(view, camera_frame(scene.camera, size), RadiosityShading::patches,
                             {.samples = {.per_side = rays_a_side}, .threads = run.threads});
}

// Darkens the pixels at which one number meets another: the outlines of what the numbers stand for.
void outline(Image& image, const SceneHierarchy& solved, const std::vector<std::uint32_t>& numbers, const Scene& scene,
             const ChapterRun& run) {
    std::vector<Color> colors;
    for (const std::uint32_t number : numbers) colors.emplace_back(number + 1.0);
    const ImageSize size{image.width(), image.height()};
    const Image number_at = in_colors(solved, colors, scene, size, 1, run);
    for (int y = 0; y + 1 < image.height(); ++y)
        for (int x = 0; x + 1 < image.width(); ++x) {
            const auto here = number_at.at(x, y).r;
            if (number_at.at(x + 1, y).r == here && number_at.at(x, y + 1).r == here) continue;
            Pixel& pixel = image.at(x, y);
            pixel = {pixel.r * 0.4f, pixel.g * 0.4f, pixel.b * 0.4f};
        }
}

// The leaf of the floor whose centre is nearest to a place between both boxes and the red wall.
std::size_t beside_the_boxes(const SceneHierarchy& solved) {
    const auto distance = [&](std::size_t patch) {
        const Patch& one = solved.mesh->patches[patch];
        return one.normal.y < 0.99 ? std::numeric_limits<double>::infinity()
                                   : glm::distance(one.center, Vec3d{0.42, 0, 0.16});
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < solved.mesh->patches.size(); ++i)
        if (distance(i) < distance(best)) best = i;
    return best;
}

// The sources of an element's links and of those of all elements above it.
std::vector<std::uint32_t> sources_of(const HierarchicalRadiosity& solved, std::uint32_t element) {
    std::vector<std::uint32_t> sources;
    for (std::uint32_t at = element;; at = solved.elements[at].parent) {
        for (const Link& link : solved.links[at])
            if (link.factor > 0) sources.push_back(link.source);
        if (solved.elements[at].parent == at) return sources;
    }
}

// Of each patch the smallest of these elements that contains it; `none` if there is none.
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
std::vector<std::uint32_t> holders(const SceneHierarchy& solved, const std::vector<std::uint32_t>& elements) {
    std::vector<bool> is_one(solved.solution.elements.size());
    for (const std::uint32_t element : elements) is_one[element] = true;
    std::vector<std::uint32_t> found;
    for (std::uint32_t at : solved.elements) {
        while (!is_one[at] && solved.solution.elements[at].parent != at) at = solved.solution.elements[at].parent;
        found.push_back(is_one[at] ? at : none);
    }
    return found;
}

}  // namespace

SceneHierarchy linked(const Scene& scene, double error, double edge, const ChapterRun& run) {
    return scene_hierarchy(scene, {.edge = edge, .solving = {.error = error, .threads = run.threads}});
}

Image leaves_picture(const SceneHierarchy& solved, const Scene& scene, ImageSize size, const ChapterRun& run) {
    std::vector<Color> radiance;
    for (const Color& radiosity : solved.patches) radiance.push_back(radiosity / std::numbers::pi);
    Image image = in_colors(solved, radiance, scene, size, 2, run);
    outline(image, solved, solved.elements, scene, run);
    return image;
}

Image links_picture(const SceneHierarchy& solved, const Scene& scene, ImageSize size, const ChapterRun& run) {
    constexpr double finest_shown = 4;  // levels of quarters
    const std::size_t leaf = beside_the_boxes(solved);
    const auto held_by = holders(solved, sources_of(solved.solution, solved.elements[leaf]));
    std::vector<Color> colors;
    for (std::size_t i = 0; i < held_by.size(); ++i) {
        const Pixel hot = held_by[i] == none
                              ? Pixel{0.02f, 0.02f, 0.02f}
                              : heat_color(0.3 + 0.6 * solved.solution.elements[held_by[i]].patch.level / finest_shown);
        colors.emplace_back(hot.r, hot.g, hot.b);
    }
    colors[leaf] = Color(1);
    Image image = in_colors(solved, colors, scene, size, 2, run);
    std::vector<std::uint32_t> numbers = held_by;
    numbers[leaf] = static_cast<std::uint32_t>(solved.solution.elements.size());
    outline(image, solved, numbers, scene, run);
    return image;
}

CurveChart link_chart(const Scene& scene, const ChapterRun& run) {
    CurveChart chart{.title = "Links grow no faster than patches; pairs of patches grow with the square",
                     .x_label = "patches",
                     .y_label = "links, or pairs of patches",
                     .x_axis = AxisKind::logarithmic,
                     .y_axis = AxisKind::logarithmic};
    Curve links{.name = "links of the hierarchy"}, pairs{.name = "pairs of as many patches"};
    for (const double edge : run.sized<std::vector<double>>({0.04, 0.02, 0.01, 0.005, 0.0025}, {0.04, 0.02, 0.01})) {
        const SceneHierarchy solved = linked(scene, 0.05, edge, run);
        const auto patches = static_cast<double>(solved.mesh->patches.size());
        links.x.push_back(patches);
        links.y.push_back(static_cast<double>(solved.solution.work.links));
        pairs.x.push_back(patches);
        pairs.y.push_back(patches * (patches - 1));
    }
    chart.curves = {links, pairs};
    return chart;
}

}  // namespace raylab::cornell
