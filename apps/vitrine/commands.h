// The subcommands. Each function adds one to the command line; its callback does the work and throws on errors, which
// main() turns into messages and exit codes.
#pragma once

#include <CLI/CLI.hpp>

void registerRender(CLI::App& app, int& exitCode);
void registerInfo(CLI::App& app);
void registerDiff(CLI::App& app);
void registerConvert(CLI::App& app);
void registerMerge(CLI::App& app);
void registerMesh(CLI::App& app);
void registerProfile(CLI::App& app);

/// What the user asked for exists in the manual but not yet in this version (exit code 1).
class NotYetSupported : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};
