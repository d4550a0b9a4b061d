#include "commands.h"
#include "console.h"
#include "film/compare.h"
#include "film/imageio.h"
#include "film/primaries.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace {

using namespace vitrine;

struct DiffArguments {
    std::string image, reference, variance, heatMap;
    bool json = false;
};

struct ColourPicture {
    Image image;
    V2i offset; ///< of the data window, pixels
};

ColourPicture readPicture(const std::string& path) {
    ImageMetadata metadata;
    const Image colours = readColours(path, metadata);
    return {inRec709(colours, metadata.chromaticities), metadata.offset};
}

/// Pixels that are no number have no error: without them a broken picture would look good.
bool isComparable(const Comparison& c) {
    return c.badPixelsA == 0 && c.badPixelsB == 0;
}

std::string asText(const Comparison& c) {
    const std::string relMse = isComparable(c) ? fmt::format("{:.6g}", c.relMse)
                                               : fmt::format("none: not all pixels are finite ({:.6g} over those that "
                                                             "are in both)",
                                                             c.relMse);
    return fmt::format("relMSE      {}\n"
                       "PSNR        {:.2f} dB (peak {:.6g})\n"
                       "SSIM        {}\n"
                       "mean ratio  {:.6f}\n"
                       "pixels      {} compared; not finite: {} in the image, {} in the reference\n",
                       relMse, c.psnr, c.peak, c.ssim ? fmt::format("{:.6f}", *c.ssim) : "none (under 11 x 11 pixels)",
                       fmt::join(c.meanRatio, " "), c.pixels, c.badPixelsA, c.badPixelsB);
}

/// Infinities (the PSNR of equal pictures) become null, as JSON has no other word for them; so does a relMSE that does
/// not speak for the whole picture.
std::string asJson(const Comparison& c) {
    nlohmann::ordered_json json;
    json["relMSE"] = isComparable(c) ? nlohmann::ordered_json(c.relMse) : nlohmann::ordered_json(nullptr);
    json["relMSEOfFinite"] = c.relMse;
    json["MSE"] = c.mse;
    json["PSNR"] = c.psnr;
    json["peak"] = c.peak;
    json["SSIM"] = c.ssim ? nlohmann::ordered_json(*c.ssim) : nlohmann::ordered_json(nullptr);
    json["meanRatio"] = c.meanRatio;
    json["pixels"] = c.pixels;
    json["notFinite"] = {{"image", c.badPixelsA}, {"reference", c.badPixelsB}};
    return json.dump(2) + "\n";
}

void diff(const DiffArguments& a) {
    if (!a.heatMap.empty()) checkImageName(a.heatMap);
    const ColourPicture image = readPicture(a.image), reference = readPicture(a.reference);
    if (image.offset != reference.offset)
        throw std::invalid_argument(
            fmt::format("{} and {} are different crop windows of their pictures", a.image, a.reference));
    Image variance;
    if (!a.variance.empty()) variance = readPicture(a.variance).image;

    const Comparison comparison = compareImages(image.image, reference.image, a.variance.empty() ? nullptr : &variance);
    if (!a.heatMap.empty()) writeImage(a.heatMap, heatMap(image.image, reference.image));
    printOut(a.json ? asJson(comparison) : asText(comparison));
    if (!isComparable(comparison))
        tellLine("vitrine: warning: the pictures are not comparable: {} pixels of {} and {} of {} are not finite",
                 comparison.badPixelsA, a.image, comparison.badPixelsB, a.reference);
}

} // namespace

void registerDiff(CLI::App& app) {
    auto* command = app.add_subcommand("diff", "Measure how far a picture is from a reference");
    auto a = std::make_shared<DiffArguments>();
    command->add_option("image", a->image, "Picture to judge")->required();
    command->add_option("reference", a->reference, "Picture to judge it by, of the same size")->required();
    command->add_option("--variance", a->variance, "Variance of the reference's values: taken off the relMSE");
    command->add_option("--out", a->heatMap, "Write a heat map: red where the image is brighter, blue where darker");
    command->add_flag("--json", a->json, "Print JSON instead of text");
    command->callback([a] { diff(*a); });
}
