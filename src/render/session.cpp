#include "render/session.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <condition_variable>
#include <mutex>
#include <thread>

namespace vitrine {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Calls a function several times a second until destroyed. It only shows progress: nothing of the picture passes here.
class Ticker {
  public:
    explicit Ticker(std::function<void()> tick) {
        thread_ = std::thread([this, tick = std::move(tick)] {
            std::unique_lock lock(mutex_);
            while (!wake_.wait_for(lock, std::chrono::milliseconds(200), [this] { return done_; }))
                tick();
        });
    }
    ~Ticker() {
        {
            const std::lock_guard lock(mutex_);
            done_ = true;
        }
        wake_.notify_all();
        thread_.join();
    }
    Ticker(const Ticker&) = delete;
    Ticker& operator=(const Ticker&) = delete;

  private:
    std::mutex mutex_;
    std::condition_variable wake_;
    bool done_ = false;
    std::thread thread_;
};

/// How many passes to do before looking up again: about half a second's worth, and never past the time limit.
std::uint64_t chunkSize(std::uint64_t doneHere, double seconds, double timeLimit) {
    if (doneHere == 0) return 1;
    const double aPass = std::max(seconds, 1e-6) / double(doneHere);
    double budget = 0.5;
    if (timeLimit > 0) budget = std::min(budget, timeLimit - seconds);
    return std::uint64_t(std::clamp(budget / aPass, 1., 4096.));
}

} // namespace

void Session::refuseGaps(const PassRange& passes) const {
    if (integrator_.passesAreIndependent()) return;
    const auto& done = state_.passes.ranges();
    const bool fromStart = done.empty() || (done.size() == 1 && done.front().begin == 0);
    if (!fromStart || passes.begin > state_.passes.size())
        throw std::invalid_argument(fmt::format(
            "passes {}:{} cannot be rendered on their own: with these settings each pass builds on those before it, "
            "and "
            "{}",
            passes.begin, passes.end,
            done.empty() ? "there are none" : fmt::format("the checkpoint holds {}", state_.passes.toString())));
}

std::optional<FileError> Session::saveState(const SessionOptions& options) {
    state_.integratorState = integrator_.saveState();
    if (options.checkpointFile.empty()) return {};
    try {
        writePartial(options.checkpointFile, state_, film_);
    } catch (const FileError& e) {
        return e;
    }
    return {};
}

SessionEnd Session::run(const SessionOptions& options, const std::function<void(const SessionProgress&)>& report,
                        const std::function<bool()>& interrupted) {
    refuseGaps(options.passes);
    if (!state_.integratorState.empty()) integrator_.restoreState(state_.integratorState);
    const auto start = Clock::now();
    const double earlier = state_.seconds;
    const V2i size = film_.settings().cropSize();
    const double pixels = double(size.x) * double(size.y);
    const std::vector<PassRange> missing = state_.passes.missingFrom(options.passes);
    std::uint64_t toDo = 0;
    for (const auto& range : missing)
        toDo += range.size();

    std::atomic<double> error{infinityD};
    const auto progress = [&] {
        SessionProgress p;
        const double seconds = secondsSince(start);
        p.samples = counters_.samples.load(std::memory_order_relaxed);
        p.seconds = earlier + seconds;
        const double already = double(options.passes.size() - toDo);
        p.fraction = (already + double(p.samples) / pixels) / double(std::max<std::uint64_t>(1, options.passes.size()));
        if (options.timeLimit > 0) p.fraction = std::max(p.fraction, seconds / options.timeLimit);
        p.fraction = std::min(p.fraction, 0.9999);
        p.passesDone = std::uint64_t(already + double(p.samples) / pixels);
        p.error = error.load();
        return p;
    };

    // More threads than processors are the user's wish: without this, TBB would quietly give fewer.
    std::optional<tbb::global_control> limit;
    if (options.threads > 0) limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    std::uint64_t doneHere = 0;
    double lastCheckpoint = 0;
    SessionEnd end = SessionEnd::Done;
    const auto stopReason = [&]() -> std::optional<SessionEnd> {
        if (interrupted()) return SessionEnd::Interrupted;
        if (options.timeLimit > 0 && secondsSince(start) >= options.timeLimit) return SessionEnd::TimeLimit;
        if (options.errorLimit > 0 && error.load() <= options.errorLimit) return SessionEnd::ErrorLimit;
        return {};
    };
    {
        const Ticker ticker([&] { report(progress()); });
        for (const auto& range : missing) {
            std::optional<SessionEnd> reason;
            for (std::uint64_t at = range.begin; at < range.end;) {
                if (doneHere > 0 && (reason = stopReason())) break;
                std::uint64_t n = std::min(chunkSize(doneHere, secondsSince(start), options.timeLimit), range.end - at);
                // The error is looked at between chunks: never more than as many passes again without a look.
                if (options.errorLimit > 0) n = std::min(n, std::max<std::uint64_t>(1, doneHere));
                arena.execute([&] { integrator_.addPasses(world_, {at, at + n}, film_, counters_); });
                state_.passes.add({at, at + n});
                state_.seconds = earlier + secondsSince(start);
                at += n;
                doneHere += n;
                if (options.errorLimit > 0) error = film_.estimatedRelMse();
                if (!options.checkpointFile.empty() &&
                    secondsSince(start) - lastCheckpoint >= options.checkpointInterval) {
                    if (const auto trouble = saveState(options)) options.checkpointFailed(*trouble);
                    lastCheckpoint = secondsSince(start);
                }
            }
            if (reason) {
                end = *reason;
                break;
            }
        }
    }
    saveError_ = saveState(options);
    SessionProgress last = progress();
    last.passesDone = state_.passes.size();
    if (end != SessionEnd::Interrupted) last.fraction = 1;
    report(last);
    return end;
}

} // namespace vitrine
