// Standard output and standard error: what cannot be told there must not undo what was computed.
#pragma once

#include <fmt/format.h>

#include <string>

/// Makes writes to a closed pipe fail instead of killing, and keeps files from being opened as standard streams that
/// were closed: messages would go into them.
void guardStandardStreams();

/// To standard output. \throws vitrine::FileError
void printOut(const std::string& text);
/// What was printed has left the program. \throws vitrine::FileError
void flushOutput();

/// To standard error, at once. Where that leads nowhere the text is lost.
void tell(const std::string& text);

/// A line on standard error.
template <class... T>
void tellLine(fmt::format_string<T...> format, T&&... arguments) {
    tell(fmt::format(format, std::forward<T>(arguments)...) + "\n");
}
