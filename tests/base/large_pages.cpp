#include "raylab/base/large_pages.h"

#include "raylab/base/heap.h"

#include "catch.h"
#include "sanitized.h"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

using namespace raylab;

namespace {

struct alignas(64) Line {
    std::uint64_t number = 0;
};

// Of the mapping in which an address lies.
std::size_t kilobytes_on_large_pages(const void* at) {
    const auto address = reinterpret_cast<std::uintptr_t>(at);
    bool is_there = false;
    std::ifstream file("/proc/self/smaps");
    for (std::string line; std::getline(file, line);) {
        std::uintptr_t begin = 0, end = 0;
        std::size_t size = 0;
        if (std::sscanf(line.c_str(), "%lx-%lx ", &begin, &end) == 2) is_there = begin <= address && address < end;
        if (is_there && std::sscanf(line.c_str(), "AnonHugePages: %zu", &size) == 1) return size;
    }
    return 0;
}

// Whether the system has any to give: asked for here without the library.
bool has_large_pages() {
    constexpr std::size_t size = 4 * large_page;
    void* const memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return false;
    madvise(memory, size, MADV_HUGEPAGE);
    std::fill_n(static_cast<char*>(memory), size, char{1});
    const bool found = kilobytes_on_large_pages(static_cast<char*>(memory) + size / 2) >= 2048;
    munmap(memory, size);
    return found;
}

}  // namespace

TEST_CASE("a vector on large pages keeps what it holds as it grows past a large page, aligned") {
    LargeVector<Line> lines;
    for (std::uint64_t i = 0; i < 100'000; ++i) {
        lines.push_back({i});
        REQUIRE(reinterpret_cast<std::uintptr_t>(lines.data()) % alignof(Line) == 0);
    }
    lines.shrink_to_fit();
    for (std::uint64_t i = 0; i < 100'000; ++i) REQUIRE(lines[i].number == i);
}

TEST_CASE("what is larger than a large page begins on one") {
    const LargeVector<char> large(std::size_t{5} << 20);
    CHECK(reinterpret_cast<std::uintptr_t>(large.data()) % large_page == 0);
    CHECK(reinterpret_cast<std::uintptr_t>(LargeArray<char>(std::size_t{5} << 20).data()) % large_page == 0);
}

TEST_CASE("the system gives large pages for what holds them") {
    if (is_sanitized || !has_large_pages()) return;
    for (const std::size_t size : {std::size_t{5} << 20, std::size_t{40} << 20}) {
        LargeArray<char> some(size);
        std::ranges::fill(some, char{1});
        CHECK(kilobytes_on_large_pages(some.data() + size / 2) >= 2048);
    }
}

// (So large that it comes from the system by itself, with no page that was written before.)
TEST_CASE("an array that is not set takes no memory before it is written") {
    if (is_sanitized || !has_large_pages()) return;
    LargeArray<char> some(std::size_t{40} << 20);
    CHECK(kilobytes_on_large_pages(some.data() + some.size() / 2) == 0);
    some.back() = 1;
    CHECK(kilobytes_on_large_pages(some.data() + some.size() / 2) == 2048);
}

// (Hidden: the next one runs it in a process whose heap is as new.)
TEST_CASE("of a new process", "[.heap]") {
    keep_freed_memory();
    const std::vector<char> some(3'000'000, 'a');
    CHECK(kilobytes_on_large_pages(some.data()) >= 2048);
}

TEST_CASE("a heap that is put on large pages gives what is allocated next a place there") {
    if (is_sanitized || !has_large_pages()) return;
    const pid_t child = fork();
    if (child == 0) {
        execl("/proc/self/exe", "test_base", "of a new process", "--out", "/dev/null", nullptr);
        _exit(1);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(status == 0);
}

// (What is kept in between divides what was freed.)
TEST_CASE("aligned blocks take the places of those of their size that were freed") {
    if (is_sanitized) return;
    std::vector<std::vector<char>> kept;
    kept.reserve(2'000);
    const std::size_t before = mallinfo2().arena;
    for (int i = 0; i < 2'000; ++i) {
        const LargeVector<Line> large(1'560), small(930);
        const std::vector<char> other(2'000);
        kept.emplace_back(100);
    }
    CHECK(mallinfo2().arena - before < 1'000'000);
}

TEST_CASE("more elements than there are addresses are refused") {
    CHECK_THROWS_AS(LargePages<Line>().allocate(std::numeric_limits<std::size_t>::max() / 8),
                    std::bad_array_new_length);
    CHECK_THROWS_AS(LargeArray<int>(std::numeric_limits<std::size_t>::max() / 3), std::length_error);
}
