#include "isolated.h"

#include <fmt/format.h>

#include <csignal>
#include <cstring>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vitrine::test {

namespace {

constexpr std::uint64_t numbersPerChild = 5000;
constexpr std::size_t mostFailures = 20;

/// Written by the child, read by its parent after its end.
struct Board {
    std::uint64_t current; ///< under way
    bool threw;
    char what[4096];
    std::uint64_t outcomes[256];
};

class SharedBoard {
  public:
    SharedBoard() {
        void* memory = ::mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) throw std::runtime_error("no shared memory");
        board_ = new (memory) Board{};
    }
    ~SharedBoard() { ::munmap(board_, sizeof(Board)); }
    SharedBoard(const SharedBoard&) = delete;
    SharedBoard& operator=(const SharedBoard&) = delete;
    Board* operator->() { return board_; }

  private:
    Board* board_;
};

void allow(double seconds) {
    itimerval timer{};
    timer.it_value.tv_sec = time_t(seconds);
    timer.it_value.tv_usec = suseconds_t((seconds - double(timer.it_value.tv_sec)) * 1e6);
    ::setitimer(ITIMER_REAL, &timer, nullptr);
}

void limitMemory() {
    // Sanitizers reserve terabytes of addresses.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    const rlimit limit{rlim_t(4) << 30, rlim_t(4) << 30};
    ::setrlimit(RLIMIT_AS, &limit);
#endif
}

/// The child: never returns to the test's own code.
[[noreturn]] void workThrough(SharedBoard& board, std::uint64_t end, double seconds,
                              const std::function<char(std::uint64_t)>& work) {
    limitMemory();
    ::signal(SIGALRM, SIG_DFL);
    for (; board->current < end; ++board->current) {
        allow(seconds);
        try {
            ++board->outcomes[static_cast<unsigned char>(work(board->current))];
        } catch (const std::exception& e) {
            board->threw = true;
            std::strncpy(board->what, e.what(), sizeof board->what - 1);
            ::_exit(1);
        }
    }
    ::_exit(0);
}

std::string causeOf(int status, SharedBoard& board, double seconds) {
    if (board->threw) return board->what;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) return fmt::format("no end after {} seconds", seconds);
    if (WIFSIGNALED(status)) return fmt::format("signal {}", WTERMSIG(status));
    return fmt::format("ended the process with code {}", WEXITSTATUS(status));
}

} // namespace

std::string IsolatedResults::describe() const {
    std::string text;
    for (const auto& [letter, count] : outcomes)
        text += fmt::format("{}: {}; ", letter, count);
    for (const auto& failure : failures)
        text += fmt::format("\nnumber {}: {}", failure.number, failure.what);
    return text;
}

IsolatedResults runIsolated(std::uint64_t count, double seconds, const std::function<char(std::uint64_t)>& work) {
    SharedBoard board;
    IsolatedResults results;
    while (board->current < count && results.failures.size() < mostFailures) {
        const std::uint64_t end = std::min(count, board->current + numbersPerChild);
        const pid_t child = ::fork();
        if (child < 0) throw std::runtime_error("fork failed");
        if (child == 0) workThrough(board, end, seconds, work);
        int status = 0;
        ::waitpid(child, &status, 0);
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && board->current == end) continue;
        results.failures.push_back({board->current, causeOf(status, board, seconds)});
        board->threw = false;
        ++board->current;
    }
    for (int letter = 0; letter < 256; ++letter)
        if (board->outcomes[letter] > 0) results.outcomes[char(letter)] = board->outcomes[letter];
    return results;
}

} // namespace vitrine::test
