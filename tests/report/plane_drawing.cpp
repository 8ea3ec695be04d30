#include "raylab/report/plane/plane_drawing.h"

#include "catch.h"
#include "raylab/report/plane/plane_angle.h"
#include "raylab/report/plane/plane_frame.h"
#include "raylab/report/plane/plane_text.h"

#include <numbers>

using namespace raylab;

namespace {

using Run = PlaneTextRun;

PlaneDrawing drawing_of(std::vector<PlaneDrawing::Mark> marks) {
    return {
        .low = {0, 0}, .high = {10, 10}, .width = 124, .height = 124, .marks = std::move(marks)};  // 10 pixels a unit
}

// The darkness of the picture about a point of the plane: 0 where nothing is drawn.
double ink_at(const PlaneDrawing& drawing, PlanePoint point) {
    const Point2 at = PlaneFrame(drawing).at(point);
    const Image image = to_image(drawing);
    double darkest = 0;
    for (int y = -1; y <= 0; ++y)
        for (int x = -1; x <= 0; ++x)
            darkest = std::max(darkest, 1.0 - image.at(static_cast<int>(at.x) + x, static_cast<int>(at.y) + y).r);
    return darkest;
}

bool says(const PlaneDrawing& drawing, const std::string& what) {
    return to_svg(drawing).find(what) != std::string::npos;
}

}  // namespace

TEST_CASE("words with markup are runs: italic, bold, below and above the line") {
    CHECK(plane_text_runs("k_{r} *I*") ==
          std::vector<Run>{{"k"}, {"r", false, false, Run::Level::below}, {" "}, {"I", true}});
    CHECK(plane_text_runs("**M**^{-1}") ==
          std::vector<Run>{{"M", false, true}, {"-1", false, false, Run::Level::above}});
    CHECK(plane_text_runs("*t_{0}*") == std::vector<Run>{{"t", true}, {"0", true, false, Run::Level::below}});
}

TEST_CASE("words without markup stay as they are") {
    for (const std::string words : {"2 * 3 * 4", "bvh_sphere", "a * b", "x_{1", "5*", "{a}", "**"}) {
        CAPTURE(words);
        CHECK(plane_text_runs(words) == std::vector<Run>{{words}});
    }
}

TEST_CASE("a subscript is small and low in SVG, and what follows it is on the line again") {
    const auto drawing = drawing_of({PlaneDrawing::Text{{5, 5}, "k_{r} & N", 7.3}});
    CHECK(says(
        drawing,
        " xml:space=\"preserve\">k<tspan font-size=\"7.20\" dy=\"2.19\">r</tspan><tspan dy=\"-2.19\"> &amp; N</tspan>"));
}

TEST_CASE("words in a picture are as wide as their runs, wherever they are anchored") {
    const auto left = drawing_of({PlaneDrawing::Text{{5, 5}, "H_{H}", 20}});
    const auto right =
        drawing_of({PlaneDrawing::Text{.at = {5, 5}, .words = "H_{H}", .height = 20, .anchor = Anchor::right}});
    CHECK(to_image(left).pixels() != to_image(right).pixels());
    const std::string letter = "H";
    const double width = (text_width(letter, 20) + text_width(letter, 0.72 * 20)) / 10;
    const auto moved = drawing_of({PlaneDrawing::Text{{5 - width, 5}, "H_{H}", 20}});
    CHECK(to_image(moved).pixels() == to_image(right).pixels());
}

TEST_CASE("words with a rim are readable across a line, in both forms") {
    const PlaneDrawing::Figure ground{PlanePolygon{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}, {.fill = "#000000"}};
    PlaneDrawing::Text text{{2, 4}, "I", 30, "#000000"};
    CHECK(to_image(drawing_of({ground, text})).pixels() == to_image(drawing_of({ground})).pixels());
    text.halo = "#ffffff";
    CHECK(to_image(drawing_of({ground, text})).pixels() != to_image(drawing_of({ground})).pixels());
    CHECK(says(drawing_of({ground, text}), "stroke=\"#ffffff\""));
}

TEST_CASE("a path goes from point to point and does not return") {
    const auto drawing = drawing_of({PlaneDrawing::Path{{{1, 1}, {9, 1}, {9, 9}}, {.width = 3}}});
    CHECK(ink_at(drawing, {5, 1}) > 0.9);
    CHECK(ink_at(drawing, {9, 5}) > 0.9);
    CHECK(ink_at(drawing, {5, 5}) == 0);  // a polygon would be closed along the diagonal
    CHECK(says(drawing, "<polyline points=\"22.00,102.00 102.00,102.00 102.00,22.00\""));
}

TEST_CASE("the dashes of a path go on around its corners") {
    const auto dashed = [&](std::vector<PlanePoint> points) {
        return to_image(
            drawing_of({PlaneDrawing::Path{std::move(points), {.width = 2, .dash = PlaneStyle::Dash::dashed}}}));
    };
    CHECK(dashed({{1, 5}, {9, 5}}).pixels() == dashed({{1, 5}, {3, 5}, {3.3, 5}, {9, 5}}).pixels());
}

TEST_CASE("an arc passes through its middle, its arrow stands at its end, in the order of its angles") {
    const PlaneDrawing::Arc arc{{5, 5}, 4, 90, 0, {.width = 3}};
    const double middle = 5 + 4 * std::sqrt(0.5);
    CHECK(ink_at(drawing_of({arc}), {middle, middle}) > 0.9);
    CHECK(ink_at(drawing_of({arc}), {5 - 4 * std::sqrt(0.5), middle}) == 0);
    const PlanePoint beside_end{9.45, 5.95};  // on one side of the arrow's head
    CHECK(ink_at(drawing_of({arc}), beside_end) == 0);
    auto tipped = arc;
    tipped.tip = PlaneDrawing::Arc::Tip::arrow;
    CHECK(ink_at(drawing_of({tipped}), beside_end) > 0.3);
}

TEST_CASE("the arc of an angle takes the short way, from any side") {
    const auto across = angle_arc({0, 0}, {-1, 0.1}, {-1, -0.1}, 2);  // over the seam of atan2
    CHECK_THAT(std::abs(across.to - across.from), WithinAbs(2 * std::atan(0.1) * 180 / std::numbers::pi, 1e-9));
    const auto quarter = angle_arc({1, 1}, {3, 1}, {1, 2}, 1);
    CHECK_THAT(quarter.from, WithinAbs(0, 1e-12));
    CHECK_THAT(quarter.to, WithinAbs(90, 1e-12));
    const auto words = beside_arc(quarter, "90", 10);
    CHECK_THAT(words.at.x, WithinAbs(1 + std::sqrt(0.5), 1e-12));
    CHECK(words.aside.x > 0);
}

TEST_CASE("the mark of a right angle is a small square's other two sides") {
    const auto mark = right_angle({1, 1}, {5, 1}, {1, 9}, 0.5);
    REQUIRE(mark.points.size() == 3);
    CHECK(mark.points[1].x == 1.5);
    CHECK(mark.points[1].y == 1.5);
    CHECK(mark.points[0].y == 1);
    CHECK(mark.points[2].x == 1);
}
