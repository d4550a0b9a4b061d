// A render under way: passes in chunks, stop rules, checkpoints.
#pragma once

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
};

struct SessionProgress {
    double fraction = 0;       ///< of the passes asked for, or of the time; 1 only when done
    double seconds = 0;        ///< rendering time, earlier sessions included
    std::uint64_t samples = 0; ///< camera samples this session
    std::uint64_t passesDone = 0;
    std::uint64_t lostExits = 0; ///< RenderCounters::lostExits, this session
    double error = infinityD;    ///< estimated relMSE; infinite while unknown or not asked for
};

enum class SessionEnd { Done, TimeLimit, ErrorLimit, Interrupted };

class Session {
  public:
    /// \param state what the film already holds (a resumed checkpoint) or an empty one with fingerprint and name
    Session(const World& world, Integrator& integrator, Film& film, PartialRender& state)
        : world_(world), integrator_(integrator), film_(film), state_(state) {}

    /// Adds the passes that are missing. `interrupted` is asked between chunks: the chunk under way is finished, so
    /// the film always holds whole passes. \throws FileError when a checkpoint cannot be written (the film stays valid)
    SessionEnd run(const SessionOptions& options, const std::function<void(const SessionProgress&)>& report,
                   const std::function<bool()>& interrupted);

  private:
    const World& world_;
    Integrator& integrator_;
    Film& film_;
    PartialRender& state_;
};

} // namespace vitrine
