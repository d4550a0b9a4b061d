// What `vitrine render` writes: one file that fails must not take the others along.
#pragma once

#include "console.h"
#include "render/session.h"
#include "scene/scene.h"

/// Finds out before hours of rendering, not after, that a file could not be written. \throws vitrine::FileError
void checkWritable(const std::string& file);
/// The same for a picture. \throws std::invalid_argument for a name of no image format
void checkPicture(const std::string& file);

/// Writes files one after the other and remembers whether all went well.
class FileWriter {
  public:
    /// False when the file could not be written, which has then been told.
    template <class Write>
    bool attempt(Write&& write) {
        try {
            write();
            return true;
        } catch (const vitrine::FileError& e) {
            fail(e);
            return false;
        }
    }
    void fail(const vitrine::FileError& e) {
        tellLine("vitrine: {}", e.what());
        failed_ = true;
    }
    bool failed() const { return failed_; }

  private:
    bool failed_ = false;
};

/// Figures about a session as JSON. \throws vitrine::FileError
void writeStats(const std::string& file, const vitrine::Scene& scene, const vitrine::Film& film,
                const vitrine::PartialRender& state, const vitrine::RenderCounters& counters, double seconds);
