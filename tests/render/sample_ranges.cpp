#include "sample_ranges.h"

#include "catch.h"

using namespace raylab;

TEST_CASE("samples are taken to at most 32 stops, wherever a picture goes on, and to the last one") {
    for (const SampleRange all : {SampleRange{0, 1}, {0, 32}, {0, 33}, {0, 63}, {0, 64}, {21, 84}, {0, 4096}}) {
        int stops = 0;
        for (int at = all.first; at < all.last; ++stops) {
            const int next = next_stop(all, at - all.first);
            CHECK(next > at);
            CHECK(next_stop(all, next - 1 - all.first) == next);
            at = next;
            if (at > all.last) break;
        }
        INFO(all.first << " to " << all.last);
        CHECK(stops <= 32);
        CHECK(next_stop(all, all.last - 1 - all.first) == all.last);
    }
}
