#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace raylab {

/// ", 2 min left": estimated from the seconds that this share of the work took. Nothing where less than one is left.
std::string time_left(double seconds, double share);

/// A progress bar on stderr for long work, with the time left. It is shown only on a terminal, after a fifth of a
/// second, is updated at most ten times a second, and is erased at the end. step() may be called from any thread.
class Progress {
public:
    Progress(std::string label, std::size_t total);  // an empty label shows nothing
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void step(std::size_t by = 1);

private:
    void draw(std::size_t done);

    std::string label_;
    std::size_t total_;
    std::atomic<std::size_t> done_ = 0;
    std::mutex drawing_;
    std::chrono::steady_clock::time_point begun_, next_;
    bool on_terminal_;
    bool drawn_ = false;
};

}  // namespace raylab
