#include "raylab/base/standard_streams.h"

#include "catch.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

using namespace raylab;

namespace {

/// The exit code of a copy of this process that starts without some of the three streams.
int exit_code_without(std::initializer_list<int> streams, int (*work)()) {
    const pid_t copy = fork();
    if (copy == 0) {
        for (const int stream : streams) close(stream);
        open_missing_standard_streams();
        _exit(work());
    }
    int status = 0;
    waitpid(copy, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

constexpr int right = 7;

}  // namespace

TEST_CASE("a closed standard input reads as empty, and a file opened later is none of the three streams") {
    CHECK(exit_code_without({0}, [] {
              char byte = 0;
              return read(0, &byte, 1) == 0 && open("/dev/null", O_RDONLY) > 2 ? right : 1;
          }) == right);
}

TEST_CASE("closed output refuses what is written, and a file opened later is none of the three streams") {
    CHECK(exit_code_without({1, 2}, [] {
              for (const int stream : {1, 2})
                  if (write(stream, "x", 1) != -1 || errno != EBADF) return 1;
              return open("/dev/null", O_RDONLY) > 2 ? right : 2;
          }) == right);
    CHECK(exit_code_without({0, 1, 2}, [] { return open("/dev/null", O_RDONLY) > 2 ? right : 1; }) == right);
}

TEST_CASE("streams that are open stay what they are") {
    CHECK(exit_code_without({}, [] {
              for (const int stream : {0, 1, 2})
                  if (fcntl(stream, F_GETFD) < 0) return 1;
              return right;
          }) == right);
}
