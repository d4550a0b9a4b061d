#include "progress.h"

#include "console.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <stdexcept>
#include <sys/ioctl.h>
#include <unistd.h>

namespace {

std::string formatCount(double n) {
    if (n >= 1e9) return fmt::format("{:.2f}G", n / 1e9);
    if (n >= 1e6) return fmt::format("{:.2f}M", n / 1e6);
    if (n >= 1e3) return fmt::format("{:.1f}k", n / 1e3);
    return fmt::format("{:.0f}", n);
}

int terminalWidth() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/// Seconds to go, from the share done in this session; negative while unknown.
double timeLeft(const vitrine::SessionProgress& p, double spentBefore) {
    const double here = p.seconds - spentBefore;
    return p.fraction > 0.001 && here > 0.2 ? here * (1 - p.fraction) / p.fraction : -1;
}

} // namespace

ProgressStyle progressStyle(const std::string& word) {
    if (word == "none") return ProgressStyle::None;
    if (word == "bar") return ProgressStyle::Bar;
    if (word == "json") return ProgressStyle::Json;
    if (word == "auto") return isatty(STDERR_FILENO) ? ProgressStyle::Bar : ProgressStyle::None;
    throw std::invalid_argument("--progress takes auto, bar, json or none");
}

std::string formatSeconds(double seconds) {
    if (seconds < 60) return fmt::format("{:.1f}s", seconds);
    const auto whole = std::llround(seconds);
    if (whole < 3600) return fmt::format("{}m{:02}s", whole / 60, whole % 60);
    return fmt::format("{}h{:02}m{:02}s", whole / 3600, whole / 60 % 60, whole % 60);
}

void ProgressReport::show(const vitrine::SessionProgress& progress) {
    if (style_ == ProgressStyle::Bar) bar(progress);
    if (style_ == ProgressStyle::Json) json(progress);
}

void ProgressReport::bar(const vitrine::SessionProgress& p) {
    // Rounded down: 100 % is said when it is true.
    const int percent = int(std::floor(p.fraction * 100));
    const double left = timeLeft(p, spentBefore_);
    std::string text = fmt::format(" {:3}%  {}", percent, formatSeconds(p.seconds));
    if (p.fraction < 1 && left >= 0) text += " + " + formatSeconds(left);
    text += fmt::format("  {} samples", formatCount(double(p.samples)));
    if (std::isfinite(p.error)) text += fmt::format("  relMSE {:.2g}", p.error);
    const int room = std::clamp(terminalWidth() - int(text.size()) - 4, 0, 40);
    const int filled = int(std::floor(p.fraction * room));
    if (room >= 5) text = fmt::format("[{:=<{}}{:{}}]{}", "", filled, "", room - filled, text);
    tell(fmt::format("\r{}\x1b[K", text));
    lineOpen_ = true;
}

void ProgressReport::json(const vitrine::SessionProgress& p) const {
    nlohmann::ordered_json line{
        {"fraction", p.fraction}, {"passes", p.passesDone}, {"samples", p.samples}, {"elapsed", p.seconds}};
    if (const double left = timeLeft(p, spentBefore_); left >= 0) line["eta"] = left;
    if (std::isfinite(p.error)) line["relMSE"] = p.error;
    tellLine("{}", line.dump());
}

void ProgressReport::finish() {
    if (lineOpen_) tell("\n");
    lineOpen_ = false;
}
