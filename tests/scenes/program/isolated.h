// Runs many small pieces of work in child processes, so that a crash or a hang of one is found, named and outlived.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace vitrine::test {

struct IsolatedResults {
    struct Failure {
        std::uint64_t number;
        std::string what; ///< what the work threw, or "signal 11", "no end after 10 seconds", ...
    };
    std::vector<Failure> failures;
    std::map<char, std::uint64_t> outcomes; ///< how often the work returned each letter

    /// The first failures, for the message of a test.
    std::string describe() const;
};

/// Runs work(number) for every number of [0, count) in order, each child process doing many. What the work returns is
/// counted; what it throws, a signal that ends it, more than `seconds` or more than 4 GB of memory are failures. Gives up
/// after 20 failures. To be called in a process that
/// has not used TBB: a fork does not copy its threads.
IsolatedResults runIsolated(std::uint64_t count, double seconds, const std::function<char(std::uint64_t)>& work);

} // namespace vitrine::test
