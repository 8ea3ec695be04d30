#pragma once

#include <map>
#include <optional>
#include <vector>

namespace raylab::bench {

/// How long the same work took, again and again.
class Timings {
public:
    /// The processor to which the work was bound; absent: it ran wherever there was room.
    void add(std::optional<int> processor, double seconds) { seconds_[processor].push_back(seconds); }

    /// The median; of work that was bound to several processors in turns, the harmonic mean of each one's median: at
    /// the mean of their speeds it takes that long.
    double typical() const;
    double shortest() const;
    double longest() const;

private:
    std::map<std::optional<int>, std::vector<double>> seconds_;
};

}  // namespace raylab::bench
