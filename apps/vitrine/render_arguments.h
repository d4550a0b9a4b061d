// The flags of `vitrine render`.
#pragma once

#include "integrators/integrator.h"
#include "scene/overrides.h"

#include <CLI/CLI.hpp>

/// When only time or error ends a render: more samples than the samplers tell apart.
constexpr std::uint64_t unlimitedPasses = std::uint64_t(1) << 32;

struct RenderArguments {
    std::string scene;
    std::vector<std::string> outputs;
    vitrine::Overrides overrides;
    std::string spp, passes, resolution, cropWindow, pixelBounds, progress = "auto", seed;
    double time = 0, error = 0, checkpointEvery = 60;
    int threads = 0;
    std::optional<int> textureCache;
    std::string checkpoint, partial, stats;
    bool resume = false, watch = false, denoise = false;
    std::string aov, displayServer;
};

/// Tells CLI11 of all flags.
void addRenderFlags(CLI::App& command, RenderArguments& a);

/// Checks what was given and fills in `overrides`. \throws std::invalid_argument
void readOverrides(RenderArguments& a);

/// The passes that the flags ask for, if they do. \throws std::invalid_argument
std::optional<vitrine::PassRange> askedPasses(const RenderArguments& a);
