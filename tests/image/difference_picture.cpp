#include "catch.h"

#include "raylab/image/difference_picture.h"

#include <limits>

using namespace raylab;

namespace {

Image picture_of(const Image& a, const Image& b) { return difference_picture(a, b, compare(a, b)); }

}  // namespace

TEST_CASE("a difference picture can be written whatever it compares") {
    Image broken(20, 10);
    broken.at(3, 4).r = std::numeric_limits<float>::quiet_NaN();
    for (const Image& a : {Image(20, 10), Image(9, 30, {1, 0, 0}), Image(1, 1), Image(), broken})
        for (const Image& b : {Image(20, 10, {0.1f, 0, 0}), Image(), broken})
            CHECK_FALSE(first_non_finite(picture_of(a, b)));
}

TEST_CASE("a difference shows in the middle, and only where it is") {
    Image image(300, 300), reference(300, 300);
    image.at(150, 150) = {1, 1, 1};
    const Image shown = picture_of(image, reference);
    const int middle = 300 + 8;  // one picture and the gap
    CHECK(shown.at(middle + 150, 150).r > 0.01f);
    CHECK(shown.at(middle + 20, 20) == Pixel{});
}
