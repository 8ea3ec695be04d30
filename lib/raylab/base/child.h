#pragma once

#include "raylab/base/interrupt.h"

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

// The lowest step of base/process.h: fork, exec, wait.

namespace raylab {

/// What a child needs, all of it made before fork(): afterwards only async-signal-safe calls are allowed.
struct Launch {
    std::vector<char*> words;            // ends in a null pointer
    const char* folder;                  // null: where we are
    int input, output, errors, failure;  // output and errors: -1 where they are ours; failure: errno where exec fails
    pid_t parent;
};

/// What a copy of this process does instead of another program, and where its standard output and stderr go.
struct CopyLaunch {
    const std::function<std::string()>& work;  // its result is printed; what an exception says is an error
    int output, errors;
    pid_t parent;
};

/// A started program, as a process group of its own. Whatever is left of the group in the end is killed. An interrupt
/// of ours asks the group to end before it is killed.
class Child {
public:
    explicit Child(const Launch& launch);
    explicit Child(const CopyLaunch& launch);
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child();

    pid_t id() const { return id_; }
    void kill_group() const;

    /// Waits for the end and returns waitpid's status; kills what the program left running.
    int end();

private:
    Child(const Uninterrupted& while_started, const Launch& launch);
    void watch();

    pid_t id_;
    std::optional<AtInterrupt> ending_;  // until the group's id may belong to another
    std::optional<int> status_;
};

}  // namespace raylab
