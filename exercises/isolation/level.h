#pragma once

#include <string>

// How far a process with foreign code is kept apart from everything else. Each level contains the ones before it.

namespace raylab::grading {

enum class Level {
    limits = 1,        // memory, processor seconds, sizes of files and numbers of processes are bounded
    system_calls = 2,  // seccomp: no network, no ptrace, no signals to others; a program that is asked opens no file
    files = 3,         // Landlock: only the files that are named can be opened, whoever owns them
};

/// The level that a check works at, and what else this machine adds to it.
struct Isolation {
    Level level = Level::limits;
    int landlock = 0;       // the version of the kernel's interface; 0: not used
    bool own_user = false;  // started by root: the process runs as a user that owns nothing else

    friend bool operator==(const Isolation&, const Isolation&) = default;
};

/// The highest level that this kernel offers.
Isolation best_isolation();

/// Exactly this level, or an Error that says what the machine lacks: a check never falls back silently.
Isolation isolation_at(Level level);

/// "level 3 (Landlock 7, seccomp, limits, a user of its own)".
std::string to_string(const Isolation& isolation);

}  // namespace raylab::grading
