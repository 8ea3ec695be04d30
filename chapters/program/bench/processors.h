#pragma once

#include <sched.h>

#include <optional>
#include <vector>

namespace raylab::bench {

/// The numbers of the processors on which the calling thread may run.
std::vector<int> usable_processors();

/// As long as it lives, the calling thread runs on one processor alone, if one is named and the system lets it; so do
/// threads that it starts meanwhile.
class OnProcessor {
public:
    explicit OnProcessor(std::optional<int> processor);
    ~OnProcessor();
    OnProcessor(const OnProcessor&) = delete;
    OnProcessor& operator=(const OnProcessor&) = delete;

private:
    cpu_set_t before_;
    bool is_bound_ = false;
};

}  // namespace raylab::bench
