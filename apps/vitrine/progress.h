// The progress bar on a terminal, or lines of JSON for programs.
#pragma once

#include "render/session.h"

#include <string>

enum class ProgressStyle { None, Bar, Json };

/// "auto": a bar on a terminal, nothing elsewhere. \throws std::invalid_argument for other words than the four
ProgressStyle progressStyle(const std::string& word);

class ProgressReport {
  public:
    ProgressReport(ProgressStyle style, double spentBefore) : style_(style), spentBefore_(spentBefore) {}

    /// Shows the state, on standard error. The bar says 100 % only at the very end.
    void show(const vitrine::SessionProgress& progress);
    /// Ends the bar's line.
    void finish();

  private:
    void bar(const vitrine::SessionProgress& progress);
    void json(const vitrine::SessionProgress& progress) const;

    ProgressStyle style_;
    double spentBefore_; ///< seconds of earlier sessions
    bool lineOpen_ = false;
};

/// "1h02m03s", "4m05s", "6.7s"
std::string formatSeconds(double seconds);
