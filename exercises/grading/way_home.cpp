#include "way_home.h"

#include "compiling.h"
#include "traced_numbers.h"

#include "raylab/image/to_pixel.h"

#include <algorithm>

namespace raylab::grading {

namespace {

Program tracer_in(const Workplace& workplace) {
    constexpr Allowed tracing{Work::load_and_answer, 5};  // the reference takes a tenth of a second
    return {workplace.isolated(), tracing, workplace.tracer(), traced_inputs, traced_outputs};
}

std::vector<double> every_pixel() {
    std::vector<double> inputs;
    for (int y = 0; y < traced_size.height; ++y)
        for (int x = 0; x < traced_size.width; ++x) inputs.insert(inputs.end(), {1.0 * x, 1.0 * y, 0});
    return inputs;
}

Image picture(const auto& color_of) {
    Image image(traced_size.width, traced_size.height);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) image.at(x, y) = to_pixel(color_of(x, y));
    return image;
}

std::size_t pixel_number(int x, int y) {
    return static_cast<std::size_t>(y) * traced_size.width + static_cast<std::size_t>(x);
}

struct At {
    int x, y;
};

// two right functions differ in a pixel's last bits
constexpr double rounding = 1e-6;

std::optional<At> worst_pixel(const Comparison& comparison) {
    if (comparison.non_finite) return At{comparison.non_finite->x, comparison.non_finite->y};
    if (comparison.worst.empty() || comparison.worst[0].error <= rounding) return std::nullopt;
    return At{comparison.worst[0].x, comparison.worst[0].y};
}

// The pictures may be equal although the rays are not: there may be one too many, or one instead of another.
std::optional<At> first_with_other_rays(const auto& nodes_of, const TracedScene& traced) {
    for (int y = 0; y < traced_size.height; ++y)
        for (int x = 0; x < traced_size.width; ++x)
            if (nodes_of(x, y) != traced.tree(x, y).nodes.size()) return At{x, y};
    return std::nullopt;
}

// The same pixel's whole tree, requested from the student's process node by node.
std::optional<RayTree> student_tree(const Workplace& workplace, const TracedScene& traced, At at,
                                    std::span<const double> first) {
    std::vector<double> inputs;
    for (std::size_t node = 0; node < traced_nodes_of(first); ++node)
        inputs.insert(inputs.end(), {1.0 * at.x, 1.0 * at.y, static_cast<double>(node)});
    const auto answers = run(tracer_in(workplace), inputs);
    if (answers.end != Answers::End::complete) return std::nullopt;
    return traced_tree(traced, answers.values);
}

}  // namespace

WayHomeFound find_way_home(const Exercise& exercise, const Workplace& workplace) {
    link_tracer(exercise, workplace);
    WayHomeFound found{.answers = run(tracer_in(workplace), every_pixel())};
    if (found.answers.end != Answers::End::complete) return found;
    const std::span<const double> numbers = found.answers.values;
    const auto of = [&](int x, int y) { return numbers.subspan(pixel_number(x, y) * traced_outputs, traced_outputs); };
    const auto traced = traced_scene();
    WayHome way{.yours = picture([&](int x, int y) { return traced_color_of(of(x, y)); }),
                .reference = picture([&](int x, int y) { return traced.tree(x, y).pixel; }),
                .comparison = {}};
    way.comparison = compare(way.yours, way.reference);
    auto at = worst_pixel(way.comparison);
    way.pictures_differ = at.has_value();
    if (!at) at = first_with_other_rays([&](int x, int y) { return traced_nodes_of(of(x, y)); }, traced);
    if (at) {
        if (auto yours = student_tree(workplace, traced, *at, of(at->x, at->y))) {
            RayTree truth = traced.tree(at->x, at->y);
            auto difference = first_difference(*yours, truth);
            way.worst = WayHome::Pixel{at->x, at->y, *std::move(yours), std::move(truth), std::move(difference)};
        }
    }
    found.way = std::move(way);
    return found;
}

}  // namespace raylab::grading
