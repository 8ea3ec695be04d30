#include "catch.h"
#include "raylab/base/base64.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/page/pixel_values.h"

#include <cstdint>
#include <vector>

using namespace raylab;

TEST_CASE("a picture's values are stored as mantissas above exponents") {
    Image image(2, 1);
    image.at(0, 0) = {1, 0.5f, 0};      // 1 is 128/256 of 2^1
    image.at(1, 0) = {-3, 12, 0.001f};  // 12 is 192/256 of 2^4; a negative value is stored as 0
    const std::vector<std::uint8_t> stored{128, 64, 0, 0, 192, 0, 129, 129, 129, 132, 132, 132};
    CHECK(pixel_values_script(image) ==
          "raylab_values(\"data:image/png;base64," + base64(png_bytes(2, 2, stored)) + "\");\n");
}

TEST_CASE("black, and values next to nothing, are stored as zero") {
    Image image(1, 1);
    image.at(0, 0) = {0, 1e-40f, 0};
    const std::vector<std::uint8_t> stored(6, 0);
    CHECK(pixel_values_script(image).find(base64(png_bytes(1, 2, stored))) != std::string::npos);
}
