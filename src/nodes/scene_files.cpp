// Include and Import.
#include "nodes/scene_reader.h"
#include "nodes/source.h"
#include "nodes/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace vitrine {

namespace {

constexpr std::size_t maxDepth = 100;   ///< of nested files
constexpr std::size_t maxFiles = 20000; ///< two lines a file that include twice each would double this at every level

} // namespace

std::string resolveIn(const std::string& baseDirectory, const std::string& includingFile, const std::string& fileName) {
    namespace fs = std::filesystem;
    const fs::path name(fileName);
    if (name.is_absolute()) return fileName;
    const std::string inBase = (fs::path(baseDirectory) / name).string();
    std::error_code error;
    if (fs::exists(inBase, error)) return inBase;
    const std::string beside = (fs::path(includingFile).parent_path() / name).string();
    return fs::exists(beside, error) ? beside : inBase;
}

std::string SceneReader::openFile(const std::string& fileName) {
    std::string text = readWholeFile(fileName, budget_, true);
    std::error_code error;
    openFiles_.push_back(std::filesystem::weakly_canonical(fileName, error));
    return text;
}

std::shared_ptr<const SourceFile> SceneReader::openIncluded() {
    const Place place = lexer_->place(lexer_->peek());
    const std::string fileName = lexer_->takeString("the name of a file");
    if (fileName.empty()) throw SceneError(place, "the file name is empty");
    if (openFiles_.size() >= maxDepth)
        throw SceneError(place, fmt::format("files include each other more than {} deep", maxDepth));
    if (++includedFiles_ > maxFiles)
        throw SceneError(place, fmt::format("the scene includes more than {} files", maxFiles));
    auto file = std::make_shared<SourceFile>();
    file->name = resolveIn(nodes_.baseDirectory, place.file->name, fileName);
    file->includedFrom = place.file;
    file->includedAtLine = place.line;
    std::error_code error;
    const auto path = std::filesystem::weakly_canonical(file->name, error);
    if (std::find(openFiles_.begin(), openFiles_.end(), path) != openFiles_.end())
        throw SceneError(place, fmt::format("{} includes itself", inQuotes(fileName)));
    try {
        file->text = readWholeFile(file->name, budget_);
    } catch (const FileError& e) {
        throw SceneError(place, e.what());
    }
    checkIsText(file);
    openFiles_.push_back(path);
    return file;
}

void SceneReader::readIncluded(const std::shared_ptr<const SourceFile>& file) {
    readText(file);
    openFiles_.pop_back();
}

void SceneReader::include() {
    readIncluded(openIncluded());
}

void SceneReader::import() {
    const auto file = openIncluded();
    const auto state = states_.save();
    const auto systems = coordinateSystems_;
    const std::size_t floor = std::exchange(importFloor_, states_.open());
    readIncluded(file);
    closeBlocksDownTo(importFloor_);
    importFloor_ = floor;
    coordinateSystems_ = systems;
    states_.restore(state);
}

} // namespace vitrine
