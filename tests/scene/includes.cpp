#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/scene/read_scene.h"

#include <unistd.h>

#include <filesystem>

using namespace raylab;
namespace fs = std::filesystem;

TEST_CASE("includes may be nested sixteen files deep, not seventeen") {
    const fs::path folder = fs::temp_directory_path() / ("raylab_includes_test_" + std::to_string(getpid()));
    fs::create_directories(folder);
    const auto file = [&](int number) { return folder / (std::to_string(number) + ".toml"); };
    for (int number = 1; number <= 16; ++number)
        write_file(file(number), "raylab = 1\ninclude = [\"" + std::to_string(number + 1) + ".toml\"]\n");
    write_file(file(17), "raylab = 1\n");
    CHECK_NOTHROW(read_scene(file(2)));
    CHECK_THROWS_WITH(read_scene(file(1)), Catch::Contains("nested at most 16 deep"));
    fs::remove_all(folder);
}
