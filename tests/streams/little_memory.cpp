#include "catch.h"
#include "streams/program.h"

#include "raylab/base/file.h"

using namespace raylab;

TEST_CASE("a diagram in little memory is as it should be, or refused in one line; nothing is left then") {
    for (const std::string extension : {"svg", "png", "pdf"}) {
        const auto file = streams_folder / ("tight." + extension), roomy = streams_folder / ("roomy." + extension);
        const auto tree = [](const std::filesystem::path& to, const Around& around) {
            return in_shell({"tree", still_life, "--pixel", "300,250", "-o", to}, around);
        };
        REQUIRE(tree(roomy, {}).code == 0);
        int refused = 0;
        for (const int megabytes : {24, 60, 100, 150}) {  // the program itself, and what it loads, take 20
            INFO(extension << " in " << megabytes << " MB");
            std::filesystem::remove(file);
            const auto result = tree(file, {.prefix = "ulimit -v " + std::to_string(megabytes << 10) + ";"});
            if (result.code == 0) {
                CHECK(result.errors == "");
                CHECK(read_file(file) == read_file(roomy));
                continue;
            }
            ++refused;
            check_could_not(result, "");
            CHECK_FALSE(std::filesystem::exists(file));
        }
        CHECK(refused > 0);  // otherwise the limits are too high to test anything
    }
}
