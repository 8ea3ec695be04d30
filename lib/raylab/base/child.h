#pragma once

#include "raylab/base/interrupt.h"

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

// The lowest layer of base/process.h: fork, exec, wait.

namespace raylab {

/// What a child needs. It is prepared before fork(), because only async-signal-safe calls are allowed afterwards.
struct Launch {
    std::vector<char*> words;  // ends with a null pointer
    const char* folder;        // null: the current folder
    // For output and errors -1 means the parent's own; exec's errno is written to `failure`.
    int input, output, errors, failure;
    pid_t parent;
};

/// What a copy of this process does instead of running another program, and where its standard output and stderr go.
struct CopyLaunch {
    const std::function<std::string()>& work;  // its result is printed; the text of an exception goes to stderr
    int output, errors;
    pid_t parent;
};

/// A started program, in a process group of its own. Whatever is left of the group at the end is killed. An interrupt
/// of this process asks the group to end before it is killed.
class Child {
public:
    explicit Child(const Launch& launch);
    explicit Child(const CopyLaunch& launch);
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child();

    pid_t id() const { return id_; }
    void kill_group() const;

    /// Waits for the end and returns waitpid's status; kills processes that the program left running.
    int end();

    /// The processor's time that the program took, with those that it waited for; known at its end.
    double cpu_seconds() const { return cpu_seconds_; }

private:
    Child(const Uninterrupted& while_started, const Launch& launch);
    void watch();

    pid_t id_;
    std::optional<AtInterrupt> ending_;  // exists until the group's id may belong to another process
    std::optional<int> status_;
    double cpu_seconds_ = 0;
};

}  // namespace raylab
