#include "catch.h"

#include "raylab/image/draw.h"
#include "raylab/image/stroke_font.h"

using namespace raylab;

namespace {

int painted(const Image& image) {
    int count = 0;
    for (const Pixel& pixel : image.pixels()) count += !(pixel == Pixel{});
    return count;
}

double covered(const Image& image) {
    double sum = 0;
    for (const Pixel& pixel : image.pixels()) sum += pixel.r;
    return sum;
}

}  // namespace

TEST_CASE("a disk covers its area") {
    Image image(100, 100);
    draw_disk(image, {50, 50}, 30, ink::white);
    CHECK_THAT(covered(image), WithinRel(3.14159265 * 900, 0.01));
    CHECK(image.at(50, 50) == ink::white);
    CHECK(image.at(5, 5) == Pixel{});
}

TEST_CASE("a line through a row of pixel centres paints that row") {
    Image image(20, 5);
    draw_line(image, {0, 2.5}, {20, 2.5}, 1, ink::white);
    for (int x = 0; x < 20; ++x) {
        CHECK(image.at(x, 2) == ink::white);
        CHECK(image.at(x, 0) == Pixel{});
    }
}

TEST_CASE("what lies outside the picture is not drawn, and harms nothing") {
    Image image(10, 10);
    draw_line(image, {-50, -50}, {-20, 90}, 3, ink::white);
    draw_disk(image, {200, 5}, 7, ink::white);
    draw_text(image, {400, -30}, 12, "far away", ink::white);
    CHECK(painted(image) == 0);
    draw_line(image, {-50, 5}, {90, 5}, 3, ink::white);
    CHECK(painted(image) > 0);
}

TEST_CASE("every letter, digit and common sign has a glyph of its own") {
    const auto shape = [](char c) {
        Image image(24, 24);
        draw_text(image, {6, 17}, 12, std::string(1, c), ink::white);
        return image.pixels();
    };
    const std::string known = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789.,:;-+=/()[]_<>%*!'\"^|~";
    for (const char c : known) {
        INFO(c);
        CHECK((shape(c) != shape('?')));
    }
    for (const char c : known)
        for (const char other : known)
            if (c < other && shape(c) == shape(other)) FAIL_CHECK(c << " looks like " << other);
    CHECK((shape('\x01') == shape('?')));
}

TEST_CASE("text stands where its anchor says") {
    CHECK(text_width("ii", 12) == 2 * text_width("i", 12));
    CHECK(text_width("abc", 24) == 2 * text_width("abc", 12));
    Image image(60, 20);
    draw_text(image, {60, 15}, 10, "end", ink::white, Anchor::right);
    CHECK(painted(cropped(image, 0, 0, 25, 20)) == 0);
    CHECK(painted(image) > 0);
}

TEST_CASE("pictures stand side by side with a gap between them") {
    const Image both = side_by_side({Image(3, 2, ink::black), Image(4, 5, ink::orange)}, 2, ink::white);
    CHECK(both.width() == 9);
    CHECK(both.height() == 5);
    CHECK(both.at(0, 0) == ink::black);
    CHECK(both.at(3, 0) == ink::white);
    CHECK(both.at(0, 4) == ink::white);
    CHECK(both.at(5, 4) == ink::orange);
    CHECK(side_by_side({}).pixels().empty());
}

TEST_CASE("enlarging and cropping keep the pixels") {
    Image image(2, 1);
    image.at(1, 0) = ink::green;
    CHECK(enlarged(image, 3).at(3, 2) == ink::green);
    CHECK(enlarged(image, 3).at(2, 2) == Pixel{});
    CHECK(cropped(image, 1, 0, 5, 5).pixels() == std::vector<Pixel>{ink::green});
}
