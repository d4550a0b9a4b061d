// The reader of the reference pictures, against what NumPy itself reads from them.
#include "support/npy.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <numeric>
#include <stdexcept>

namespace vitrine::test {
namespace {

const std::string references = VITRINE_SOURCE_DIR "/tests/images/references/";

TEST(Npy, ReadsWhatNumpyReads) {
    const auto arrays = readNpz(references + "vase.npz");
    ASSERT_EQ(arrays.size(), 2u);
    const NpyArray &mean = arrays.at("mean"), &variance = arrays.at("var");
    EXPECT_EQ(mean.shape, (std::vector<std::size_t>{128, 128, 3}));
    EXPECT_EQ(variance.shape, mean.shape);
    const std::size_t at = (5 * 128 + 7) * 3;
    EXPECT_EQ(mean.values[at], 0.0475235f);
    EXPECT_EQ(mean.values[at + 1], 0.25933838f);
    EXPECT_EQ(mean.values[at + 2], 0.03981781f);
    EXPECT_EQ(variance.values.back(), 1.0762209e-06f);
    EXPECT_NEAR(std::accumulate(variance.values.begin(), variance.values.end(), 0.), 0.6588189176843713, 1e-9);
}

TEST(Npy, DamageIsFound) {
    std::ifstream in(references + "vase.npz", std::ios::binary);
    const std::string whole(std::istreambuf_iterator<char>(in), {});
    const TemporaryFolder folder;
    const auto readChanged = [&](const std::string& bytes) {
        std::ofstream(folder.file("a.npz"), std::ios::binary | std::ios::trunc) << bytes;
        return readNpz(folder.file("a.npz"));
    };
    EXPECT_EQ(readChanged(whole).size(), 2u);
    for (std::size_t size : {std::size_t(0), std::size_t(10), whole.size() / 2, whole.size() - 1})
        EXPECT_THROW(readChanged(whole.substr(0, size)), std::runtime_error) << size;
    std::string flipped = whole;
    flipped[whole.size() / 4] = char(flipped[whole.size() / 4] ^ 1);
    EXPECT_THROW(readChanged(flipped), std::runtime_error);
    EXPECT_THROW(readNpz(folder.file("none.npz")), std::runtime_error);
}

} // namespace
} // namespace vitrine::test
