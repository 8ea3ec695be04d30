#include "raylab/base/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace raylab {

namespace {

constexpr auto patience = std::chrono::milliseconds(200);  // shorter work needs no bar
constexpr auto interval = std::chrono::milliseconds(100);
constexpr std::size_t cells = 30;

}  // namespace

std::string time_left(double seconds, double share) {
    if (!(share > 0)) return "";
    const double left = seconds * (1 - share) / share;
    if (left < 1) return "";
    if (left < 100) return fmt::format(", {:.0f} s left", left);
    if (left < 100 * 60) return fmt::format(", {:.0f} min left", left / 60);
    return fmt::format(", {:.0f} h left", left / 3600);
}

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)),
      total_(total),
      begun_(std::chrono::steady_clock::now()),
      next_(begun_ + patience),
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
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begun_;
    const double share = static_cast<double>(done) / static_cast<double>(total_);
    std::fprintf(stderr, "\r\x1b[2K%s [%s] %zu %%%s", label_.c_str(), bar.c_str(), 100 * done / total_,
                 time_left(spent.count(), share).c_str());
    std::fflush(stderr);
    next_ = std::chrono::steady_clock::now() + interval;
    drawn_ = true;
}

}  // namespace raylab
