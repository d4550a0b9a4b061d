// Reading of flags that hold several values.
#pragma once

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// `count` numbers separated by `separator`. \throws std::invalid_argument that names the flag
template <class T>
std::vector<T> numbers(const std::string& text, char separator, std::size_t count, const std::string& flag) {
    std::vector<T> values;
    std::string item;
    std::istringstream in(text);
    while (std::getline(in, item, separator)) {
        std::istringstream number(item);
        T value;
        if (!(number >> value) || !(number >> std::ws).eof()) break;
        values.push_back(value);
    }
    if (values.size() != count || text.ends_with(separator))
        throw std::invalid_argument(
            fmt::format("{} takes {} numbers separated by '{}', not \"{}\"", flag, count, separator, text));
    return values;
}
