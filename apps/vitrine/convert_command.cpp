#include "commands.h"
#include "console.h"
#include "film/imageio.h"
#include "film/primaries.h"
#include "film/tonemap.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace {

using namespace vitrine;

struct ConvertArguments {
    std::string input, output, toneMap = "none";
    float exposure = 0;
};

void convert(const ConvertArguments& a) {
    const ToneMap toneMap = toneMapNamed(a.toneMap);
    checkImageName(a.output);
    ImageMetadata metadata;
    const Image read = readColours(a.input, metadata);
    const Image colours = inRec709(read, metadata.chromaticities);
    metadata.channelNames.clear();
    std::fill(std::begin(metadata.chromaticities), std::end(metadata.chromaticities), 0.f);
    const auto bad =
        std::count_if(colours.pixels.begin(), colours.pixels.end(), [](float v) { return !std::isfinite(v); });
    if (bad > 0) tellLine("vitrine: warning: {}: {} values are not finite", a.input, bad);
    writeImage(a.output, toneMapped(colours, a.exposure, toneMap), metadata);
}

} // namespace

void registerConvert(CLI::App& app) {
    auto* command = app.add_subcommand("convert", "Write a picture in another format, exposed and tone mapped");
    auto a = std::make_shared<ConvertArguments>();
    command->add_option("input", a->input, "Picture to read; of its channels the colours are taken")->required();
    command->add_option("output", a->output, "Picture to write (exr, hdr, pfm, png, ppm, jpg)")->required();
    command->add_option("--exposure", a->exposure, "Stops: each doubles the light")->capture_default_str();
    command->add_option("--tonemap", a->toneMap, fmt::format("One of {}", fmt::join(toneMapNames(), ", ")))
        ->capture_default_str();
    command->callback([a] { convert(*a); });
}
