#include "catch.h"

#include "raylab/image/color.h"
#include "raylab/image/draw.h"

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

TEST_CASE("every letter, digit, sign and Greek letter has a glyph of its own") {
    const auto shape = [](const std::string& character) {
        Image image(32, 32);
        draw_text(image, {6, 22}, 12, character, ink::white);
        return image.pixels();
    };
    std::vector<std::string> known{"°", "×", "²", "−", "·", "≤", "∞", "→", "α", "β", "θ", "λ", "π", "ρ", "τ", "Δ"};
    for (const char c : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqr"
                                    "stuvwxyz0123456789.,:;-+=/()[]_<>%*!'?^"))
        known.emplace_back(1, c);
    const auto unknown = shape("\U0010FFFF"), broken = shape("\xff");
    CHECK((unknown != broken));
    for (std::size_t i = 0; i < known.size(); ++i) {
        INFO(known[i]);
        CHECK((shape(known[i]) != unknown && shape(known[i]) != broken));
        for (std::size_t j = i + 1; j < known.size(); ++j)
            if (shape(known[i]) == shape(known[j])) FAIL_CHECK(known[i] << " looks like " << known[j]);
    }
}

TEST_CASE("text stands where its anchor says, and grows with its height") {
    CHECK(text_width("ii", 12) == 2 * text_width("i", 12));
    CHECK(text_width("abc", 24) == 2 * text_width("abc", 12));
    CHECK(text_width("α²", 12) == text_width("α", 12) + text_width("²", 12));
    Image image(60, 20);
    draw_text(image, {60, 15}, 10, "end", ink::white, Anchor::right);
    CHECK(painted(cropped(image, 0, 0, 25, 20)) == 0);
    CHECK(painted(image) > 0);
}

TEST_CASE("letters are kerned") { CHECK(text_width("AV", 12) < text_width("A", 12) + text_width("V", 12) - 0.5); }

TEST_CASE("a capital stands on the baseline and is as high as was asked for") {
    const auto row = [](const Image& image, int y) { return covered(cropped(image, 0, y, image.width(), 1)); };
    for (const double height : {9.0, 30.0}) {
        Image image(60, 60);
        draw_text(image, {10, 45}, height, "H", ink::white);
        const int top = 45 - static_cast<int>(height);
        CHECK(row(image, 45) == 0);
        CHECK(row(image, 44) > 0);
        CHECK(row(image, top) > 0.9 * row(image, top + 1));
        CHECK(row(image, top - 1) < 0.1 * row(image, top));
    }
}

TEST_CASE("a letter moved by half a pixel covers as much, in other pixels") {
    const auto at = [](double x, double y) {
        Image image(60, 60);
        draw_text(image, {x, y}, 30, "O", ink::white);
        return image;
    };
    const Image whole = at(10, 45), half = at(10.5, 45.5);
    CHECK((whole.pixels() != half.pixels()));
    const auto inked = [](const Image& image) {
        double sum = 0;
        for (const Pixel& pixel : image.pixels()) sum += srgb_from_linear(pixel.r);
        return sum;
    };
    CHECK_THAT(inked(half), WithinRel(inked(whole), 0.005));
    CHECK((cropped(whole, 0, 0, 50, 50).pixels() == cropped(at(11, 46), 1, 1, 50, 50).pixels()));
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
    CHECK(std::ranges::equal(cropped(image, 1, 0, 5, 5).pixels(), std::vector{ink::green}));
}
