// vitrine: the command line. Only this folder prints and exits.
//
// Exit codes: 0 done; 1 the scene or an argument is wrong; 2 could not read or write; 3 stopped by a signal, what was
// computed is saved; 4 out of memory or an internal fault.
#include "commands.h"
#include "console.h"
#include "core/errors.h"

#include <fmt/format.h>

#include <csignal>
#include <new>
#include <sstream>

namespace {

enum ExitCode { done = 0, wrongInput = 1, fileTrouble = 2, outOfMemoryOrFault = 4 };

int fail(ExitCode code, const std::string& message) {
    tellLine("{}", message);
    return code;
}

/// What may have been meant by an argument that CLI11 does not know, or "".
std::string meant(const CLI::App& app, const CLI::App& command, const std::string& argument) {
    std::vector<std::string> names;
    if (argument.starts_with("-"))
        for (const CLI::Option* option : command.get_options())
            for (const auto& name : option->get_lnames())
                names.push_back("--" + name);
    else if (&app == &command)
        for (const CLI::App* each : app.get_subcommands({}))
            names.push_back(each->get_name());
    return vitrine::didYouMean(argument.substr(0, argument.find('=')), names);
}

int explain(const CLI::App& app, const CLI::ParseError& error) {
    const auto chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    const std::vector<std::string> unknown = command.remaining();
    if (unknown.empty()) {
        tellLine("vitrine: {}", error.what());
    } else {
        const bool isCommand = chosen.empty() && !unknown.front().starts_with("-");
        tellLine("vitrine: unknown {} \"{}\"", isCommand ? "command" : "argument", unknown.front());
        if (const std::string hint = meant(app, command, unknown.front()); !hint.empty()) tellLine("    {}", hint);
    }
    if (chosen.empty())
        tellLine("Run \"vitrine --help\" for the commands.");
    else
        tellLine("Run \"vitrine {} --help\" for its arguments.", command.get_name());
    return wrongInput;
}

/// Commands of the manual that a later version has.
void registerLater(CLI::App& app) {
    for (const char* name : {"denoise"}) {
        auto* command = app.add_subcommand(name, "Not yet supported");
        command->allow_extras();
        command->callback(
            [name] { throw NotYetSupported(fmt::format("the command \"{}\" is not yet supported", name)); });
    }
}

int run(int argc, char** argv) {
    CLI::App app("Vitrine renders light through glass and off metal.", "vitrine");
    app.set_version_flag("--version", VITRINE_VERSION);
    app.require_subcommand(1);
    app.failure_message(CLI::FailureMessage::help);
    int exitCode = done;
    registerRender(app, exitCode);
    registerInfo(app);
    registerDiff(app);
    registerConvert(app);
    registerMerge(app);
    registerMesh(app);
    registerProfile(app);
    registerLater(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        // Help and version are no errors; everything else that CLI11 finds is a wrong argument.
        if (e.get_exit_code() != 0) return explain(app, e);
        std::ostringstream text;
        app.exit(e, text);
        printOut(text.str());
    }
    flushOutput();
    return exitCode;
}

} // namespace

int main(int argc, char** argv) {
    // Writing past a limit on file sizes shall fail with a message, not kill.
    std::signal(SIGXFSZ, SIG_IGN);
    guardStandardStreams();
    try {
        return run(argc, argv);
    } catch (const vitrine::SceneError& e) {
        return fail(wrongInput, e.what());
    } catch (const NotYetSupported& e) {
        return fail(wrongInput, fmt::format("vitrine: {}", e.what()));
    } catch (const std::invalid_argument& e) {
        return fail(wrongInput, fmt::format("vitrine: {}", e.what()));
    } catch (const vitrine::FileError& e) {
        return fail(fileTrouble, fmt::format("vitrine: {}", e.what()));
    } catch (const std::bad_alloc&) {
        return fail(outOfMemoryOrFault, "vitrine: out of memory");
    } catch (const std::exception& e) {
        return fail(outOfMemoryOrFault, fmt::format("vitrine: internal fault: {}", e.what()));
    }
}
