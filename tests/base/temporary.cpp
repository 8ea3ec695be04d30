#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/base/lone_users.h"
#include "raylab/base/temporary.h"

#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

using namespace raylab;
namespace fs = std::filesystem;
using Kind = Temporary::Kind;

namespace {

std::ptrdiff_t entries_in(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

/// Makes another process create a temporary file and a folder that is not empty, and be killed.
void leave_temporaries_in(const fs::path& folder) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        const Temporary file(Kind::file, folder, ".png"), full(Kind::folder, folder);
        std::ofstream(full.path() / "inside") << "left";
        kill(getpid(), SIGKILL);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFSIGNALED(status));
}

}  // namespace

TEST_CASE("a temporary is gone with its owner, with all that is in it") {
    const ScratchFolder scratch;
    {
        const Temporary file(Kind::file, scratch.path(), ".svg"), folder(Kind::folder, scratch.path());
        std::ofstream(folder.path() / "inside") << "text";
        CHECK(file.path().extension() == ".svg");
        CHECK(fs::is_regular_file(file.path()));
        CHECK(entries_in(scratch.path()) == 2);
    }
    CHECK(entries_in(scratch.path()) == 0);
}

TEST_CASE("the next temporary removes what a killed process left in its folder, and nothing else") {
    const ScratchFolder scratch;
    leave_temporaries_in(scratch.path());
    REQUIRE(entries_in(scratch.path()) == 2);
    std::ofstream(scratch.path() / ".raylab-own") << "a file that somebody named so";
    const Temporary used(Kind::file, scratch.path());
    const Temporary next(Kind::file, scratch.path());
    CHECK(fs::exists(used.path()));
    CHECK(fs::exists(next.path()));
    CHECK(fs::exists(scratch.path() / ".raylab-own"));
    CHECK(entries_in(scratch.path()) == 3);
}

TEST_CASE("root's next temporary removes what was given to foreign code, and nothing of other users") {
    if (geteuid() != 0) return;  // nobody else gives a folder away
    const ScratchFolder scratch;
    const auto give_all_to = [&](unsigned user) {
        for (const auto& entry : fs::directory_iterator(scratch.path()))
            REQUIRE(lchown(entry.path().c_str(), user, user) == 0);
    };
    leave_temporaries_in(scratch.path());
    give_all_to(1234);
    CHECK(fs::exists(Temporary(Kind::file, scratch.path()).path()));
    CHECK(entries_in(scratch.path()) == 2);
    give_all_to(first_lone_user + 5);
    CHECK(fs::exists(Temporary(Kind::file, scratch.path()).path()));
    CHECK(entries_in(scratch.path()) == 0);
}
