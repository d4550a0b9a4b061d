#include "nodes/svg_path.h"

#include "nodes/svg_outline.h"
#include "nodes/svg_scanner.h"

#include <fmt/format.h>

#include <cctype>

namespace vitrine {

namespace {

constexpr std::string_view commands = "MLHVQCSTAZ";

std::size_t argumentCount(char command) {
    switch (command) {
    case 'H':
    case 'V':
        return 1;
    case 'M':
    case 'L':
    case 'T':
        return 2;
    case 'Q':
    case 'S':
        return 4;
    case 'C':
        return 6;
    case 'A':
        return 7;
    default:
        return 0;
    }
}

class PathReader {
  public:
    explicit PathReader(std::string_view data) : scan_(data) {}

    SvgPath read() {
        scan_.skipBlanks();
        if (scan_.atEnd()) throw SvgTextError(0, 1, "the path is empty");
        for (; !scan_.atEnd(); scan_.skipBlanks())
            readCommand();
        return outline_.take();
    }

  private:
    /// A letter and its arguments, as many times as there are.
    void readCommand() {
        letterAt_ = scan_.offset();
        letter_ = scan_.peek();
        char command = char(std::toupper(static_cast<unsigned char>(letter_)));
        if (commands.find(command) == std::string_view::npos) refuseLetter();
        if (!begun_ && command != 'M')
            throw SvgTextError(letterAt_, 1, fmt::format("a path begins with \"M\", not \"{}\"", letter_));
        scan_.take();
        begun_ = true;
        if (command == 'Z') return close();
        scan_.skipBlanks();
        std::size_t from = letterAt_;
        do {
            readArguments(command);
            outline_.setSource(from, scan_.offset() - from);
            draw(command);
            if (command == 'M') { // further pairs are lines (SVG 2, 9.3.3)
                command = 'L';
                letter_ = isRelative() ? 'l' : 'L';
            }
            scan_.skipSeparator();
            from = scan_.offset();
        } while (scan_.startsNumber());
    }

    [[noreturn]] void refuseLetter() const {
        if (scan_.startsNumber())
            scan_.refuseNext(begun_ ? "a path command (\"Z\" takes no numbers)" : "\"M\", with which a path begins");
        try {
            scan_.refuseNext("a path command");
        } catch (SvgTextError& error) {
            error.hint = "the commands are M L H V Q C S T A Z and their lower case";
            throw;
        }
    }

    void readArguments(char command) {
        const std::size_t n = argumentCount(command);
        for (std::size_t i = 0; i < n; ++i) {
            if (i > 0) scan_.skipSeparator();
            const bool isFlag = command == 'A' && (i == 3 || i == 4);
            if (!(isFlag ? scan_.startsFlag() : scan_.startsNumber()))
                scan_.refuseNext(fmt::format("{} {} of {} of \"{}\"", isFlag ? "a flag, 0 or 1, as number" : "number",
                                             i + 1, n, letter_));
            arguments_[i] = isFlag ? double(scan_.flag()) : scan_.number();
        }
    }

    bool isRelative() const { return letter_ >= 'a'; }
    V2d point(std::size_t i) const {
        const V2d p(arguments_[i], arguments_[i + 1]);
        return isRelative() ? outline_.at() + p : p;
    }
    /// The control point before this one mirrored in the current point, if the command before drew one of its kind.
    V2d reflected(char kind) const { return previous_ == kind ? outline_.at() * 2. - control_ : outline_.at(); }

    void draw(char command) {
        const V2d at = outline_.at();
        char kind = 0;
        switch (command) {
        case 'M':
            outline_.moveTo(point(0));
            break;
        case 'L':
            outline_.lineTo(point(0));
            break;
        case 'H':
            outline_.lineTo(V2d(arguments_[0] + (isRelative() ? at.x : 0), at.y));
            break;
        case 'V':
            outline_.lineTo(V2d(at.x, arguments_[0] + (isRelative() ? at.y : 0)));
            break;
        case 'Q':
        case 'T': {
            kind = 'Q';
            const V2d control = command == 'Q' ? point(0) : reflected(kind);
            outline_.quadTo(control, point(command == 'Q' ? 2 : 0));
            control_ = control;
            break;
        }
        case 'C':
        case 'S': {
            kind = 'C';
            const std::size_t second = command == 'C' ? 2 : 0;
            const V2d control = point(second);
            outline_.cubicTo(command == 'C' ? point(0) : reflected(kind), control, point(second + 2));
            control_ = control;
            break;
        }
        default:
            outline_.arcTo(V2d(arguments_[0], arguments_[1]), arguments_[2], arguments_[3] != 0, arguments_[4] != 0,
                           point(5));
        }
        previous_ = kind;
    }

    void close() {
        outline_.setSource(letterAt_, 1);
        outline_.close();
        previous_ = 0;
    }

    SvgScanner scan_;
    SvgOutline outline_;
    std::array<double, 7> arguments_{};
    char letter_ = 0;
    std::size_t letterAt_ = 0;
    char previous_ = 0; ///< 'Q' or 'C' when the command before drew such a curve
    V2d control_{0, 0}; ///< its last control point but one
    bool begun_ = false;
};

} // namespace

SvgPath readSvgPath(std::string_view data) {
    return PathReader(data).read();
}

} // namespace vitrine
