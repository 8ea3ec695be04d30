#include "raylab/base/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace raylab {

namespace {

constexpr auto patience = std::chrono::milliseconds(200);  // shorter work needs no bar
constexpr auto interval = std::chrono::milliseconds(100);
constexpr std::size_t cells = 30;

}  // namespace

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)),
      total_(total),
      next_(std::chrono::steady_clock::now() + patience),
      on_terminal_(!label_.empty() && total > 0 && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (drawn_) std::fputs("\r\x1b[2K", stderr);
}

void Progress::step(std::size_t by) {
    const auto done = done_ += by;
    if (!on_terminal_) return;
    const std::unique_lock lock(drawing_, std::try_to_lock);
    if (!lock || std::chrono::steady_clock::now() < next_) return;
    draw(done);
}

void Progress::draw(std::size_t done) {
    const auto filled = cells * done / total_;
    const std::string bar = std::string(filled, '=') + std::string(cells - filled, ' ');
    std::fprintf(stderr, "\r\x1b[2K%s [%s] %zu %%", label_.c_str(), bar.c_str(), 100 * done / total_);
    std::fflush(stderr);
    next_ = std::chrono::steady_clock::now() + interval;
    drawn_ = true;
}

}  // namespace raylab
