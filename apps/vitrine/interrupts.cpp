#include "interrupts.h"

#include <csignal>

namespace {

volatile std::sig_atomic_t seen = 0;

extern "C" void note(int) {
    seen = 1;
}

} // namespace

void catchInterrupts() {
    struct sigaction action {};
    action.sa_handler = note;
    // The default comes back after the first: a second Ctrl-C is for those who do not want to wait.
    action.sa_flags = int(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
    return seen != 0;
}
