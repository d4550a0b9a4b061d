// Errors that know their place in a scene file. Libraries throw them; only apps/ prints and exits.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace vitrine {

/// One text that was read: a scene file, an included file, a string given on the command line.
struct SourceFile {
    std::string name; ///< as the user would write it
    std::string text; ///< kept so that an error can show the line
    std::shared_ptr<const SourceFile> includedFrom;
    int includedAtLine = 0; ///< line of the Include/Import directive in `includedFrom`
};

/// A position in a text. Lines and columns count from 1; line 0 means "the file as a whole". Columns and lengths count
/// bytes, as editors jump to them; what is shown counts characters.
struct Place {
    std::shared_ptr<const SourceFile> file;
    int line = 0;
    int column = 0;
    int length = 1; ///< how many bytes the caret underlines

    explicit operator bool() const { return file != nullptr; }
    /// "file:line:column", or "" for no place.
    std::string toString() const;
};

/// What is wrong, where, and what the reader may have meant.
struct Diagnostic {
    enum class Severity { Warning, Error };
    Severity severity = Severity::Error;
    Place place;
    std::string message;
    std::string hint; ///< "did you mean ...?", or empty

    /// file:line:column: error: message; the line; a caret; the hint; the include chain. Several lines, no final newline.
    std::string toString() const;
};

/// The scene or an argument is wrong (exit code 1). Holds every error found in one run, at least one.
class SceneError : public std::runtime_error {
  public:
    explicit SceneError(std::vector<Diagnostic> diagnostics);
    SceneError(Place place, std::string message, std::string hint = {});

    const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

  private:
    std::vector<Diagnostic> diagnostics_;
};

/// A file could not be read or written (exit code 2).
class FileError : public std::runtime_error {
  public:
    FileError(std::string file, const std::string& message);

    const std::string& file() const { return file_; }

  private:
    std::string file_;
};

/// Collects errors and warnings so that one run shows them all.
class Diagnostics {
  public:
    /// After this many errors reading stops, and no more are kept, nor more warnings: they would bury the first.
    static constexpr std::size_t maxErrors = 20;

    void error(Place place, std::string message, std::string hint = {});
    void warning(Place place, std::string message, std::string hint = {});

    bool hasErrors() const { return errors_ > 0; }
    bool full() const { return errors_ >= maxErrors; }
    const std::vector<Diagnostic>& all() const { return all_; }
    /// Errors and warnings in the order found. \throws SceneError if there is an error.
    void throwIfErrors() const;

  private:
    std::vector<Diagnostic> all_;
    std::size_t errors_ = 0;
};

/// The candidate closest to `word` (Damerau-Levenshtein, case folded), or "" when none is near enough to be meant.
std::string nearestName(const std::string& word, const std::vector<std::string>& candidates);

/// "did you mean "..."?" for the nearest candidate, or "".
std::string didYouMean(const std::string& word, const std::vector<std::string>& candidates);

} // namespace vitrine
