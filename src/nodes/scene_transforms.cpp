// Directives that change the current transformation.
#include "nodes/scene_reader.h"
#include "nodes/text.h"
#include "nodes/transforms.h"

#include <fmt/format.h>

namespace vitrine {

void SceneReader::takeNumbers(std::span<double> numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const Token token = lexer_->peek();
        if (token.kind != Token::Kind::Word || directives().contains(token.text))
            throw SceneError(lexer_->place(token), fmt::format("{} takes {} numbers: expected number {}, got {}",
                                                               directive_, numbers.size(), i + 1, token.describe()));
        const NumberFault fault = parseReal(token.text, numbers[i]);
        if (fault != NumberFault::None) throw SceneError(lexer_->place(token), describe(fault, token.text));
        lexer_->next();
    }
}

void SceneReader::takeMatrix(std::span<double, 16> numbers) {
    const auto bracket = [&](Token::Kind kind, std::string_view text) {
        const Token token = lexer_->peek();
        if (token.kind != kind)
            throw SceneError(lexer_->place(token),
                             fmt::format("{} takes 16 numbers in brackets: expected \"{}\", got {}", directive_, text,
                                         token.describe()));
        lexer_->next();
    };
    bracket(Token::Kind::Open, "[");
    takeNumbers(numbers);
    bracket(Token::Kind::Close, "]");
}

void SceneReader::concat(const Transform& transform) {
    states_.edit().changeTransform([&](const Transform& ctm) { return compose(transform, ctm); });
}

void SceneReader::identity() {
    states_.edit().changeTransform([](const Transform&) { return Transform(); });
}

void SceneReader::translate() {
    double v[3];
    takeNumbers(v);
    concat(translation(V3d(v[0], v[1], v[2])));
}

void SceneReader::scale() {
    double v[3];
    takeNumbers(v);
    concat(scaling(V3d(v[0], v[1], v[2])));
}

void SceneReader::rotate() {
    double v[4];
    takeNumbers(v);
    concat(rotation(v[0], V3d(v[1], v[2], v[3])));
}

void SceneReader::lookAtDirective() {
    double v[9];
    takeNumbers(v);
    concat(lookAt(V3d(v[0], v[1], v[2]), V3d(v[3], v[4], v[5]), V3d(v[6], v[7], v[8])));
}

void SceneReader::transform() {
    double v[16];
    takeMatrix(v);
    const Transform matrix = fromNumbers(v);
    states_.edit().changeTransform([&](const Transform&) { return matrix; });
}

void SceneReader::concatTransform() {
    double v[16];
    takeMatrix(v);
    concat(fromNumbers(v));
}

void SceneReader::coordinateSystem() {
    coordinateSystems_[lexer_->takeString("the name of a coordinate system")] = states_.current().ctm;
}

void SceneReader::coordSysTransform() {
    const Place namePlace = lexer_->place(lexer_->peek());
    const std::string name = lexer_->takeString("the name of a coordinate system");
    const auto found = coordinateSystems_.find(name);
    if (found == coordinateSystems_.end()) {
        std::vector<std::string> names;
        for (const auto& entry : coordinateSystems_)
            names.push_back(entry.first);
        throw SceneError(namePlace, "there is no coordinate system " + inQuotes(name), didYouMean(name, names));
    }
    auto& state = states_.edit();
    auto changed = std::make_shared<MovingTransform>(*state.ctm);
    changed->start = found->second->start;
    changed->end = found->second->end;
    state.ctm = std::move(changed);
}

void SceneReader::activeTransform() {
    const Token token = lexer_->peek();
    const bool all = token.isWord("All"), start = token.isWord("StartTime"), end = token.isWord("EndTime");
    if (!all && !start && !end)
        throw SceneError(lexer_->place(token),
                         fmt::format("ActiveTransform takes All, StartTime or EndTime, got {}", token.describe()));
    lexer_->next();
    auto& state = states_.edit();
    state.startActive = all || start;
    state.endActive = all || end;
}

void SceneReader::transformTimes() {
    double v[2];
    takeNumbers(v);
    auto& state = states_.edit();
    auto changed = std::make_shared<MovingTransform>(*state.ctm);
    changed->startTime = v[0];
    changed->endTime = v[1];
    state.ctm = std::move(changed);
}

} // namespace vitrine
