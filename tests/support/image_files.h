// Image files as any program may write them.
#pragma once

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace vitrine::test {

/// Values as the format stores them: of whole numbers 0 to 1 over their range.
inline void writeFile(const std::string& path, const OIIO::ImageSpec& spec, const std::vector<float>& values) {
    const auto out = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(out) << path;
    ASSERT_TRUE(out->open(path, spec)) << out->geterror();
    ASSERT_TRUE(out->write_image(OIIO::TypeFloat, values.data())) << out->geterror();
    ASSERT_TRUE(out->close());
}

/// Leaves this much of a file.
inline void cut(const std::string& path, double share) {
    std::filesystem::resize_file(path, std::uintmax_t(double(std::filesystem::file_size(path)) * share));
}

} // namespace vitrine::test
