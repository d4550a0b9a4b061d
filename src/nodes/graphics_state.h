// What AttributeBegin saves: pbrt-v4's graphics state.
#pragma once

#include "nodes/nodes.h"

#include <array>
#include <memory>

namespace vitrine {

enum class AttributeTarget { Shape, Light, Material, Medium, Texture };

struct GraphicsState {
    MovingTransformPtr ctm = std::make_shared<MovingTransform>(); ///< world from object
    bool startActive = true, endActive = true;                    ///< ActiveTransform
    bool reverseOrientation = false;
    std::string colorSpace = "srgb";
    int material = 0, areaLight = -1;
    int insideMedium = -1, outsideMedium = -1;
    std::array<std::shared_ptr<const ParameterList>, 5> defaults; ///< by AttributeTarget, newest first

    /// Replaces the active transformations. \throws std::domain_error
    template <class F>
    void changeTransform(F&& change) {
        auto changed = std::make_shared<MovingTransform>(*ctm);
        if (startActive) changed->start = change(ctm->start);
        if (endActive) changed->end = change(ctm->end);
        ctm = std::move(changed);
    }
};

/// The current state and the saved ones. A saved state is shared until the current one changes: a million nested
/// AttributeBegin cost a pointer each.
class StateStack {
  public:
    enum class Block { Attribute, Object };
    struct Open {
        std::shared_ptr<GraphicsState> saved;
        Block block;
        Place place;
    };

    const GraphicsState& current() const { return *current_; }
    /// The current state, to be changed.
    GraphicsState& edit() {
        if (current_.use_count() > 1) current_ = std::make_shared<GraphicsState>(*current_);
        return *current_;
    }

    void push(Block block, Place place) { open_.push_back({current_, block, std::move(place)}); }
    /// Precondition: open() > 0.
    void pop() {
        current_ = std::move(open_.back().saved);
        open_.pop_back();
    }
    std::size_t open() const { return open_.size(); }
    const Open& top() const { return open_.back(); }
    const Open& at(std::size_t index) const { return open_[index]; }

    /// The state by itself, for Import: put back with restore().
    std::shared_ptr<GraphicsState> save() const { return current_; }
    void restore(std::shared_ptr<GraphicsState> state) { current_ = std::move(state); }

  private:
    std::shared_ptr<GraphicsState> current_ = std::make_shared<GraphicsState>();
    std::vector<Open> open_;
};

} // namespace vitrine
