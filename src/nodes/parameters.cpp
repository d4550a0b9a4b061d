#include "nodes/parameters.h"

#include "nodes/hints.h"
#include "nodes/lexer.h"
#include "nodes/parameter_reader.h"
#include "nodes/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine {

namespace {

std::string declaration(ParameterType type, std::string_view name) {
    return fmt::format("\"{} {}\"", typeName(type), name);
}

std::string values(std::size_t n) {
    return n == 1 ? "1 value" : fmt::format("{} values", n);
}

bool isSpectral(ParameterType type) {
    return type == ParameterType::Rgb || type == ParameterType::Blackbody || type == ParameterType::Spectrum;
}

} // namespace

std::size_t Parameter::size() const {
    return std::visit([](const auto& v) { return v.size(); }, values);
}

Place Parameter::valuePlace(std::size_t index) const {
    if (!place) return place;
    Lexer lexer(place, offset);
    // A parameter of the command line has no declaration to skip.
    if (lexer.next().kind != Token::Kind::String) return place;
    if (lexer.peek().kind == Token::Kind::Open) lexer.next();
    for (std::size_t i = 0; i < index; ++i)
        lexer.next();
    const Token token = lexer.peek();
    const bool isValue = token.kind == Token::Kind::Word || token.kind == Token::Kind::String;
    return isValue && index < size() ? lexer.place(token) : place;
}

ParameterSet::ParameterSet(ParameterList own, std::shared_ptr<const ParameterList> defaults, std::string colorSpace,
                           Place place)
    : defaults_(std::move(defaults)), colorSpace_(std::move(colorSpace)), place_(std::move(place)) {
    own_.reserve(own.size());
    for (auto& parameter : own)
        own_.push_back(Entry{std::move(parameter)});
}

ParameterSet::Entry* ParameterSet::ownEntry(std::string_view name) const {
    for (auto& entry : own_)
        if (entry.parameter->name == name) return &entry;
    return nullptr;
}

const Parameter* ParameterSet::lookUp(std::string_view name) const {
    if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) asked_.emplace_back(name);
    if (const Entry* entry = ownEntry(name)) return entry->parameter.get();
    if (defaults_)
        for (const auto& parameter : *defaults_)
            if (parameter->name == name) return parameter.get();
    return nullptr;
}

void ParameterSet::mark(std::string_view name) const {
    if (Entry* entry = ownEntry(name)) entry->read = true;
}

bool ParameterSet::has(std::string_view name) const {
    return lookUp(name) != nullptr;
}

bool ParameterSet::is(std::string_view name, ParameterType type) const {
    const Parameter* parameter = lookUp(name);
    if (!parameter) return false;
    if (parameter->type != ParameterType::Untyped) return parameter->type == type;
    try {
        withType(*parameter, type);
        return true;
    } catch (const SceneError&) {
        return false;
    }
}

/// The parameter when it has the type; another type is an error. Marks it as read either way: one error is enough.
const Parameter* ParameterSet::read(std::string_view name, ParameterType type) const {
    const Parameter* parameter = lookUp(name);
    if (!parameter) return nullptr;
    mark(name);
    if (parameter->type == ParameterType::Untyped) {
        try {
            Entry* entry = ownEntry(name);
            entry->parameter = withType(*parameter, type);
            return entry->parameter.get();
        } catch (const SceneError& error) {
            errors_.insert(errors_.end(), error.diagnostics().begin(), error.diagnostics().end());
            return nullptr;
        }
    }
    if (parameter->type == type) return parameter;
    record(parameter->place,
           fmt::format("expected {}, got {}", declaration(type, name), declaration(parameter->type, name)));
    return nullptr;
}

const Parameter* ParameterSet::readOne(std::string_view name, ParameterType type) const {
    const Parameter* parameter = read(name, type);
    if (!parameter) return nullptr;
    const std::size_t needed = itemSize(type), given = parameter->size();
    if (given == needed) return parameter;
    record(given > needed ? parameter->valuePlace(needed) : parameter->place,
           fmt::format("{} takes {}, got {}", declaration(type, name), values(needed), given));
    return nullptr;
}

std::optional<double> ParameterSet::findFloat(std::string_view name) const {
    const Parameter* p = readOne(name, ParameterType::Float);
    return p ? std::optional(std::get<Parameter::Numbers>(p->values)[0]) : std::nullopt;
}

std::optional<int> ParameterSet::findInteger(std::string_view name) const {
    const Parameter* p = readOne(name, ParameterType::Integer);
    return p ? std::optional(std::get<Parameter::Integers>(p->values)[0]) : std::nullopt;
}

std::optional<bool> ParameterSet::findBool(std::string_view name) const {
    const Parameter* p = readOne(name, ParameterType::Bool);
    return p ? std::optional(std::get<Parameter::Integers>(p->values)[0] != 0) : std::nullopt;
}

std::optional<std::string> ParameterSet::findString(std::string_view name) const {
    const Parameter* p = readOne(name, ParameterType::String);
    return p ? std::optional(std::get<Parameter::Strings>(p->values)[0]) : std::nullopt;
}

std::optional<V2d> ParameterSet::findPair(std::string_view name, ParameterType type) const {
    const Parameter* p = readOne(name, type);
    if (!p) return std::nullopt;
    const auto& v = std::get<Parameter::Numbers>(p->values);
    return V2d(v[0], v[1]);
}

std::optional<V3d> ParameterSet::findTriple(std::string_view name, ParameterType type) const {
    const Parameter* p = readOne(name, type);
    if (!p) return std::nullopt;
    const auto& v = std::get<Parameter::Numbers>(p->values);
    return V3d(v[0], v[1], v[2]);
}

std::string ParameterSet::getChoice(std::string_view name, const std::string& fallback,
                                    const std::vector<std::string>& choices) const {
    const auto value = findString(name);
    if (!value) return fallback;
    if (std::find(choices.begin(), choices.end(), *value) != choices.end()) return *value;
    std::string hint = didYouMean(*value, choices);
    if (hint.empty()) hint = fmt::format("it is one of \"{}\"", fmt::join(choices, "\", \""));
    errorAtValue(name, 0, fmt::format("\"{}\" cannot be {}", name, inQuotes(*value)), hint);
    return fallback;
}

std::optional<std::string> ParameterSet::findTexture(std::string_view name) const {
    const Parameter* parameter = lookUp(name);
    if (!parameter || parameter->type != ParameterType::Texture) return std::nullopt;
    parameter = readOne(name, ParameterType::Texture);
    return parameter ? std::optional(std::get<Parameter::Strings>(parameter->values)[0]) : std::nullopt;
}

std::optional<SpectrumNode> ParameterSet::findSpectrum(std::string_view name) const {
    const Parameter* parameter = lookUp(name);
    if (!parameter) return std::nullopt;
    const bool spectral = isSpectral(parameter->type);
    const ParameterType type = spectral ? parameter->type : ParameterType::Spectrum;
    const bool pairs = type == ParameterType::Spectrum && parameter->type == type &&
                       std::holds_alternative<Parameter::Numbers>(parameter->values);
    // A spectrum out of --set is not known for numbers before it is read.
    parameter = pairs || parameter->type == ParameterType::Untyped ? read(name, type) : readOne(name, type);
    if (!parameter) return std::nullopt;
    SpectrumNode node;
    node.colorSpace = parameter->colorSpace;
    node.place = parameter->place;
    if (const auto* strings = std::get_if<Parameter::Strings>(&parameter->values)) {
        node.kind = SpectrumNode::Kind::Name;
        node.text = strings->front();
        node.place = parameter->valuePlace(0);
        return node;
    }
    node.values = std::get<Parameter::Numbers>(parameter->values);
    node.kind = type == ParameterType::Rgb         ? SpectrumNode::Kind::Rgb
                : type == ParameterType::Blackbody ? SpectrumNode::Kind::Blackbody
                                                   : SpectrumNode::Kind::Pairs;
    return checkSpectrum(node, *parameter) ? std::optional(node) : std::nullopt;
}

bool ParameterSet::checkSpectrum(const SpectrumNode& node, const Parameter& parameter) const {
    const auto& v = node.values;
    const auto fail = [&](std::size_t index, std::string_view what) {
        record(parameter.valuePlace(index), fmt::format("{}: {}", declaration(parameter.type, parameter.name), what));
        return false;
    };
    if (node.kind == SpectrumNode::Kind::Rgb)
        for (std::size_t i = 0; i < v.size(); ++i)
            if (v[i] < 0) return fail(i, "a colour's components must not be negative");
    if (node.kind == SpectrumNode::Kind::Blackbody && v[0] <= 0) return fail(0, "the temperature must be positive");
    if (node.kind != SpectrumNode::Kind::Pairs) return true;
    if (v.size() % 2 != 0)
        return fail(v.size() - 1, "needs pairs of wavelength and value, but the last lacks its value");
    for (std::size_t i = 0; i < v.size(); i += 2) {
        if (v[i] <= 0) return fail(i, "wavelengths (nm) must be positive");
        if (i > 0 && v[i] <= v[i - 2]) return fail(i, "wavelengths must increase");
    }
    return true;
}

std::span<const double> ParameterSet::readNumbers(std::string_view name, ParameterType type) const {
    const Parameter* parameter = read(name, type);
    if (!parameter) return {};
    const auto& numbers = std::get<Parameter::Numbers>(parameter->values);
    const std::size_t n = itemSize(type);
    if (numbers.size() % n == 0) return numbers;
    record(parameter->place,
           fmt::format("{} takes a multiple of {}, got {}", declaration(type, name), values(n), numbers.size()));
    return {};
}

std::span<const double> ParameterSet::getFloats(std::string_view name) const {
    return readNumbers(name, ParameterType::Float);
}

std::span<const int> ParameterSet::getIntegers(std::string_view name) const {
    const Parameter* parameter = read(name, ParameterType::Integer);
    return parameter ? std::span(std::get<Parameter::Integers>(parameter->values)) : std::span<const int>();
}

std::vector<std::string> ParameterSet::getStrings(std::string_view name) const {
    const Parameter* parameter = read(name, ParameterType::String);
    return parameter ? std::get<Parameter::Strings>(parameter->values) : std::vector<std::string>();
}

Place ParameterSet::place(std::string_view name) const {
    const Parameter* parameter = lookUp(name);
    return parameter ? parameter->place : place_;
}

Place ParameterSet::valuePlace(std::string_view name, std::size_t index) const {
    const Parameter* parameter = lookUp(name);
    return parameter ? parameter->valuePlace(index) : place_;
}

void ParameterSet::record(Place at, std::string message, std::string hint) const {
    errors_.push_back({Diagnostic::Severity::Error, std::move(at), std::move(message), std::move(hint)});
}

void ParameterSet::error(std::string_view name, std::string message, std::string hint) const {
    record(place(name), std::move(message), std::move(hint));
}

void ParameterSet::errorAtValue(std::string_view name, std::size_t index, std::string message, std::string hint) const {
    record(valuePlace(name, index), std::move(message), std::move(hint));
}

void ParameterSet::reportErrors(Diagnostics& diagnostics) const {
    for (const auto& e : errors_)
        if (!diagnostics.full()) diagnostics.error(e.place, e.message, e.hint);
}

void ParameterSet::report(Diagnostics& diagnostics) const {
    reportErrors(diagnostics);
    std::vector<std::string> candidates;
    for (const auto& name : asked_)
        if (!ownEntry(name)) candidates.push_back(name);
    for (const auto& entry : own_) {
        if (entry.read || entry.mayStayUnread || diagnostics.full()) continue;
        const Parameter& parameter = *entry.parameter;
        std::string hint = didYouMean(parameter.name, candidates);
        const std::string renamed(renamedParameter(parameter.name));
        if (!renamed.empty() && std::find(candidates.begin(), candidates.end(), renamed) != candidates.end())
            hint = fmt::format("pbrt-v4 calls it \"{}\"", renamed);
        diagnostics.error(parameter.place, "unused parameter " + inQuotes(parameter.name), hint);
    }
}

void ParameterSet::addOverride(ParameterPtr parameter) {
    remove(parameter->name);
    own_.insert(own_.begin(), Entry{std::move(parameter), true, false});
}

bool ParameterSet::wasRead(std::string_view name) const {
    const Entry* entry = ownEntry(name);
    return entry && entry->read;
}

bool ParameterSet::isUnused(std::string_view name) const {
    const Entry* entry = ownEntry(name);
    return entry && !entry->read && !entry->mayStayUnread;
}

bool ParameterSet::remove(std::string_view name) {
    return std::erase_if(own_, [&](const Entry& entry) { return entry.parameter->name == name; }) > 0;
}

void ParameterSet::takeReadsFrom(const ParameterSet& copy) const {
    asked_.insert(asked_.end(), copy.asked_.begin(), copy.asked_.end());
    for (Entry& entry : own_)
        entry.read |= copy.wasRead(entry.parameter->name);
}

ParameterList ParameterSet::own() const {
    ParameterList result;
    for (const auto& entry : own_)
        result.push_back(entry.parameter);
    return result;
}

const ParameterList& ParameterSet::defaults() const {
    static const ParameterList none;
    return defaults_ ? *defaults_ : none;
}

std::vector<std::string> ParameterSet::names() const {
    std::vector<std::string> names;
    for (const auto& entry : own_)
        names.push_back(entry.parameter->name);
    return names;
}

} // namespace vitrine
