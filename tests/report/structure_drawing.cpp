#include "raylab/report/structure/structure_drawing.h"

#include "catch.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/structure/structure_workload.h"
#include "raylab/image/color.h"
#include "raylab/report/plane/plane_frame.h"
#include "raylab/report/plane/plane_view.h"
#include "raylab/report/structure/bound.h"
#include "raylab/report/structure/structure_diagram.h"

#include <numbers>

using namespace raylab;

namespace {

// Unit cells side by side along x, with a sphere in the first and the third.
class Row final : public Accelerator {
public:
    explicit Row(const Scene& scene) : list_(make_accelerator("list", scene)) {
        outline_.nodes.push_back({.bound = Box{{0, 0, 0}, {4, 1, 1}}, .label = "root"});
        for (std::uint32_t i = 0; i < 4; ++i) {
            outline_.nodes[0].children.push_back(i + 1);
            const float x = cast<float>(i);
            outline_.nodes.push_back({.bound = Box{{x, 0, 0}, {x + 1, 1, 1}}});
            if (i % 2 == 0) outline_.nodes.back().primitives = {i / 2};
        }
    }
    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override {
        return list_->closest(ray, traversal);
    }
    bool occluded(const Ray& ray, Traversal& traversal) const override { return list_->occluded(ray, traversal); }
    std::size_t bytes() const override { return 0; }
    Outline outline() const override { return outline_; }
    std::vector<Visit> visits(const Ray&) const override {
        std::vector<Visit> visits{{outline_.nodes[0].bound, Visit::Kind::inner}};
        for (std::size_t i = 1; i < 4; ++i) {
            const auto& node = outline_.nodes[i];
            visits.push_back(
                {node.bound, node.primitives.empty() ? Visit::Kind::empty : Visit::Kind::leaf, node.primitives.size()});
        }
        return visits;
    }

private:
    std::unique_ptr<Accelerator> list_;
    Outline outline_;
};

Scene two_balls() {
    Scene scene;
    scene.objects.push_back({.shape = Sphere{{0.5f, 0.2f, 0.5f}, 0.2f}});
    scene.objects.push_back({.shape = Sphere{{2.5f, 0.5f, 0.5f}, 0.4f}});
    return scene;
}

const Ray along_row{{-1, 0.7f, 0.5f}, {1, 0, 0}};

template <class Mark>
std::vector<Mark> marks(const PlaneDrawing& drawing) {
    std::vector<Mark> found;
    for (const auto& mark : drawing.marks)
        if (const auto* one = std::get_if<Mark>(&mark)) found.push_back(*one);
    return found;
}

std::size_t figures_of(const PlaneDrawing& drawing, double width) {
    const auto all = marks<PlaneDrawing::Figure>(drawing);
    return static_cast<std::size_t>(
        std::ranges::count_if(all, [&](const auto& one) { return one.style.width == width; }));
}

const PlanePolygon& polygon(const std::optional<PlaneFigure>& figure) { return std::get<PlanePolygon>(figure.value()); }

double area(const PlanePolygon& figure) {
    double twice = 0;
    for (std::size_t i = 0; i < figure.corners.size(); ++i) {
        const auto a = figure.corners[i], b = figure.corners[(i + 1) % figure.corners.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

constexpr Box wide{Vec3f(-10), Vec3f(10)};

}  // namespace

TEST_CASE("a ray's visits are numbered in their order, and its tested primitives are bold") {
    const Scene scene = two_balls();
    const auto drawing = draw_ray_through(scene, Row(scene), along_row, {.title = "row"});
    std::string numbers;
    for (const auto& text : marks<PlaneDrawing::Text>(drawing)) numbers += text.words + " ";
    CHECK(numbers == "2 3 4 ");            // 1 is the root
    CHECK(figures_of(drawing, 2.5) == 2);  // both balls are in cells with tests
    REQUIRE(marks<PlaneDrawing::Dot>(drawing).size() == 1);
    CHECK_THAT(marks<PlaneDrawing::Dot>(drawing)[0].at.x, WithinAbs(2.5 - std::sqrt(0.16 - 0.04), 1e-6));
}

TEST_CASE("where cells are small, their numbers stand apart and off the hit") {
    const Scene scene = two_balls();
    const auto drawing = draw_ray_through(scene, Row(scene), along_row, {.width = 60, .height = 60});
    std::vector<Point2> middles;
    for (const auto& text : marks<PlaneDrawing::Text>(drawing)) {
        const Point2 at = PlaneFrame(drawing).at(text.at);
        middles.push_back({at.x + text.aside.x, at.y + text.aside.y - text.height / 2});
    }
    middles.push_back(PlaneFrame(drawing).at(marks<PlaneDrawing::Dot>(drawing)[0].at));
    for (std::size_t i = 0; i < middles.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            CHECK((std::abs(middles[i].x - middles[k].x) > 7 || std::abs(middles[i].y - middles[k].y) > 9));
}

TEST_CASE("a grid has cells, a tree has nodes and leaves") {
    const Scene scene = two_balls();
    CHECK(draw_structure(scene, Row(scene).outline(), {}).notes.at(0) ==
          "4 cells; the darker, the more primitives (at most 1)");
    const Outline tree = make_accelerator("bvh", mesh_scene(std::make_shared<Mesh>(icosphere(0)), "ball"))->outline();
    CHECK(draw_structure(scene, tree, {}).notes.at(0).find(" of them leaves") != std::string::npos);
}

TEST_CASE("what is not tested is thin, and left out where there is too much of it, with a note") {
    const Scene scene = two_balls();
    CHECK(figures_of(draw_structure(scene, Row(scene).outline(), {}), 0.8) == 2);
    const auto few = draw_structure(scene, Row(scene).outline(), {.max_shapes = 1});
    CHECK(figures_of(few, 0.8) == 0);
    CHECK(few.notes.at(1).starts_with("Of 2 primitives"));
}

TEST_CASE("along an axis a box is seen as its rectangle, in a slice as its cut") {
    const Bound box = Box{{0, 0, 0}, {1, 2, 3}};
    for (const auto& [along, seen] : {std::pair{0, 6.0}, {1, 3.0}, {2, 2.0}}) {
        CHECK_THAT(area(polygon(PlaneView(along, {}, wide).figure(box))), WithinAbs(seen, 1e-12));
        CHECK_THAT(area(polygon(PlaneView(along, 0.5, wide).figure(box))), WithinAbs(seen, 1e-12));
        CHECK_FALSE(PlaneView(along, 3.5, wide).figure(box));
    }
}

TEST_CASE("a box without end is drawn as far as the drawing reaches") {
    const float infinity = std::numeric_limits<float>::infinity();
    const Bound half = Box{{0, -infinity, -infinity}, {infinity, infinity, infinity}};
    CHECK_THAT(area(polygon(PlaneView(2, {}, wide).figure(half))), WithinAbs(200, 1e-9));
}

TEST_CASE("an oriented box keeps its turn, a sphere its smaller circle in a slice") {
    const Bound diamond = OrientedBox{{0, 0, 0}, {Vec3f{1, 1, 0}, Vec3f{-1, 1, 0}, Vec3f{0, 0, 1}}};
    CHECK_THAT(area(polygon(PlaneView(2, {}, wide).figure(diamond))), WithinAbs(8, 1e-12));
    const auto cut = PlaneView(2, 0.6, wide).figure(Bound(Sphere{{1, 2, 0}, 1}));
    CHECK_THAT(std::get<PlaneCircle>(cut.value()).radius, WithinAbs(0.8, 1e-7));
    CHECK_FALSE(PlaneView(2, 1.1, wide).figure(Bound(Sphere{{1, 2, 0}, 1})));
}

TEST_CASE("shapes are drawn about as large as they are") {
    const auto seen = [](const Shape& shape) {
        double sum = 0;
        for (const Wires& piece : wires_of(shape, 0, {})) sum += area(polygon(PlaneView(2, {}, wide).figure(piece)));
        return sum;
    };
    CHECK_THAT(seen(Sphere{{1, 2, 3}, 1}), WithinAbs(std::numbers::pi, 0.1));
    CHECK_THAT(seen(Ellipsoid{{1, 2, 3}, {1, 2, 3}}), WithinAbs(2 * std::numbers::pi, 0.2));
    CHECK_THAT(seen(Cylinder{{0, 0, 0}, {3, 0, 0}, 1}), WithinAbs(6, 0.1));
    CHECK_THAT(seen(Cone{{0, 0, 0}, {3, 0, 0}, 1, 0}), WithinAbs(3, 0.1));
    CHECK_THAT(seen(Paraboloid{{0, 0, 0}, {3, 0, 0}, 1}), WithinAbs(4, 0.2));
    CHECK_THAT(seen(Hyperboloid{{0, 0, 0}, {3, 0, 0}, 1, 1}), WithinAbs(6, 0.1));
    CHECK_THAT(seen(Disk{{0, 0, 0}, {0, 0, 1}, 1}), WithinAbs(std::numbers::pi, 0.1));
    CHECK_THAT(seen(Annulus{{0, 0, 0}, {0, 0, 1}, 0.5f, 1}), WithinAbs(0.75 * std::numbers::pi, 0.1));
    CHECK_THAT(seen(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), WithinAbs(0.5, 1e-12));
    CHECK(wires_of(Plane{{0, 0, 0}, {0, 0, 1}}, 0, {}).empty());
}

TEST_CASE("a ray is inside a bound where its spans say, and a box stands about it") {
    const Ray ray{{-2, 0, 0}, {1, 0, 0}};
    const auto spans = [&](const Bound& bound, double from, double to) {
        const auto span = span_inside(ray, bound).value();
        CHECK_THAT(span.min, WithinAbs(from, 1e-6));
        CHECK_THAT(span.max, WithinAbs(to, 1e-6));
    };
    spans(Box{Vec3f(-1), Vec3f(1)}, 1, 3);
    spans(Sphere{{0, 0, 0}, 1}, 1, 3);
    spans(OrientedBox{{0, 0, 0}, {Vec3f{1, 1, 0}, Vec3f{-1, 1, 0}, Vec3f{0, 0, 1}}}, 0, 4);
    const Box about = box_about(OrientedBox{{1, 0, 0}, {Vec3f{1, 1, 0}, Vec3f{-1, 1, 0}, Vec3f{0, 0, 1}}});
    CHECK(about.min == Vec3f(-1, -2, -1));
    CHECK(about.max == Vec3f(3, 2, 1));
    CHECK_FALSE(span_inside(ray, Box{{0, 1, 0}, {1, 2, 1}}));
    CHECK_FALSE(span_inside(ray, Sphere{{0, 3, 0}, 1}));
}

TEST_CASE("the drawing is the same in both forms, with everything it says") {
    const Scene scene = two_balls();
    const auto drawing =
        draw_ray_through(scene, Row(scene), along_row, {.title = "A <row>", .width = 300, .height = 200});
    const std::string svg = to_svg(drawing);
    CHECK(svg.find("A &lt;row&gt;") != std::string::npos);
    CHECK(svg.find("x 0..1") != std::string::npos);              // a tooltip
    CHECK(svg.find("<polygon") < svg.find("data-visit=\"1\""));  // for a page's script
    CHECK(svg.find("data-visit=\"2\">2<") != std::string::npos);
    CHECK(svg.find(drawing.notes.at(0)) != std::string::npos);
    const Image image = to_image(drawing);
    CHECK(svg.find("width=\"300\" height=\"" + std::to_string(image.height()) + "\"") != std::string::npos);
    std::size_t of_ray = 0;
    for (const Pixel& pixel : image.pixels()) of_ray += pixel == ink::vermilion;
    CHECK(of_ray > 3);
}

TEST_CASE("a polygon's inside is filled, whichever way round, and nothing beside it") {
    for (const bool turned : {false, true}) {
        std::vector<Point2> corners{{2, 2}, {8, 2}, {8, 6}, {2, 6}};
        if (turned) std::ranges::reverse(corners);
        Image image(10, 10, ink::white);
        fill_convex(image, corners, ink::black);
        double covered = 0;
        for (const Pixel& pixel : image.pixels()) covered += 1 - pixel.r;
        CHECK_THAT(covered, WithinAbs(24, 1e-3));
    }
}

TEST_CASE("a structure's diagram has its upper nodes, says what is below them, and numbers the visited ones") {
    const Scene scene = two_balls();
    const Row row(scene);
    const auto all = structure_diagram(row.outline(), "row");
    CHECK(all.nodes.size() == 5);
    CHECK(all.edges.size() == 4);
    CHECK(all.nodes[0].label == "root");
    CHECK(all.nodes[2].style == "dashed");  // empty
    CHECK(all.title == "row");

    const auto visits = row.visits(along_row);
    const auto some = structure_diagram(row.outline(), "row", {.largest = 3, .visits = visits});
    REQUIRE(some.nodes.size() == 4);
    CHECK(some.nodes[1].label == "(2)\n0");
    CHECK(some.nodes[3].label == "2 nodes,\n1 primitive");
    CHECK(some.title == "row\n3 of 5 nodes are drawn");
}
