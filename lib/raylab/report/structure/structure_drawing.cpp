#include "raylab/report/structure/structure_drawing.h"

#include "raylab/report/plane/plane_frame.h"
#include "raylab/report/structure/bound.h"
#include "raylab/report/structure/structure_canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <span>

namespace raylab {

namespace {

constexpr const char *ink_of_leaves = "#0072b2", *ink_of_ray = "#d55e00";

std::set<std::uint32_t> places_tested(const Outline& outline, const std::vector<Visit>& visits) {
    std::set<std::uint32_t> places;
    for (const Outline::Node& node : outline.nodes) {
        if (node.primitives.empty()) continue;
        const bool tested = std::ranges::any_of(visits, [&](const Visit& visit) {
            return visit.kind == Visit::Kind::leaf && visit.tests > 0 && same(visit.bound, node.bound);
        });
        if (tested) places.insert(node.primitives.begin(), node.primitives.end());
    }
    return places;
}

PlaneStyle style_of(Visit::Kind kind) {
    if (kind == Visit::Kind::inner) return {.line = "#8a8a92", .width = 1.2, .dash = PlaneStyle::Dash::dashed};
    if (kind == Visit::Kind::empty)
        return {.line = "#4a9cc8", .fill = "#eaf4fb", .width = 1.2, .dash = PlaneStyle::Dash::dotted};
    return {.line = ink_of_leaves, .fill = "#fdecc8", .width = 1.5};
}

// By this a page's script steps through the visits (page/script/visits.js).
PlaneDrawing::Data data_of_visit(std::size_t number) { return {{"visit", std::to_string(number)}}; }

// Places the numbers of visits. A number stands beside the middle of the ray's way through the cell; where cells are
// small it is on the other side or farther away, so that no number covers another. Inner nodes have no number.
class VisitNumbers {
public:
    VisitNumbers(StructureCanvas& canvas, const Ray& ray, double end)
        : canvas_(canvas), frame_(canvas.drawing), ray_(ray), end_(end) {
        const PlanePoint way = canvas.view.at(convert<double>(ray.direction));
        const double length = std::max(std::hypot(way.x, way.y), 1e-30) * (way.x < 0 ? -1 : 1);
        upward_ = {-way.y / length, -way.x / length};
        if (std::isfinite(end)) taken_.push_back({frame_.at(at(end)), letter / 2});  // the dot of the hit
    }

    void add(const Visit& visit, std::size_t number) {
        const auto span = span_inside(ray_, visit.bound);
        if (!span || visit.kind == Visit::Kind::inner) return;
        const double t = (span->min + std::max(span->min, std::min(span->max, end_))) / 2;
        const std::string words = std::to_string(number);
        const double half_width = 0.45 * letter * static_cast<double>(words.size());
        const Point2 middle = frame_.at(at(t)), aside = free_place(middle, half_width);
        taken_.push_back({{middle.x + aside.x, middle.y + aside.y}, half_width});
        canvas_.drawing.marks.push_back(PlaneDrawing::Text{.at = at(t),
                                                           .words = words,
                                                           .height = letter,
                                                           .color = "#000000",
                                                           .anchor = Anchor::center,
                                                           .aside = {aside.x, letter / 2 + aside.y},
                                                           .halo = "#ffffff",
                                                           .data = data_of_visit(number)});
    }

private:
    static constexpr double letter = 12;  // in pixels: also in a drawing that is shown at two thirds of its size

    struct Place {
        Point2 middle;
        double half_width;
    };

    PlanePoint at(double t) const {
        return canvas_.view.at(convert<double>(ray_.origin) + convert<double>(ray_.direction) * t);
    }

    // The offset from there, in pixels, with y downward.
    Point2 free_place(Point2 middle, double half_width) const {
        constexpr std::array away{14.0, -14.0, 28.0, -28.0, 42.0, -42.0};
        for (const double distance : away) {
            const Point2 aside{distance * upward_.x, distance * upward_.y};
            const bool is_free = std::ranges::none_of(taken_, [&](const Place& other) {
                return std::abs(middle.x + aside.x - other.middle.x) < half_width + other.half_width + 1 &&
                       std::abs(middle.y + aside.y - other.middle.y) < letter + 1;
            });
            if (is_free) return aside;
        }
        return {away.front() * upward_.x, away.front() * upward_.y};
    }

    StructureCanvas& canvas_;
    PlaneFrame frame_;
    const Ray& ray_;
    double end_;
    Point2 upward_;  // perpendicular to the ray, of unit length
    std::vector<Place> taken_;
};

// Draws the cells that the ray does not visit, where there are few enough to be visible.
void draw_others(StructureCanvas& canvas, const Outline& outline) {
    constexpr std::size_t largest = 1500;
    if (outline.nodes.size() > largest) return;
    for (const Outline::Node& node : outline.nodes)
        if (node.children.empty()) canvas.figure(canvas.view.figure(node.bound), {.line = "#d8d8de", .width = 0.8});
}

void draw_ray(StructureCanvas& canvas, const Ray& ray, const std::optional<Hit>& hit) {
    const auto inside = span_inside(ray, canvas.view.shown());
    if (!inside) return;
    const auto at = [&](double t) {
        return canvas.view.at(convert<double>(ray.origin) + convert<double>(ray.direction) * t);
    };
    const double end = hit ? hit->t : inside->max;
    canvas.drawing.marks.push_back(PlaneDrawing::Arrow{at(inside->min), at(end), {.line = ink_of_ray, .width = 2.2}});
    if (hit) canvas.drawing.marks.push_back(PlaneDrawing::Dot{at(end), 4.5, "#000000"});
}

std::string leaf_color(std::size_t primitives, std::size_t largest) {  // from white to a medium blue
    const double share = largest > 0 ? static_cast<double>(primitives) / static_cast<double>(largest) : 0;
    const auto mix = [&](int full) { return static_cast<int>(255 + (full - 255) * (0.12 + 0.6 * share)); };
    return fmt::format("#{:02x}{:02x}{:02x}", mix(0x00), mix(0x72), mix(0xb2));
}

std::string counted(std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

// Draws the leaves, the larger ones below, so that none hides another where they overlap in the projection; empty ones
// are not filled.
void draw_leaves(StructureCanvas& canvas, const Outline& outline) {
    struct Leaf {
        const Outline::Node* node;
        double area;
    };
    std::vector<Leaf> leaves;
    std::size_t largest = 0;
    for (const Outline::Node& node : outline.nodes) {
        largest = std::max(largest, node.primitives.size());
        if (node.children.empty()) leaves.push_back({&node, surface_area(box_about(node.bound))});
    }
    std::ranges::stable_sort(leaves, std::greater<>(), &Leaf::area);
    for (const Leaf& leaf : leaves) {
        const std::size_t count = leaf.node->primitives.size();
        canvas.figure(canvas.view.figure(leaf.node->bound),
                      {.line = ink_of_leaves, .fill = count > 0 ? leaf_color(count, largest) : "", .width = 1},
                      counted(count, "primitive") + " " + leaf.node->label);
    }
    const bool is_tree = outline.nodes.size() != leaves.size() + 1;  // a grid is a root and its cells
    canvas.drawing.notes.push_back(
        (is_tree ? fmt::format("{}, {} of them leaves", counted(outline.nodes.size(), "node"), leaves.size())
                 : counted(leaves.size(), "cell")) +
        fmt::format("; the darker, the more primitives (at most {})", largest));
}

}  // namespace

PlaneDrawing draw_structure(const Scene& scene, const Outline& outline, const StructureView& view) {
    std::vector<Bound> bounds;
    for (const auto& node : outline.nodes) bounds.push_back(node.bound);
    StructureCanvas canvas = empty_canvas(scene, view, bounds, nullptr);
    draw_leaves(canvas, outline);
    for (const auto& node : outline.nodes)
        if (!node.children.empty())
            canvas.figure(canvas.view.figure(node.bound),
                          {.line = "#8a8a92", .width = 1, .dash = PlaneStyle::Dash::dashed}, node.label);
    draw_shapes(canvas, scene, view, {});
    return canvas.drawing;
}

PlaneDrawing draw_ray_through(const Scene& scene, const Accelerator& structure, const Ray& ray,
                              const StructureView& view) {
    const auto visits = structure.visits(ray);
    std::vector<Bound> bounds;
    for (const Visit& visit : visits) bounds.push_back(visit.bound);
    StructureCanvas canvas = empty_canvas(scene, view, bounds, &ray);
    const Outline outline = structure.outline();
    Traversal traversal;
    const auto hit = structure.closest(ray, traversal);
    draw_others(canvas, outline);
    for (std::size_t i = 0; i < visits.size(); ++i)
        canvas.figure(canvas.view.figure(visits[i].bound), style_of(visits[i].kind),
                      words(visits[i].bound) + ", " + counted(visits[i].tests, "test"), data_of_visit(i + 1));
    draw_shapes(canvas, scene, view, places_tested(outline, visits));
    draw_ray(canvas, ray, hit);
    const double end = hit ? hit->t : std::numeric_limits<double>::infinity();
    VisitNumbers numbers(canvas, ray, end);
    for (std::size_t i = 0; i < std::min(visits.size(), view.max_numbers); ++i) numbers.add(visits[i], i + 1);
    canvas.drawing.notes.push_back(counted(visits.size(), "visit") + " in the order of their numbers, " +
                                   counted(traversal.primitive_tests, "primitive test"));
    canvas.drawing.notes.push_back("solid: with tests; dotted: empty; dashed: inner node; bold: what was tested");
    return canvas.drawing;
}

}  // namespace raylab
