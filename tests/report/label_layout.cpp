#include "raylab/report/chart/label_layout.h"
#include "raylab/report/chart/tradeoff_names.h"

#include "catch.h"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

using namespace raylab;

namespace {

constexpr Rectangle frame{0, 0, 900, 600};

std::vector<Rectangle> markers(const std::vector<LabelRequest>& requests) {
    std::vector<Rectangle> boxes;
    for (const auto& request : requests) boxes.push_back({request.x - 6, request.y - 6, request.x + 6, request.y + 6});
    return boxes;
}

void check_readable(const std::vector<LabelRequest>& requests) {
    const auto obstacles = markers(requests);
    const auto labels = place_labels(requests, {frame, obstacles});
    REQUIRE(labels.size() == requests.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        REQUIRE(labels[i]);
        CHECK(frame.contains(labels[i]->box));
        for (std::size_t j = 0; j < i; ++j) CHECK(labels[i]->box.overlap(labels[j]->box) == 0);
        for (const auto& marker : obstacles) CHECK(labels[i]->box.overlap(marker) == 0);
    }
}

Dot dot_of_front(const std::string& name, double error, double time) {
    return {.row = 0,
            .name = name,
            .error = error,
            .time = time,
            .time_low = time,
            .time_high = time,
            .look = style_of(0),
            .size = 1,
            .kind = Dot::Kind::error_seen,
            .place = Dot::Place::front};
}

}  // namespace

TEST_CASE("a lone name stands to the right of its point, without a line") {
    const std::vector<LabelRequest> requests = {{100, 100, 80, 14}};
    const auto label = place_labels(requests, {frame}).front().value();
    CHECK(label.box.x0 > 100);
    CHECK(label.box.x0 < 115);
    CHECK(label.leader == PlacedLabel::Leader::none);
}

TEST_CASE("at the right edge a name stands to the left") {
    const std::vector<LabelRequest> requests = {{890, 100, 80, 14}};
    CHECK(place_labels(requests, {frame}).front().value().box.x1 < 890);
}

TEST_CASE("names of many near points neither touch each other, nor a marker, nor leave the frame") {
    std::vector<LabelRequest> requests;
    for (int i = 0; i < 14; ++i) requests.push_back({60.0 + 3 * i, 200.0 + 9 * i, 170, 15});
    check_readable(requests);
}

TEST_CASE("names of points in a column, as methods without errors are, stay readable") {
    std::vector<LabelRequest> requests;
    for (int i = 0; i < 16; ++i) requests.push_back({450, 250.0 + 7 * i, 160, 15});
    check_readable(requests);
}

TEST_CASE("sixteen points anywhere get sixteen readable names") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        std::vector<LabelRequest> requests;
        for (std::uint32_t i = 0; i < 16; ++i)
            requests.push_back({50 + 800 * std::fmod(0.618034 * i + 0.37 * static_cast<double>(seed), 1.0),
                                30 + 540 * std::fmod(0.754878 * i + 0.21 * static_cast<double>(seed), 1.0), 150, 15});
        check_readable(requests);
    }
}

TEST_CASE("a name far from its point gets a line to it") {
    const std::vector<LabelRequest> requests(9, LabelRequest{450, 300, 100, 15});
    const auto labels = place_labels(requests, {frame, markers(requests)});
    REQUIRE(labels.back());
    CHECK(labels.back()->leader == PlacedLabel::Leader::line);
}

TEST_CASE("a name rather moves than covers a line") {
    const std::vector<LabelRequest> requests = {{100, 100, 80, 14}};
    std::vector<Rectangle> line;
    for (double x = 108; x < 300; x += 8) line.push_back({x - 1, 99, x + 1, 101});
    const auto box = place_labels(requests, {frame, {}, line}).front().value().box;
    for (const auto& piece : line) CHECK(box.overlap(piece) == 0);
}

TEST_CASE("a name nearly as wide as its panel is moved inside, wherever its point is") {
    const Rectangle panel{100, 50, 370, 280};
    for (double x = 100; x <= 370; x += 10)
        for (double y = 50; y <= 280; y += 10) {
            const std::vector<LabelRequest> requests = {{x, y, 262, 15}};
            const auto label = place_labels(requests, {panel, markers(requests)}).front();
            REQUIRE(label);
            CHECK(panel.contains(label->box));
            CHECK(label->box.overlap(markers(requests).front()) == 0);
        }
}

TEST_CASE("where names have no room, the last are left out, and the others neither touch nor leave the panel") {
    const Rectangle panel{100, 50, 370, 130};
    const std::vector<LabelRequest> requests(12, LabelRequest{200, 90, 180, 15});
    const auto labels = place_labels(requests, {panel, markers(requests)});
    REQUIRE(labels.size() == requests.size());
    CHECK(labels[0]);
    CHECK(labels[1]);
    CHECK_FALSE(labels.back());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!labels[i]) continue;
        CHECK(panel.contains(labels[i]->box));
        for (std::size_t j = 0; j < i; ++j)
            if (labels[j]) CHECK(labels[i]->box.overlap(labels[j]->box) == 0);
    }
}

TEST_CASE("a name wider than its panel is left out") {
    const std::vector<LabelRequest> requests = {{200, 90, 280, 15}};
    CHECK_FALSE(place_labels(requests, {{100, 50, 370, 130}}).front());
}

TEST_CASE("of a front with more names than room the ends are named") {
    TradeoffPanel panel{"crowded", {}, {}};
    for (const std::string name : {"most accurate of all", "second of the front", "third of the front",
                                   "fourth of the front", "the fastest of them all"}) {
        const double share = 0.3 + 0.1 * static_cast<double>(panel.dots.size());
        panel.dots.push_back(dot_of_front(name, share, 1 - share));
    }
    Sketch sketch(300, 60);
    draw_names(sketch, {0, 0, 220, 54}, panel, {}, NamedPoints::front);
    const auto svg = to_svg(std::move(sketch).drawing());
    CHECK(svg.find("most accurate of all") != std::string::npos);
    CHECK(svg.find("the fastest of them all") != std::string::npos);
    CHECK(svg.find("fourth of the front") == std::string::npos);
}

TEST_CASE("a name moves out of the way of a bar of times") {
    const auto left_end = [](double low, double high) {
        TradeoffPanel panel{"bars", {dot_of_front("the fast one", 0.4, 0.5)}, {}};
        Dot barred = dot_of_front("another", 0.5, 0.9);
        barred.time_low = low;
        barred.time_high = high;
        barred.place = Dot::Place::behind;
        panel.dots.push_back(barred);
        Sketch sketch(500, 200);
        draw_names(sketch, {0, 0, 500, 200}, panel, {}, NamedPoints::front);
        const auto svg = to_svg(std::move(sketch).drawing());
        const auto text = svg.substr(svg.rfind("<text", svg.find("the fast one")));
        return std::stod(text.substr(text.find("x=\"") + 3));
    };
    CHECK(left_end(0.9, 0.9) > 200);
    CHECK(left_end(0.1, 0.9) < 200);
}

TEST_CASE("a bold name is taken to be as wide as it is drawn, and hardly wider") {
    // Sums of the advances of DejaVu Sans Bold at 26 pixels, each rounded to whole pixels as it is drawn, divided by
    // two.
    const std::vector<std::pair<std::string_view, double>> drawn = {{"Moeller-Trumbore, eps 1e-8, double", 266.5},
                                                                    {"plane and edges, double", 183.5},
                                                                    {"watertight, double", 138.5},
                                                                    {"filtered exact, double + exact", 219.5}};
    for (const auto& [name, width] : drawn) {
        CHECK(bold_label_width(name, 13) > width - 0.1);
        CHECK(bold_label_width(name, 13) < 1.03 * width);
    }
}

TEST_CASE("pushing apart keeps order, distance and limits, and leaves alone what is apart") {
    const std::vector<double> apart = {10, 50, 90};
    CHECK(push_apart(apart, 20, 0, 100) == apart);
    const auto pushed = push_apart(std::vector<double>{50, 50, 10, 52}, 10, 0, 100);
    CHECK(pushed[2] == 10);
    CHECK_THAT(pushed[0], WithinAbs(50 + 2.0 / 3 - 10, 1e-9));
    CHECK_THAT(pushed[1] - pushed[0], WithinAbs(10, 1e-9));
    CHECK_THAT(pushed[3] - pushed[1], WithinAbs(10, 1e-9));
}

TEST_CASE("a column that is crowded at its end is pushed back inside") {
    const auto pushed = push_apart(std::vector<double>{95, 97, 99}, 10, 0, 100);
    CHECK(pushed == std::vector<double>{80, 90, 100});
    const auto low = push_apart(std::vector<double>{1, 2}, 10, 0, 100);
    CHECK(low == std::vector<double>{0, 10});
}
