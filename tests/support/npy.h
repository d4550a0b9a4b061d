// Reader of NumPy's .npz archives, which hold the reference pictures.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace vitrine::test {

/// An array of float32 in C order.
struct NpyArray {
    std::vector<std::size_t> shape;
    std::vector<float> values;
};

/// All arrays of an archive by name (without ".npy"), stored or deflated.
/// \throws std::runtime_error for a file that is missing, damaged, or holds anything but little-endian float32 in C
/// order
std::map<std::string, NpyArray> readNpz(const std::string& path);

} // namespace vitrine::test
