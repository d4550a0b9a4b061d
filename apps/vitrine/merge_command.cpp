#include "commands.h"
#include "core/errors.h"
#include "film/imageio.h"
#include "render/partial.h"

#include <fmt/format.h>

namespace {

using namespace vitrine;

/// Adds up partial renders of one scene. \throws std::invalid_argument when they do not belong together or overlap
LoadedPartial mergeParts(const std::vector<std::string>& files) {
    LoadedPartial sum = readPartial(files.front());
    for (std::size_t i = 1; i < files.size(); ++i) {
        const LoadedPartial part = readPartial(files[i]);
        if (!sum.state.integratorState.empty() || !part.state.integratorState.empty())
            throw std::invalid_argument(
                fmt::format("{} cannot be merged: each of its passes builds on those before it. Go on with it by "
                            "--resume --checkpoint",
                            sum.state.integratorState.empty() ? files[i] : files.front()));
        if (part.state.fingerprint != sum.state.fingerprint)
            throw std::invalid_argument(
                fmt::format("{} and {} are of different scenes or settings", files.front(), files[i]));
        for (const auto& range : part.state.passes.ranges()) {
            try {
                sum.state.passes.add(range);
            } catch (const std::invalid_argument& e) {
                throw std::invalid_argument(fmt::format("{}: {} that came before", files[i], e.what()));
            }
        }
        sum.film.merge(part.film);
        sum.state.seconds += part.state.seconds;
    }
    return sum;
}

struct MergeArguments {
    std::vector<std::string> parts, outputs;
    std::string partial;
};

void merge(const MergeArguments& a) {
    if (a.outputs.empty() && a.partial.empty()) throw std::invalid_argument("merge: give --outfile or --partial");
    const LoadedPartial sum = mergeParts(a.parts);
    if (!a.partial.empty()) writePartial(a.partial, sum.state, sum.film);
    ImageMetadata metadata = metadataOf(sum.film.settings());
    metadata.matrices = sum.state.matrices;
    metadata.numbers["samplesPerPixel"] = double(sum.state.passes.size());
    for (const auto& output : a.outputs)
        writeImage(output, sum.film.image(), metadata);
}

} // namespace

void registerMerge(CLI::App& app) {
    auto* command = app.add_subcommand("merge", "Add up partial renders of pass ranges into one picture");
    auto a = std::make_shared<MergeArguments>();
    command->add_option("part", a->parts, "Files that \"vitrine render --partial\" wrote")->required();
    command->add_option("-o,--outfile", a->outputs, "Picture to write")->take_all()->allow_extra_args(false);
    command->add_option("--partial", a->partial, "Write the merged sums");
    command->callback([a] { merge(*a); });
}
