#include "raylab/report/label_layout.h"

#include "catch.h"

#include <cmath>

using namespace raylab;

namespace {

constexpr Rectangle frame{0, 0, 900, 600};

std::vector<Rectangle> markers(const std::vector<LabelWish>& wishes) {
    std::vector<Rectangle> boxes;
    for (const auto& wish : wishes) boxes.push_back({wish.x - 6, wish.y - 6, wish.x + 6, wish.y + 6});
    return boxes;
}

void check_readable(const std::vector<LabelWish>& wishes) {
    const auto obstacles = markers(wishes);
    const auto labels = place_labels(wishes, {frame, obstacles});
    REQUIRE(labels.size() == wishes.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        CHECK(frame.contains(labels[i].box));
        for (std::size_t j = 0; j < i; ++j) CHECK(labels[i].box.overlap(labels[j].box) == 0);
        for (const auto& marker : obstacles) CHECK(labels[i].box.overlap(marker) == 0);
    }
}

}  // namespace

TEST_CASE("a lone name stands to the right of its point, without a line") {
    const std::vector<LabelWish> wishes = {{100, 100, 80, 14}};
    const auto label = place_labels(wishes, {frame}).front();
    CHECK(label.box.x0 > 100);
    CHECK(label.box.x0 < 115);
    CHECK(label.leader == PlacedLabel::Leader::none);
}

TEST_CASE("at the right edge a name stands to the left") {
    const std::vector<LabelWish> wishes = {{890, 100, 80, 14}};
    CHECK(place_labels(wishes, {frame}).front().box.x1 < 890);
}

TEST_CASE("names of many near points neither touch each other, nor a marker, nor leave the frame") {
    std::vector<LabelWish> wishes;
    for (int i = 0; i < 14; ++i) wishes.push_back({60.0 + 3 * i, 200.0 + 9 * i, 170, 15});
    check_readable(wishes);
}

TEST_CASE("names of points in a column, as methods without errors are, stay readable") {
    std::vector<LabelWish> wishes;
    for (int i = 0; i < 16; ++i) wishes.push_back({450, 250.0 + 7 * i, 160, 15});
    check_readable(wishes);
}

TEST_CASE("sixteen points anywhere get sixteen readable names") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        std::vector<LabelWish> wishes;
        for (std::uint32_t i = 0; i < 16; ++i)
            wishes.push_back({50 + 800 * std::fmod(0.618034 * i + 0.37 * static_cast<double>(seed), 1.0),
                              30 + 540 * std::fmod(0.754878 * i + 0.21 * static_cast<double>(seed), 1.0), 150, 15});
        check_readable(wishes);
    }
}

TEST_CASE("a name far from its point gets a line to it") {
    const std::vector<LabelWish> wishes(9, LabelWish{450, 300, 100, 15});
    const auto labels = place_labels(wishes, {frame, markers(wishes)});
    CHECK(labels.back().leader == PlacedLabel::Leader::line);
}

TEST_CASE("a name rather moves than covers a line") {
    const std::vector<LabelWish> wishes = {{100, 100, 80, 14}};
    std::vector<Rectangle> line;
    for (double x = 108; x < 300; x += 8) line.push_back({x - 1, 99, x + 1, 101});
    const auto box = place_labels(wishes, {frame, {}, line}).front().box;
    for (const auto& piece : line) CHECK(box.overlap(piece) == 0);
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
