// Finds the spectrum of an RGB colour: the optimisation of Jakob & Hanika 2019, "A low-dimensional function space for
// efficient spectral upsampling".
#pragma once

#include <array>
#include <span>

namespace vitrine {

/// Fits sigmoid(c0 t^2 + c1 t + c2) to colours of one RGB space; t = (lambda - 360 nm) / 470 nm is far better conditioned
/// than nanometres. The difference is taken in CIELAB (section 4.1 of the paper) and brought down by Gauss-Newton steps,
/// damped (Levenberg-Marquardt) where a full step would make it worse: colours that no reflectance has (many of wide
/// gamuts) then end at their best approximation instead of diverging.
class UpliftSolver {
  public:
    using Triple = std::array<double, 3>;
    using Matrix = std::array<Triple, 3>; ///< rows

    /// \param xyzFromRgb for a white of luminance 1
    /// \param illuminant the white's relative power at 360, 365 ... 830 nm: 95 values
    UpliftSolver(const Matrix& xyzFromRgb, std::span<const float> illuminant);

    /// Improves `coefficients`. \returns the squared difference that is left (below 1e-6: reached).
    double improve(const Triple& rgb, Triple& coefficients) const;
    /// The coefficients for `rgb`, components in [0,1], found from a grey of like brightness.
    Triple solve(const Triple& rgb) const;

    /// The same polynomial over lambda in nm.
    static std::array<float, 3> inNanometres(const Triple& coefficients);

  private:
    // Four samples at a time: 283 samples and one of weight 0.
    using Quad [[gnu::vector_size(32)]] = double;
    static constexpr std::size_t samples = 283, quads = 71;

    /// XYZ over the white's XYZ, and its derivatives by the coefficients.
    struct Response {
        Triple value;
        Matrix derivative;
    };
    /// The difference to a wanted L*, a*, b* (residual: wanted minus present), and the derivatives of L*, a*, b*.
    struct Fit {
        Triple residual{};
        double squared = 0;
        Matrix jacobian{};
    };
    Response respond(const Triple& coefficients) const;
    Fit fit(const Triple& coefficients, const Triple& wantedLab) const;
    Triple labOfRgb(const Triple& rgb) const;

    Matrix relativeFromRgb_{}; ///< RGB to XYZ over the white's XYZ
    std::array<Quad, quads> t_{};
    std::array<std::array<Quad, quads>, 3> weight_{}; ///< matching function x illuminant x quadrature rule / white
};

} // namespace vitrine
