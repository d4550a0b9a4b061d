#include "support/run_program.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace vitrine::test {

namespace {

std::string contentOf(std::FILE* file) {
    std::string text;
    char block[4096];
    off_t at = 0;
    // pread: the child shares the file's position.
    for (ssize_t n; (n = ::pread(fileno(file), block, sizeof block, at)) > 0; at += n)
        text.append(block, std::size_t(n));
    return text;
}

} // namespace

std::string ProgramResult::describe() const {
    std::string text = timedOut ? "timed out"
                       : signal ? "ended by signal " + std::to_string(signal)
                                : "exit code " + std::to_string(exitCode);
    return text + "\n--- standard output\n" + out + "--- standard error\n" + err + "---\n";
}

RunningProgram::RunningProgram(const std::vector<std::string>& arguments, const RunSettings& settings)
    : in_(std::tmpfile()), out_(std::tmpfile()), err_(std::tmpfile()),
      deadline_(std::chrono::steady_clock::now() + std::chrono::microseconds(std::int64_t(settings.timeout * 1e6))) {
    if (!in_ || !out_ || !err_) throw std::runtime_error("no temporary file can be made");
    std::fwrite(settings.input.data(), 1, settings.input.size(), in_.get());
    std::fflush(in_.get());
    std::vector<char*> argv{const_cast<char*>(VITRINE_PROGRAM)};
    for (const auto& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);

    pid_ = ::fork();
    if (pid_ < 0) throw std::runtime_error(std::string("fork: ") + std::strerror(errno));
    if (pid_ > 0) return;
    // The child: only what is safe between fork and exec.
    ::lseek(fileno(in_.get()), 0, SEEK_SET);
    ::dup2(fileno(in_.get()), STDIN_FILENO);
    ::dup2(fileno(out_.get()), STDOUT_FILENO);
    ::dup2(fileno(err_.get()), STDERR_FILENO);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE})
        ::signal(signal, SIG_DFL);
    if (!settings.folder.empty() && ::chdir(settings.folder.c_str()) != 0) ::_exit(126);
    ::execv(argv[0], argv.data());
    ::_exit(127);
}

RunningProgram::~RunningProgram() {
    if (reaped_) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, &status_, 0);
}

void RunningProgram::send(int signal) const {
    if (!reaped_) ::kill(pid_, signal);
}

bool RunningProgram::catches(int signal) const {
    std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("SigCgt:")) return std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1;
    return false;
}

std::string RunningProgram::errorsSoFar() const {
    return contentOf(err_.get());
}

bool RunningProgram::ended() {
    if (!reaped_) reaped_ = ::wait4(pid_, &status_, WNOHANG, &usage_) == pid_;
    return reaped_;
}

ProgramResult RunningProgram::wait() {
    ProgramResult result;
    for (auto pause = std::chrono::microseconds(200); !ended();
         pause = std::min(pause * 2, std::chrono::microseconds(10000))) {
        if (std::chrono::steady_clock::now() > deadline_) {
            result.timedOut = true;
            ::kill(pid_, SIGKILL);
        }
        std::this_thread::sleep_for(pause);
    }
    if (WIFEXITED(status_)) result.exitCode = WEXITSTATUS(status_);
    if (WIFSIGNALED(status_)) result.signal = WTERMSIG(status_);
    result.peakMemory = std::uint64_t(usage_.ru_maxrss) * 1024;
    result.out = contentOf(out_.get());
    result.err = contentOf(err_.get());
    return result;
}

ProgramResult runVitrine(const std::vector<std::string>& arguments, const RunSettings& settings) {
    return RunningProgram(arguments, settings).wait();
}

} // namespace vitrine::test
