#pragma once

#include <string>
#include <vector>

// Answers to exercise 02 that attack: the check, the machine, or whoever believes what they print.

namespace attacks {

/// What an answer does, and what a check has to say of it. An act that must not succeed ends in got_through(), which
/// makes a crash of it; where it is refused, the answer is wrong.
struct Attack {
    std::string name;
    int from;                           // the lowest level of isolation that holds it off
    std::vector<std::string> verdicts;  // those that are right
    std::string body;                   // of the function
    std::string before = {};            // what stands in front of it
};

/// Acts on files, other processes, the network and the machine.
std::vector<Attack> acts();

/// Ways not to answer: to end early, to crash, to take too long or too much, to print verdicts.
std::vector<Attack> bad_ends();

/// Files that the compiler must not take.
std::vector<Attack> sources();

}  // namespace attacks
