#include "spectrum/sellmeier.h"
#include "spectrum/spectrum.h"

#include <map>
#include <span>

namespace vitrine {

namespace {

#include "spectrum/data/illuminants.inc"
#include "spectrum/data/metals.inc"

using Values = std::span<const float>;
using Table = std::map<std::string, SpectrumPtr, std::less<>>;

/// A table, held constant beyond its ends up to the ends of the visible range (as pbrt-v4 does with its tables).
SpectrumPtr tabulated(Values lambdas, Values values, float scale = 1) {
    std::vector<float> l(lambdas.begin(), lambdas.end()), v;
    for (float value : values)
        v.push_back(value * scale);
    if (l.front() > lambdaMin) {
        l.insert(l.begin(), lambdaMin - 1);
        v.insert(v.begin(), v.front());
    }
    if (l.back() < lambdaMax) {
        l.push_back(lambdaMax + 1);
        v.push_back(v.back());
    }
    return std::make_shared<PiecewiseLinearSpectrum>(std::move(l), std::move(v));
}

/// Relative power in steps of 5 nm from `first` on, scaled to the luminance of a constant 1.
SpectrumPtr illuminant(float first, Values power) {
    std::vector<float> lambdas;
    for (std::size_t i = 0; i < power.size(); ++i)
        lambdas.push_back(first + 5 * float(i));
    const double luminance = innerProduct(*tabulated(lambdas, power), cieY());
    return tabulated(lambdas, power, float(double(cieYIntegral) / luminance));
}

void addIlluminants(Table& table) {
    table["stdillum-A"] = illuminant(300, illuminantA);
    // Not pbrt-v4's table, whose red half is too weak (xy 0.337, 0.358 instead of CIE's 0.3457, 0.3585).
    const DenseSpectrum d50 = daylightSpectrum(5000);
    std::vector<float> power;
    for (int lambda = 360; lambda <= 830; lambda += 5)
        power.push_back(d50(float(lambda)));
    table["stdillum-D50"] = illuminant(360, power);
    table["stdillum-D65"] = illuminant(300, illuminantD65);
    table["illum-acesD60"] = illuminant(300, illuminantD60);
    const Values fluorescent[] = {illuminantF1, illuminantF2,  illuminantF3,  illuminantF4,
                                  illuminantF5, illuminantF6,  illuminantF7,  illuminantF8,
                                  illuminantF9, illuminantF10, illuminantF11, illuminantF12};
    for (std::size_t i = 0; i < std::size(fluorescent); ++i)
        table["stdillum-F" + std::to_string(i + 1)] = illuminant(380, fluorescent[i]);
}

void addMetals(Table& table) {
    const struct {
        const char* name;
        Values lambdas, eta, k;
    } metals[] = {{"Ag", nobleLambda, agEta, agK},      {"Al", nobleLambda, alEta, alK},
                  {"Au", nobleLambda, auEta, auK},      {"Cu", nobleLambda, cuEta, cuK},
                  {"CuZn", cuZnLambda, cuZnEta, cuZnK}, {"MgO", mgOLambda, mgOEta, mgOK},
                  {"TiO2", tiO2Lambda, tiO2Eta, tiO2K}};
    for (const auto& metal : metals) {
        table[std::string("metal-") + metal.name + "-eta"] = tabulated(metal.lambdas, metal.eta);
        table[std::string("metal-") + metal.name + "-k"] = tabulated(metal.lambdas, metal.k);
    }
}

/// Schott's data sheets. pbrt-v4's tables turn out to be sampled from the lead-free N- melts under the old names, at
/// wavelengths cut to whole nanometres (glass-F5, -F10, -F11: N-SF5, N-SF10, N-SF11).
void addGlasses(Table& table) {
    using Term = SellmeierSpectrum::Term;
    const auto add = [&table](const char* name, Term first, Term second, Term third) {
        table[name] = std::make_shared<SellmeierSpectrum>(first, second, third);
    };
    add("glass-BK7", {1.03961212f, 0.00600069867f}, {0.231792344f, 0.0200179144f}, {1.01046945f, 103.560653f});
    add("glass-BAF10", {1.5851495f, 0.00926681282f}, {0.143559385f, 0.0424489805f}, {1.08521269f, 105.613573f});
    add("glass-FK51A", {0.971247817f, 0.00472301995f}, {0.216901417f, 0.0153575612f}, {0.904651666f, 168.68133f});
    add("glass-LASF9", {2.00029547f, 0.0121426017f}, {0.298926886f, 0.0538736236f}, {1.80691843f, 156.530829f});
    add("glass-F5", {1.52481889f, 0.011254756f}, {0.187085527f, 0.0588995392f}, {1.42729015f, 129.141675f});
    add("glass-F10", {1.62153902f, 0.0122241457f}, {0.256287842f, 0.0595736775f}, {1.64447552f, 147.468793f});
    add("glass-F11", {1.73759695f, 0.013188707f}, {0.313747346f, 0.0623068142f}, {1.89878101f, 155.23629f});
}

const Table& namedTable() {
    static const Table table = [] {
        Table t;
        addIlluminants(t);
        addMetals(t);
        addGlasses(t);
        return t;
    }();
    return table;
}

} // namespace

SpectrumPtr namedSpectrum(std::string_view name) {
    const auto found = namedTable().find(name);
    return found == namedTable().end() ? nullptr : found->second;
}

const std::vector<std::string>& namedSpectra() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const auto& [name, spectrum] : namedTable())
            all.push_back(name);
        return all;
    }();
    return names;
}

} // namespace vitrine
