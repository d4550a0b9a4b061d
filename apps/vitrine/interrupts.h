// Ctrl-C and SIGTERM: the first asks the render to finish its pass and save; the second ends the program at once.
#pragma once

/// From now on SIGINT and SIGTERM are noted instead of killing.
void catchInterrupts();
/// Whether one came since.
bool interrupted();
