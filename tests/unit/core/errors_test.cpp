#include "core/errors.h"

namespace vitrine {
namespace {

std::shared_ptr<SourceFile> makeFile(std::string name, std::string text) {
    auto file = std::make_shared<SourceFile>();
    file->name = std::move(name);
    file->text = std::move(text);
    return file;
}

std::string shown(const std::string& text, int line, int column, int length = 1) {
    return Diagnostic{Diagnostic::Severity::Error, Place{makeFile("a.pbrt", text), line, column, length}, "no", {}}
        .toString();
}

TEST(Place, IsFileLineColumn) {
    EXPECT_EQ(Place().toString(), "");
    EXPECT_EQ((Place{makeFile("a.pbrt", ""), 0, 0}).toString(), "a.pbrt");
    EXPECT_EQ((Place{makeFile("a.pbrt", "x"), 3, 14}).toString(), "a.pbrt:3:14");
    EXPECT_EQ((Place{makeFile("a.pbrt", "x"), 3, 0}).toString(), "a.pbrt:3:1");
}

TEST(Diagnostic, ShowsLineCaretAndHint) {
    const Diagnostic d{Diagnostic::Severity::Error,
                       Place{makeFile("scenes/a.pbrt", "WorldBegin\nShap \"sphere\"\nEnd\n"), 2, 1, 4},
                       "unknown directive Shap", didYouMean("Shap", {"Scale", "Shape"})};
    EXPECT_EQ(d.toString(), "scenes/a.pbrt:2:1: error: unknown directive Shap\n"
                            "    Shap \"sphere\"\n"
                            "    ^^^^\n"
                            "    did you mean \"Shape\"?");
}

TEST(Diagnostic, WarningsSayWarning) {
    const Diagnostic d{Diagnostic::Severity::Warning, Place{makeFile("a.pbrt", "x y"), 1, 3}, "odd", {}};
    EXPECT_EQ(d.toString(), "a.pbrt:1:3: warning: odd\n    x y\n      ^");
}

TEST(Diagnostic, WithoutAPlaceOrForAWholeFileShowsNoLine) {
    EXPECT_EQ((Diagnostic{Diagnostic::Severity::Error, {}, "no scene", {}}).toString(), "error: no scene");
    EXPECT_EQ((Diagnostic{Diagnostic::Severity::Error, Place{makeFile("a.pbrt", "x"), 0, 0}, "empty", {}}).toString(),
              "a.pbrt: error: empty");
}

TEST(Diagnostic, TabsAndControlCharactersBecomeOneSpace) {
    EXPECT_EQ(shown("\tShape\t\"x\"\a!", 1, 8, 3), "a.pbrt:1:8: error: no\n"
                                                   "     Shape \"x\" !\n"
                                                   "           ^^^");
}

TEST(Diagnostic, LineEndsOfAnySystemAreLeftOut) {
    EXPECT_EQ(shown("one\r\ntwo\r\n", 2, 3), "a.pbrt:2:3: error: no\n    two\n      ^");
}

TEST(Diagnostic, CaretsStopAtTheEndOfTheLine) {
    EXPECT_EQ(shown("abc", 1, 2, 50), "a.pbrt:1:2: error: no\n    abc\n     ^^");
    EXPECT_EQ(shown("abc\n", 1, 4, 1), "a.pbrt:1:4: error: no\n    abc\n       ^");
    EXPECT_EQ(shown("abc\n", 1, 99, 7), "a.pbrt:1:99: error: no\n    abc\n       ^");
    EXPECT_EQ(shown("abc\n", 2, 1, 1), "a.pbrt:2:1: error: no\n    \n    ^");
    EXPECT_EQ(shown("abc\n", 7, 3, 1), "a.pbrt:7:3: error: no\n    \n    ^");
}

TEST(Diagnostic, CountsBytesButUnderlinesCharacters) {
    // "é" has two bytes, "日" three, "🍷" four.
    EXPECT_EQ(shown("\"é日🍷\" bad", 1, 13, 3), "a.pbrt:1:13: error: no\n    \"é日🍷\" bad\n          ^^^");
    EXPECT_EQ(shown("\"é日🍷\" bad", 1, 2, 9), "a.pbrt:1:2: error: no\n    \"é日🍷\" bad\n     ^^^");
    // A place inside a character is shown at the character.
    EXPECT_EQ(shown("é日x", 1, 4, 1), "a.pbrt:1:4: error: no\n    é日x\n     ^");
}

TEST(Diagnostic, BytesThatAreNotUtf8BecomeReplacementCharacters) {
    // A lone continuation, an overlong slash, a surrogate, a sequence cut short, a byte that never occurs; a C1 control.
    EXPECT_EQ(shown("a\x80 \xc0\xaf \xed\xa0\x80 \xe6\x97 \xff \xc2\x85 b", 1, 19, 1),
              "a.pbrt:1:19: error: no\n"
              "    a\ufffd \ufffd\ufffd \ufffd\ufffd\ufffd \ufffd\ufffd \ufffd   b\n"
              "    " +
                  std::string(17, ' ') + "^");
}

TEST(Diagnostic, LongLinesAreCutAroundThePlace) {
    std::string line;
    for (int i = 0; i < 100; ++i)
        line += "0123456789";
    // Near the start nothing is cut on the left, and 120 characters are shown.
    EXPECT_EQ(shown(line, 1, 12, 2),
              "a.pbrt:1:12: error: no\n    " + line.substr(0, 120) + "\n    " + std::string(11, ' ') + "^^");
    EXPECT_EQ(shown(line, 1, 100, 1),
              "a.pbrt:1:100: error: no\n    " + line.substr(0, 120) + "\n    " + std::string(99, ' ') + "^");
    // Further on 60 characters stand before the place; carets end where the excerpt does.
    EXPECT_EQ(shown(line, 1, 501, 300), "a.pbrt:1:501: error: no\n    " + line.substr(440, 120) + "\n    " +
                                            std::string(60, ' ') + std::string(60, '^'));
    EXPECT_EQ(shown(line, 1, 1001, 1),
              "a.pbrt:1:1001: error: no\n    " + line.substr(940) + "\n    " + std::string(60, ' ') + "^");
}

TEST(Diagnostic, LongLinesOfManyByteCharactersAreCutBetweenThem) {
    for (const std::string character : {"é", "日", "🍷"}) {
        std::string line, sixty;
        for (int i = 0; i < 1000; ++i)
            line += character;
        for (int i = 0; i < 60; ++i)
            sixty += character;
        const int column = int(500 * character.size()) + 1;
        for (int inside = 0; inside < int(character.size()); ++inside)
            EXPECT_EQ(shown(line, 1, column + inside, 1), "a.pbrt:1:" + std::to_string(column + inside) +
                                                              ": error: no\n    " + sixty + sixty + "\n    " +
                                                              std::string(60, ' ') + "^");
    }
}

TEST(Diagnostic, AHugeLineCostsOnlyItsExcerpt) {
    const std::string text = shown(std::string(20'000'000, 'x'), 1, 10'000'000, 1);
    EXPECT_LT(text.size(), 300u);
}

TEST(Diagnostic, NamesTheChainOfIncludes) {
    const auto top = makeFile("top.pbrt", "Include \"middle.pbrt\"\n");
    auto middle = makeFile("middle.pbrt", "\n\nInclude \"leaf.pbrt\"\n");
    middle->includedFrom = top;
    middle->includedAtLine = 1;
    auto leaf = makeFile("leaf.pbrt", "oops");
    leaf->includedFrom = middle;
    leaf->includedAtLine = 3;
    EXPECT_EQ(
        (Diagnostic{Diagnostic::Severity::Error, Place{leaf, 1, 1, 4}, "unknown directive oops", "hint"}).toString(),
        "leaf.pbrt:1:1: error: unknown directive oops\n"
        "    oops\n"
        "    ^^^^\n"
        "    hint\n"
        "    included from middle.pbrt:3\n"
        "    included from top.pbrt:1");
}

TEST(Diagnostics, CollectsInOrderAndThrowsOnlyForErrors) {
    Diagnostics diagnostics;
    diagnostics.warning({}, "first");
    EXPECT_FALSE(diagnostics.hasErrors());
    EXPECT_NO_THROW(diagnostics.throwIfErrors());
    diagnostics.error({}, "second", "a hint");
    diagnostics.error({}, "third");
    EXPECT_TRUE(diagnostics.hasErrors());
    try {
        diagnostics.throwIfErrors();
        FAIL() << "did not throw";
    } catch (const SceneError& e) {
        EXPECT_STREQ(e.what(), "warning: first\nerror: second\n    a hint\nerror: third");
        EXPECT_EQ(e.diagnostics().size(), 3u);
    }
}

TEST(Diagnostics, IsFullAfterTheLastErrorThatIsShown) {
    Diagnostics diagnostics;
    for (std::size_t i = 0; i < Diagnostics::maxErrors; ++i) {
        EXPECT_FALSE(diagnostics.full());
        diagnostics.warning({}, "w");
        diagnostics.error({}, "e");
    }
    EXPECT_TRUE(diagnostics.full());
}

TEST(Errors, SayWhatAndWhere) {
    const SceneError scene(Place{makeFile("a.pbrt", "x"), 1, 1}, "wrong", "right?");
    EXPECT_STREQ(scene.what(), "a.pbrt:1:1: error: wrong\n    x\n    ^\n    right?");
    const FileError file("b.exr", "cannot be written");
    EXPECT_STREQ(file.what(), "b.exr: cannot be written");
    EXPECT_EQ(file.file(), "b.exr");
}

TEST(NearestName, FindsSlipsOfTheKeyboard) {
    const std::vector<std::string> names = {"sphere", "disk", "cylinder", "trianglemesh", "plymesh", "revolution", "N"};
    EXPECT_EQ(nearestName("shpere", names), "sphere");      // two neighbours swapped: one slip
    EXPECT_EQ(nearestName("sphre", names), "sphere");       // one left out
    EXPECT_EQ(nearestName("cyllinder", names), "cylinder"); // one too many
    EXPECT_EQ(nearestName("risk", names), "disk");          // one wrong
    EXPECT_EQ(nearestName("Disk", names), "disk");          // case is no slip
    EXPECT_EQ(nearestName("TRIANGLEMASH", names), "trianglemesh");
    EXPECT_EQ(nearestName("ply mesh", names), "plymesh");
}

TEST(NearestName, SaysNothingWhenNothingIsNear) {
    const std::vector<std::string> names = {"sphere", "disk", "N"};
    EXPECT_EQ(nearestName("cone", names), "");
    EXPECT_EQ(nearestName("box", names), "");
    EXPECT_EQ(nearestName("", names), "");
    EXPECT_EQ(nearestName("P", names), ""); // one letter for another is not a slip
    EXPECT_EQ(nearestName("n", names), "N");
    EXPECT_EQ(nearestName(std::string(100'000, 's'), names), "");
    EXPECT_EQ(nearestName("sphere", {}), "");
    EXPECT_EQ(didYouMean("cone", names), "");
}

TEST(NearestName, TakesTheNearestAndOfEqualsTheFirst) {
    EXPECT_EQ(nearestName("radios", {"ratios", "radius"}), "ratios");
    EXPECT_EQ(nearestName("radiis", {"ratio", "radius"}), "radius");
}

} // namespace
} // namespace vitrine
