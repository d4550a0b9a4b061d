// The precomputed sigmoid polynomials of sRGB colours.
#pragma once

namespace vitrine {

/// Layout of the file that tools/make_table writes and that is linked into the library.
struct UpliftTable {
    static constexpr int resolution = 64;

    /// Values of the largest component that have entries, ascending from 0 to 1.
    float nodes[resolution];
    /// Polynomial over lambda in nm, by: which component is the largest; its node; the next but one component over the
    /// largest and the next one over the largest, both in equal steps. (Grid and nodes of the paper's code, and pbrt's.)
    float coefficients[3][resolution][resolution][resolution][3];

    static const UpliftTable& srgb();
};

} // namespace vitrine
