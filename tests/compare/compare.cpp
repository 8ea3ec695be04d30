#include "catch.h"
#include "compare/plain_exr.h"
#include "could_not.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/image/finite.h"
#include "raylab/image/picture_files/files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

using namespace raylab;
namespace fs = std::filesystem;

namespace {

const fs::path folder = fs::path(RAYLAB_BUILD) / "tests" / "compare_files";

Image picture(int width = 40, int height = 30) {
    Image image(width, height, {0.25f, 0.5f, 0.75f});
    for (int x = 0; x < width; ++x) image.at(x, x % height) = {1, 0.5f, 0};
    return image;
}

std::string kept(const std::string& name, const Image& image) {
    write_file(folder / name, plain_exr(image));
    return (folder / name).string();
}

ProcessResult compare_files(std::vector<std::string> words) {
    words.insert(words.begin(), "compare");
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.timeout = 60});
}

Image broken(float value) {
    Image image = picture();
    image.at(17, 4).g = value;
    return image;
}

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();

}  // namespace

TEST_CASE("values that are not finite are read as they stand in a file") {
    const Image back = read_image(kept("nan.exr", broken(not_a_number)));
    const auto found = first_non_finite(back);
    REQUIRE(found);
    CHECK(found->x == 17);
    CHECK(found->y == 4);
    CHECK(back.at(3, 3) == picture().at(3, 3));
}

TEST_CASE("the same picture: exit code 0") {
    const std::string a = kept("a.exr", picture()), b = kept("b.exr", picture());
    const auto result = compare_files({a, b});
    CHECK(result.code == 0);
    CHECK(result.output.starts_with("the same"));
    CHECK(result.errors.empty());
    CHECK(compare_files({a, b, "--exact"}).code == 0);
}

TEST_CASE("another picture: exit code 1, and why, and where") {
    Image other = picture();
    for (int i = 0; i < 20; ++i) other.at(20 + i % 5, 10 + i / 5) = {0, 0, 0};
    const auto result = compare_files({kept("other.exr", other), kept("a.exr", picture())});
    CHECK(result.code == 1);
    CHECK(result.output.starts_with("differs"));
    CHECK(result.output.find("(20, 10)") != std::string::npos);
}

TEST_CASE("one bit more: the same picture, but not the same bits") {
    Image image = picture();
    image.at(5, 9).r = std::nextafter(image.at(5, 9).r, 1.0f);
    const std::string a = kept("bit.exr", image), b = kept("a.exr", picture());
    CHECK(compare_files({a, b}).code == 0);
    CHECK(compare_files({a, b, "--exact"}).code == 1);
}

TEST_CASE("another size, or a value that is not finite on either side or both: exit code 1") {
    const std::string good = kept("a.exr", picture()), small = kept("small.exr", picture(40, 29));
    CHECK(compare_files({good, small}).code == 1);
    for (const float value : {not_a_number, infinite, -infinite}) {
        const std::string bad = kept("bad.exr", broken(value));
        CHECK(compare_files({bad, good}).code == 1);
        CHECK(compare_files({good, bad}).code == 1);
        CHECK(compare_files({bad, bad}).code == 1);
        CHECK(compare_files({bad, bad, "--exact"}).code == 1);
    }
}

TEST_CASE("what cannot be read: exit code 2, one line, nothing else") {
    const std::string good = kept("a.exr", picture());
    write_file(folder / "cut.exr", plain_exr(picture()).substr(0, 900));
    write_file(folder / "words.png", "no picture");
    for (const char* name : {"cut.exr", "words.png", "absent.exr"})
        for (const auto& words :
             {std::vector<std::string>{(folder / name).string(), good}, {good, (folder / name).string()}}) {
            const auto result = compare_files(words);
            check_could_not(result, name);
            CHECK(result.output.empty());
        }
    CHECK(compare_files({good}).code == 2);
}

TEST_CASE("of broken picture data nobody but the lab speaks: one line on stderr, exit code 2") {
    for (const char* name : {"too_little_data.png", "data_of_noise.png", "depth_of_three.png", "no_chunks.exr"}) {
        const fs::path file = fs::path(RAYLAB_SOURCE) / "tests/hostile/pictures" / name;
        check_could_not(compare_files({file, file}), name);
    }
}

TEST_CASE("pictures and comparisons that need more than --memory are refused before it is taken") {
    const std::string one = kept("large.exr", picture(512, 512)), other = kept("other_large.exr", Image(512, 512));
    const auto refusal = [&](const std::string& reference, const std::string& memory) {
        const auto result = compare_files({one, reference, "--memory", memory});
        CHECK(std::ranges::count(result.errors, '\n') == (result.code == 2 ? 1 : 0));
        return result.errors;
    };
    CHECK(refusal(one, "64M").empty());
    CHECK(refusal(other, "100M").empty());
    CHECK(refusal(other, "64M")
              .find("large.exr: expected at most 64.0 MiB (--memory), found a comparison that needs "
                    "72.0 MiB: 512 x 512 pixels that differ") != std::string::npos);
    CHECK(refusal(one, "1M").find("found a picture that needs ") != std::string::npos);
}

TEST_CASE("a difference picture is written whatever is compared") {
    const fs::path difference = folder / "difference.png";
    const std::string good = kept("a.exr", picture());
    for (const std::string& other : {kept("small.exr", picture(9, 7)), kept("bad.exr", broken(infinite)), good}) {
        fs::remove(difference);
        compare_files({other, good, "-o", difference.string()});
        CHECK(read_image(difference).width() > 40);
    }
}

TEST_CASE("--json - prints one JSON value and nothing else, NaN as text") {
    const std::string good = kept("a.exr", picture()), bad = kept("bad.exr", broken(not_a_number));
    const auto same = nlohmann::json::parse(compare_files({good, good, "--json", "-"}).output);
    CHECK(same.at("same") == true);
    CHECK(same.at("max_error") == 0);
    const auto differs = nlohmann::json::parse(compare_files({bad, good, "--json", "-"}).output);
    CHECK(differs.at("same") == false);
    CHECK(differs.at("non_finite").at("x") == 17);
    CHECK(differs.at("non_finite").at("value").at(1) == "nan");
}
