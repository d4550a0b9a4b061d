#include "core/errors.h"
#include "render/partial.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace vitrine {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::vector<std::pair<std::uint64_t, std::uint64_t>> pairs(const std::vector<PassRange>& ranges) {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> p;
    for (const auto& r : ranges)
        p.emplace_back(r.begin, r.end);
    return p;
}
using Pairs = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

TEST(PassSet, JoinsTouchingRangesInAnyOrder) {
    PassSet set;
    set.add({4, 8});
    set.add({0, 2});
    EXPECT_EQ(pairs(set.ranges()), (Pairs{{0, 2}, {4, 8}}));
    set.add({2, 4});
    EXPECT_EQ(pairs(set.ranges()), (Pairs{{0, 8}}));
    set.add({8, 9});
    EXPECT_EQ(pairs(set.ranges()), (Pairs{{0, 9}}));
    EXPECT_EQ(set.size(), 9u);
}

TEST(PassSet, RefusesPassesTwice) {
    PassSet set;
    set.add({4, 8});
    EXPECT_THROW(set.add({7, 9}), std::invalid_argument);
    EXPECT_THROW(set.add({0, 5}), std::invalid_argument);
    EXPECT_THROW(set.add({5, 6}), std::invalid_argument);
    EXPECT_THROW(set.add({0, 20}), std::invalid_argument);
    EXPECT_THROW(set.add({9, 8}), std::invalid_argument);
    EXPECT_EQ(pairs(set.ranges()), (Pairs{{4, 8}}));
}

TEST(PassSet, KnowsWhatIsMissing) {
    PassSet set;
    set.add({2, 4});
    set.add({6, 8});
    EXPECT_EQ(pairs(set.missingFrom({0, 10})), (Pairs{{0, 2}, {4, 6}, {8, 10}}));
    EXPECT_EQ(pairs(set.missingFrom({3, 7})), (Pairs{{4, 6}}));
    EXPECT_EQ(pairs(set.missingFrom({2, 4})), (Pairs{}));
}

class PartialFile : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("vitrine_partial_" + std::to_string(getpid()));
        fs::create_directories(folder_);
        path_ = (folder_ / "part").string();
        settings_.resolution = V2i(5, 4);
        settings_.cropMin = V2i(1, 1);
        settings_.cropMax = V2i(4, 3);
        settings_.colorSpace = &RgbColorSpace::srgb();
        state_.fingerprint = 77;
        state_.sceneName = "a.pbrt";
        state_.seconds = 1.5;
        state_.passes.add({0, 3});
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string read() const {
        std::ifstream in(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void write(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }

    fs::path folder_;
    std::string path_;
    FilmSettings settings_;
    PartialRender state_;
};

TEST_F(PartialFile, RoundTrip) {
    Film film(settings_);
    const auto lambda = SampledWavelengths::visible(0.3f);
    film.add(V2i(2, 1), SampledSpectrum(0.7f), lambda, 1, 0);
    film.add(V2i(3, 2), SampledSpectrum(1.7f), lambda, 1, 1);
    writePartial(path_, state_, film);
    const LoadedPartial loaded = readPartial(path_);
    EXPECT_EQ(loaded.state.fingerprint, 77u);
    EXPECT_EQ(loaded.state.sceneName, "a.pbrt");
    EXPECT_EQ(loaded.state.seconds, 1.5);
    EXPECT_EQ(loaded.state.passes.toString(), "0:3");
    ASSERT_EQ(loaded.film.sums().size(), film.sums().size());
    for (std::size_t i = 0; i < film.sums().size(); ++i)
        EXPECT_TRUE(loaded.film.sums()[i] == film.sums()[i]);
}

TEST_F(PartialFile, EveryCutAndEveryFlippedByteIsNoticed) {
    writePartial(path_, state_, Film(settings_));
    const std::string whole = read();
    for (std::size_t cut = 0; cut < whole.size(); ++cut) {
        write(whole.substr(0, cut));
        EXPECT_THROW(readPartial(path_), FileError) << "cut at " << cut;
    }
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string damaged = whole;
        damaged[i] = char(damaged[i] ^ 0x10);
        write(damaged);
        EXPECT_THROW(readPartial(path_), FileError) << "flipped at " << i;
    }
}

TEST_F(PartialFile, AnErrorNamesTheFile) {
    try {
        readPartial(path_);
        FAIL();
    } catch (const FileError& e) {
        EXPECT_THAT(e.what(), HasSubstr(path_));
    }
}

} // namespace
} // namespace vitrine
