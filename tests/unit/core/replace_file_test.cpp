#include "core/errors.h"
#include "core/replace_file.h"
#include "support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace vitrine {
namespace {

using testing::HasSubstr;
using namespace std::string_literals;

void replace(const std::string& path, const std::string& text) {
    replaceFile(path, {std::as_bytes(std::span(text))});
}

std::string contents(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string messageOf(const std::string& path) {
    try {
        replace(path, "new");
    } catch (const FileError& error) {
        EXPECT_EQ(error.file(), path);
        return error.what();
    }
    return "no error";
}

TEST(ReplaceFile, WritesAndReplaces) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("a.bin");
    replace(path, std::string("first\0text", 10));
    EXPECT_EQ(contents(path), std::string("first\0text", 10));
    replace(path, "");
    EXPECT_EQ(contents(path), "");
    EXPECT_EQ(folder.count(), 1u);
}

TEST(ReplaceFile, StaleTemporaryFilesAreNoObstacle) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.file(".a.bin.0.part")) << "left by a killed process";
    replace(folder.file("a.bin"), "text");
    EXPECT_EQ(contents(folder.file("a.bin")), "text");
    EXPECT_EQ(folder.count(), 1u) << "the leftover was used";
    // However many there are.
    for (int i = 0; i <= 1001; ++i)
        std::ofstream(folder.file(".a.bin." + std::to_string(i) + ".part")) << "left, and longer than the new text";
    replace(folder.file("a.bin"), "new");
    EXPECT_EQ(contents(folder.file("a.bin")), "new");
}

TEST(ReplaceFile, FilesThatOthersWriteAreLeftAlone) {
    const test::TemporaryFolder folder;
    const std::string others = folder.file(".a.bin.0.part");
    std::ofstream(others) << "half";
    const int descriptor = ::open(others.c_str(), O_WRONLY);
    ASSERT_EQ(::flock(descriptor, LOCK_EX), 0) << "as a process that is at work on it";
    replace(folder.file("a.bin"), "text");
    EXPECT_EQ(contents(folder.file("a.bin")), "text");
    EXPECT_EQ(contents(others), "half");
    // Nor are links to files elsewhere emptied.
    std::ofstream(folder.file("elsewhere")) << "precious";
    std::filesystem::create_symlink("elsewhere", folder.file(".b.bin.0.part"));
    std::filesystem::create_hard_link(folder.file("elsewhere"), folder.file(".b.bin.1.part"));
    replace(folder.file("b.bin"), "text");
    EXPECT_EQ(contents(folder.file("elsewhere")), "precious");
    ::close(descriptor);
}

TEST(ReplaceFile, ManyWritersAtOnceNeverMixTheirTexts) {
    const test::TemporaryFolder folder;
    std::vector<std::thread> writers;
    for (const char letter : {'a', 'b', 'c', 'd'})
        writers.emplace_back([&, letter] {
            for (int i = 0; i < 50; ++i)
                replace(folder.file("a.bin"), std::string(5000, letter));
        });
    for (auto& writer : writers)
        writer.join();
    const std::string text = contents(folder.file("a.bin"));
    EXPECT_EQ(text, std::string(5000, text.at(0)));
    EXPECT_EQ(folder.count(), 1u);
}

TEST(ReplaceFile, CanBeTriedWithoutATrace) {
    const test::TemporaryFolder folder;
    EXPECT_NO_THROW(checkReplaceable(folder.file("a.bin")));
    EXPECT_EQ(folder.count(), 0u);
    std::ofstream(folder.file("a.bin")) << "old";
    EXPECT_NO_THROW(checkReplaceable(folder.file("a.bin")));
    EXPECT_EQ(contents(folder.file("a.bin")), "old");
    EXPECT_EQ(folder.count(), 1u);
    EXPECT_NO_THROW(checkReplaceable("/dev/null"));
    for (const std::string& bad :
         {folder.file("no/a.bin"), folder.file("a.bin/b.bin"), folder.file(""), "/proc/a.bin"s})
        EXPECT_THROW(checkReplaceable(bad), FileError) << bad;
}

TEST(ReplaceFile, LinksAreFollowed) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.file("target")) << "old";
    std::filesystem::create_symlink("target", folder.file("link"));
    replace(folder.file("link"), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
    EXPECT_EQ(contents(folder.file("target")), "new");
}

TEST(ReplaceFile, ErrorsNameTheFile) {
    const test::TemporaryFolder folder;
    EXPECT_THAT(messageOf(folder.file("missing/a.bin")), HasSubstr("missing/a.bin: cannot be written: No such file"));
    std::ofstream(folder.file("file")) << "text";
    EXPECT_THAT(messageOf(folder.file("file/a.bin")), HasSubstr("Not a directory"));
    std::filesystem::create_directory(folder.file("dir"));
    EXPECT_THAT(messageOf(folder.file("dir")), HasSubstr("Is a directory"));
    EXPECT_EQ(folder.count(), 2u);
}

TEST(ReplaceFile, DevicesAreWrittenToAsTheyAre) {
    replace("/dev/null", "text");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    EXPECT_THAT(messageOf("/dev/full"), HasSubstr("No space left"));
}

TEST(ReplaceFile, ALimitReachedWhileWritingLeavesTheOldFile) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("a.bin");
    replace(path, "old");
    // In a process of its own, as the limit cannot be lifted again.
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{4096, 4096};
        if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(1);
        try {
            replace(path, std::string(100000, 'x'));
        } catch (const FileError&) {
            ::_exit(42);
        }
        ::_exit(2);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 42);
    EXPECT_EQ(contents(path), "old");
    EXPECT_EQ(folder.count(), 1u);
}

} // namespace
} // namespace vitrine
