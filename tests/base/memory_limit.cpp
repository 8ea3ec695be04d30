#include "raylab/base/memory_limit.h"

#include "catch.h"

#include <fstream>

using namespace raylab;

TEST_CASE("what needs more than the limit is refused, with both figures and the reason") {
    CHECK_NOTHROW(check_memory({1024, "a picture", "x"}, {1024}, {"a.exr"}));
    CHECK_THROWS_WITH(check_memory({17.2 * (1 << 30), "a picture", "256 channels x 16384 x 16384"},
                                   {std::uint64_t{1} << 32}, {"a.exr"}),
                      "a.exr: expected at most 4.0 GiB (--memory), found a picture that needs 17.2 GiB: "
                      "256 channels x 16384 x 16384");
}

TEST_CASE("a limit is bytes, or K, M, G of 1024 each; anything else is refused") {
    CHECK(memory_limit_from_words("4G").bytes == std::uint64_t{4} << 30);
    CHECK(memory_limit_from_words("512M").bytes == std::uint64_t{512} << 20);
    CHECK(memory_limit_from_words("100K").bytes == 102400);
    CHECK(memory_limit_from_words("77").bytes == 77);
    for (const char* words : {"", "G", "4g", "4GB", "-1", "0", "0x10", "4.5G", "99999999999999G", " 4G"})
        CHECK_THROWS_WITH(memory_limit_from_words(words), Catch::Contains("expected --memory in bytes"));
}

TEST_CASE("without a word the limit is at most half of the machine's memory") {
    std::ifstream file("/proc/meminfo");
    std::string name;
    std::uint64_t kibibytes = 0;
    REQUIRE(file >> name >> kibibytes);
    REQUIRE(name == "MemTotal:");
    CHECK(MemoryLimit{}.bytes > 0);
    CHECK(MemoryLimit{}.bytes <= 1024 * kibibytes / 2);
}
