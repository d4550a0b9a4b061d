#include "nodes/parameter_writer.h"

#include <fmt/format.h>

namespace vitrine {

namespace {

constexpr std::size_t lineLength = 120;

/// Appends words, beginning a line where the next would not fit.
class WordWrap {
  public:
    WordWrap(std::string& text, std::size_t column, const std::string& indent)
        : text_(text), column_(column), indent_(indent) {}

    void add(std::string_view word) {
        if (column_ + 1 + word.size() > lineLength) {
            text_ += '\n';
            text_ += indent_;
            text_ += "    ";
            column_ = indent_.size() + 4;
        } else {
            text_ += ' ';
            ++column_;
        }
        text_ += word;
        column_ += word.size();
    }

  private:
    std::string& text_;
    std::size_t column_;
    const std::string& indent_;
};

} // namespace

std::string quotedString(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        switch (c) {
        case '"':
        case '\\':
            result += '\\';
            result += c;
            break;
        case '\n':
            result += "\\n";
            break;
        case '\t':
            result += "\\t";
            break;
        case '\r':
            result += "\\r";
            break;
        case '\b':
            result += "\\b";
            break;
        case '\f':
            result += "\\f";
            break;
        default:
            result += c;
        }
    }
    return result + '"';
}

std::string parameterText(const Parameter& parameter, const std::string& indent) {
    std::string text = fmt::format("\"{} {}\" [", typeName(parameter.type), parameter.name);
    WordWrap words(text, indent.size() + text.size(), indent);
    std::visit(
        [&](const auto& values) {
            using Values = std::decay_t<decltype(values)>;
            for (const auto& value : values)
                if constexpr (std::is_same_v<Values, Parameter::Strings>)
                    words.add(quotedString(value));
                else if (parameter.type == ParameterType::Bool)
                    words.add(value != 0 ? "true" : "false");
                else
                    words.add(fmt::format("{}", value));
        },
        parameter.values);
    words.add("]");
    return text;
}

} // namespace vitrine
