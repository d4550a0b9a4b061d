// Runs the directives of scene texts, in the order written, into SceneNodes.
#pragma once

#include "nodes/graphics_state.h"
#include "nodes/lexer.h"
#include "nodes/name_table.h"
#include "nodes/parser.h"
#include "nodes/source.h"

#include <filesystem>
#include <map>
#include <set>
#include <span>

namespace vitrine {

class SceneReader {
  public:
    SceneReader(std::string name, std::string baseDirectory);

    /// The text of the scene's own file, which no other may include. \throws FileError
    std::string openFile(const std::string& fileName);
    /// Reads the scene's own text. Errors are kept for finish().
    void read(const std::shared_ptr<const SourceFile>& file);
    /// Checks what can be checked only at the end.
    ParsedScene finish();

  private:
    enum class Where { Anywhere, Options, World };
    struct Directive {
        Where where;
        void (SceneReader::*run)();
    };
    static const std::map<std::string_view, Directive>& directives();

    // The loop (scene_reader.cpp).
    void readText(const std::shared_ptr<const SourceFile>& file);
    void runDirective(const Token& token);
    void checkWhere(Where where);
    void skipToDirective();
    [[noreturn]] void refuseToken(const Token& token) const;
    void fail(const SceneError& error);
    void warnOnce(const std::string& message, const std::string& hint);

    // Other files (scene_files.cpp).
    void include();
    void import();
    std::shared_ptr<const SourceFile> openIncluded();
    void readIncluded(const std::shared_ptr<const SourceFile>& file);

    // Blocks and attributes (scene_blocks.cpp).
    void worldBegin();
    void attributeBegin();
    void attributeEnd();
    void transformBegin();
    void transformEnd();
    void objectBegin();
    void objectEnd();
    void objectInstance();
    void attribute();
    void reverseOrientation();
    void colorSpace();
    void mediumInterface();
    void namedMaterial();
    void closeBlock();
    void closeBlocksDownTo(std::size_t open);

    // Transformations (scene_transforms.cpp).
    void identity();
    void translate();
    void scale();
    void rotate();
    void lookAtDirective();
    void transform();
    void concatTransform();
    void coordinateSystem();
    void coordSysTransform();
    void activeTransform();
    void transformTimes();
    void takeNumbers(std::span<double> numbers);
    void takeMatrix(std::span<double, 16> numbers);
    void concat(const Transform& transform);

    // Everything that becomes a node (scene_entities.cpp).
    void option();
    void camera();
    void sampler();
    void integrator();
    void pixelFilter();
    void film();
    void accelerator();
    void shape();
    void lightSource();
    void areaLightSource();
    void material();
    void makeNamedMaterial();
    void makeNamedMedium();
    void texture();
    Node readNode();
    Node readNode(AttributeTarget target);
    bool readNamedNode(Node& node, AttributeTarget target);
    int useMedium(const std::string& name, const Place& place);

    SceneNodes nodes_;
    Diagnostics diagnostics_;
    StateStack states_;
    NameTable materialNames_{"material"}, mediumNames_{"medium"}, objectNames_{"object"};
    std::map<std::string, Place> textureNames_[2]; ///< float, spectrum
    std::map<std::string, MovingTransformPtr> coordinateSystems_;
    std::vector<int> objects_; ///< open definitions, innermost last; more than one only after an error

    bool inWorld_ = false;
    bool nodesTellMore_ = true;       ///< ParsedScene::nodesTellMore
    bool structureUncertain_ = false; ///< after an unknown directive, which may have been a block's begin or end
    bool reportedMissingWorld_ = false;
    std::set<std::string> warned_;
    std::size_t importFloor_ = 0; ///< blocks below it belong to the importing file

    Lexer* lexer_ = nullptr;
    Place place_;           ///< of the directive that runs
    std::string directive_; ///< its name
    std::vector<std::filesystem::path> openFiles_;
    std::size_t includedFiles_ = 0;
    TextBudget budget_;
};

/// As resolveFile(), from the two directories.
std::string resolveIn(const std::string& baseDirectory, const std::string& includingFile, const std::string& fileName);

} // namespace vitrine
