#include "catch.h"

#include "raylab/accelerator/accelerator.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cfenv>
#include <csignal>

using namespace raylab;

namespace {

// The message of a process that rounds in this mode, constructs a Traversal, and is ended by an assertion; empty if it
// is not ended.
std::string last_words(int rounding) {
    std::array<int, 2> ends;
    REQUIRE(pipe(ends.data()) == 0);
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGABRT, SIG_DFL);  // instead of Catch's handler
        dup2(ends[1], STDERR_FILENO);
        std::fesetround(rounding);
        const Traversal traversal;
        _exit(0);
    }
    close(ends[1]);
    std::array<char, 4096> text;
    std::string words;
    for (ssize_t count; (count = read(ends[0], text.data(), text.size())) > 0;)
        words.append(text.data(), static_cast<std::size_t>(count));
    close(ends[0]);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT ? words : "";
}

}  // namespace

TEST_CASE("a traversal is asserted to be made on a thread that rounds to nearest") {
    CHECK_THAT(last_words(FE_UPWARD), Catch::Contains("rounding to nearest, which this thread has left"));
    CHECK(last_words(FE_TONEAREST) == "");
}
