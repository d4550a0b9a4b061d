// Runs the built program as a user would: its own process, its output and its exit code.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <sys/resource.h>
#include <sys/types.h>
#include <vector>

namespace vitrine::test {

struct ProgramResult {
    int exitCode = -1; ///< -1 unless the program ended by itself
    int signal = 0;    ///< that ended it, if one did
    bool timedOut = false;
    /// Bytes that it held at most. Linux counts what this process held when it started it, too: more than that is its own.
    std::uint64_t peakMemory = 0;
    std::string out, err;

    /// For messages of failed tests.
    std::string describe() const;
};

struct RunSettings {
    std::string folder{}; ///< to run in; empty: the test's own
    std::string input{};  ///< on standard input
    double timeout = 60;  ///< seconds, then it is killed
};

/// A program that is running. It is killed when this goes out of scope.
class RunningProgram {
  public:
    RunningProgram(const std::vector<std::string>& arguments, const RunSettings& settings = {});
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    void send(int signal) const;
    /// Whether it has a handler for the signal by now.
    bool catches(int signal) const;
    /// What it has written so far.
    std::string errorsSoFar() const;
    /// Whether it has ended; does not wait.
    bool ended();
    /// Waits for its end.
    ProgramResult wait();

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    using File = std::unique_ptr<std::FILE, Close>;

    File in_, out_, err_;
    pid_t pid_ = -1;
    int status_ = 0;
    rusage usage_{};
    bool reaped_ = false;
    std::chrono::steady_clock::time_point deadline_;
};

/// `vitrine ARGUMENTS...` from start to end.
ProgramResult runVitrine(const std::vector<std::string>& arguments, const RunSettings& settings = {});

} // namespace vitrine::test
