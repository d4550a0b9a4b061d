#include "console.h"

#include "core/errors.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

void guardStandardStreams() {
    std::signal(SIGPIPE, SIG_IGN);
    // Not for writing: it stays an error, as it would be on a closed stream.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0) (void)open("/dev/null", O_RDONLY);
}

void printOut(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
        throw vitrine::FileError("standard output", std::string("cannot be written: ") + std::strerror(errno));
}

void flushOutput() {
    if (std::fflush(stdout) != 0)
        throw vitrine::FileError("standard output", std::string("cannot be written: ") + std::strerror(errno));
}

void tell(const std::string& text) {
    (void)std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}
