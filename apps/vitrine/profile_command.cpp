#include "arguments.h"
#include "commands.h"
#include "console.h"
#include "core/replace_file.h"
#include "plot/png_writer.h"
#include "plot/svg_writer.h"
#include "profile_drawings.h"

#include <fmt/format.h>

#include <filesystem>

namespace {

namespace fs = std::filesystem;
using namespace vitrine;

constexpr double pixelsPerPoint = 2; ///< a figure is 980 points wide

struct ProfileArguments {
    std::string file, output, ray, only;
    std::vector<std::string> settings;
};

std::string lowerExtension(const std::string& file) {
    std::string extension = fs::path(file).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return extension;
}

std::optional<Ray> readRay(const std::string& text) {
    if (text.empty()) return {};
    const auto n = numbers<double>(text, ',', 6, "--ray");
    const Ray ray{V3d(n[0], n[1], n[2]), V3d(n[3], n[4], n[5])};
    if (!isFinite(ray.o) || !isFinite(ray.d)) throw std::invalid_argument("--ray: a number is not finite");
    if (ray.d == V3d(0, 0, 0)) throw std::invalid_argument("--ray: the direction is zero");
    return ray;
}

/// All that are shown; or those with this name, or else the one of this number, counted from 1 among those shown.
/// \param none what to say when none is shown
std::vector<FoundProfile> chosen(const std::vector<FoundProfile>& all, const std::string& only,
                                 const std::string& none) {
    std::vector<FoundProfile> shown, named;
    std::vector<std::string> names;
    for (const FoundProfile& profile : all) {
        if (!profile.hidden) shown.push_back(profile);
        for (const std::string& name : profile.names)
            if (!name.empty()) names.push_back(name);
        if (std::find(profile.names.begin(), profile.names.end(), only) != profile.names.end())
            named.push_back(profile);
    }
    if (!only.empty() && !named.empty()) return named;
    if (only.empty() && !shown.empty()) return shown;
    for (std::size_t i = 0; i < shown.size(); ++i)
        if (std::to_string(i + 1) == only) return {shown[i]};
    std::string message = shown.empty() ? none
                          : shown.size() == 1
                              ? fmt::format("--only {}: the only profile has the number 1", only)
                              : fmt::format("--only {}: the profiles have the numbers 1 to {}", only, shown.size());
    if (const std::string hint = didYouMean(only, names); !hint.empty()) message += "\n    " + hint;
    throw std::invalid_argument(message);
}

void write(const plot::Figure& figure, const std::string& file) {
    if (lowerExtension(file) == ".svg") {
        const std::string text = plot::toSvg(figure);
        replaceFile(file, {std::as_bytes(std::span(text))});
    } else {
        const auto bytes = plot::toPng(figure, pixelsPerPoint);
        replaceFile(file, {bytes});
    }
}

void tell(const std::vector<Diagnostic>& warnings) {
    for (const Diagnostic& warning : warnings)
        tellLine("{}", warning.toString());
}

void drawProfiles(ProfileArguments a) {
    const std::optional<Ray> ray = readRay(a.ray);
    if (a.output.empty()) a.output = fs::path(a.file).stem().string() + "_profile.svg";
    if (const std::string kind = lowerExtension(a.output); kind != ".svg" && kind != ".png")
        throw std::invalid_argument(fmt::format("{}: a figure is written as .svg or .png", a.output));
    std::error_code ignored;
    if (fs::equivalent(a.output, a.file, ignored))
        throw std::invalid_argument(fmt::format("{}: the figure would replace what is drawn", a.output));

    const bool isSvg = lowerExtension(a.file) == ".svg" || lowerExtension(a.file) == ".svgz";
    if (!isSvg && !a.settings.empty())
        throw std::invalid_argument("--set says where the axis is in an SVG file: a scene says so itself");
    const FoundProfiles found = isSvg ? profilesOfSvg(a.file, a.settings, ray) : profilesOfScene(a.file, ray);
    if (a.only.empty() || !isSvg) tell(found.warnings); // of an SVG file: about the other outlines
    const std::string none = fmt::format("{}: there is no {}", a.file,
                                         isSvg ? "outline in this drawing" : "shape \"revolution\" in this scene");
    plot::Figure figure;
    std::vector<Diagnostic> warnings;
    for (const FoundProfile& profile : chosen(found.profiles, a.only, none))
        plot::addProfile(figure, profile.draw(warnings));
    tell(warnings);
    write(figure, a.output);
}

} // namespace

void registerProfile(CLI::App& app) {
    auto* command = app.add_subcommand("profile", "Draw the profiles of a scene or of an SVG file");
    auto a = std::make_shared<ProfileArguments>();
    command->add_option("file", a->file, "Scene (every shape \"revolution\") or SVG file (every outline)")->required();
    command->add_option("-o,--outfile", a->output,
                        "Figure to write: .svg or .png; by default FILE's name with _profile.svg");
    command->add_option("--only", a->only, "The profile of this number, from 1, or with this id in an SVG file");
    command
        ->add_option(
            "--set", a->settings,
            "key=value: where the axis is in an SVG file, as in Shape \"revolution\" (origin, axis, flipx, flipy, "
            "scale, unit)")
        ->take_all()
        ->allow_extra_args(false);
    command->add_option(
        "--ray", a->ray,
        "ox,oy,oz,dx,dy,dz: also draw where this ray meets the profile, turned. World space; for an SVG "
        "file the profile's own space");
    command->callback([a] { drawProfiles(*a); });
}
