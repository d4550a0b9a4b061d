// A render under way: passes in chunks, stop rules, checkpoints.
#pragma once

#include "core/errors.h"
#include "render/partial.h"

#include <chrono>
#include <functional>

namespace vitrine {

/// When to stop, and what to save on the way. The picture after a given set of passes depends on none of this.
struct SessionOptions {
    PassRange passes{0, 1};
    double timeLimit = 0;           ///< seconds of rendering in this session; 0: none
    double errorLimit = 0;          ///< estimated relMSE at which to stop; 0: none
    int threads = 0;                ///< 0: all
    std::string checkpointFile;     ///< empty: none
    double checkpointInterval = 60; ///< seconds
    /// Told of a checkpoint on the way that could not be written. The render goes on, and the next one is tried.
    std::function<void(const FileError&)> checkpointFailed = [](const FileError&) {};
};

struct SessionProgress {
    double fraction = 0;       ///< of the passes asked for, or of the time; 1 only when done
    double seconds = 0;        ///< rendering time, earlier sessions included
    std::uint64_t samples = 0; ///< camera samples this session
    std::uint64_t passesDone = 0;
    double error = infinityD; ///< estimated relMSE; infinite while unknown or not asked for
};

enum class SessionEnd { Done, TimeLimit, ErrorLimit, Interrupted };

class Session {
  public:
    /// \param state what the film already holds (a resumed checkpoint) or an empty one with fingerprint and name
    Session(const World& world, Integrator& integrator, Film& film, PartialRender& state)
        : world_(world), integrator_(integrator), film_(film), state_(state) {}

    /// Adds the passes that are missing. `interrupted` is asked between chunks: the chunk under way is finished, so
    /// the film always holds whole passes. \throws std::invalid_argument for passes that cannot be added to the state:
    /// see Integrator::passesAreIndependent()
    SessionEnd run(const SessionOptions& options, const std::function<void(const SessionProgress&)>& report,
                   const std::function<bool()>& interrupted);

    /// Of the passes of run().
    const RenderCounters& counters() const { return counters_; }
    /// Why the state that run() left is not in the checkpoint's file; nothing if it is, or none was asked for.
    const std::optional<FileError>& saveError() const { return saveError_; }

  private:
    void refuseGaps(const PassRange& passes) const;
    std::optional<FileError> saveState(const SessionOptions& options);

    const World& world_;
    Integrator& integrator_;
    Film& film_;
    PartialRender& state_;
    RenderCounters counters_;
    std::optional<FileError> saveError_;
};

} // namespace vitrine
