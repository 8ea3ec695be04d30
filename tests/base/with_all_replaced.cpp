#include "raylab/base/with_all_replaced.h"

#include "catch.h"

using raylab::with_all_replaced;

TEST_CASE("each place of a part is replaced, at both ends of a text, too") {
    CHECK(with_all_replaced("", "a", "b").empty());
    CHECK(with_all_replaced("none here", "@", "b") == "none here");
    CHECK(with_all_replaced("a-a--a", "a", "123") == "123-123--123");
    CHECK(with_all_replaced("\\\none\\\n two\\\n", "\\\n", "") == "one two");
}

TEST_CASE("a replacement that holds the part, or makes it with what follows, is not replaced again") {
    CHECK(with_all_replaced("aa", "a", "aa") == "aaaa");
    CHECK(with_all_replaced("xyzz", "xyz", "xy") == "xyz");
}
