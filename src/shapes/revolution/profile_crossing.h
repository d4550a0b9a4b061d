// Closed profiles that cross themselves: no one sign makes their normals point out of what they enclose.
#pragma once

#include "shapes/revolution/profile.h"

#include <optional>

namespace vitrine {

/// A place of a closed profile whose inner side, by Profile::drawnInsideOut(), does not lie in the solid once.
struct WrongSide {
    V2d p;
    int winding; ///< of the inner side; 1 would be right, 0 and less is a lobe inside out, more is covered repeatedly
};

/// Several places in every monotone part are looked at; one in the longest wrong stretch is returned. Lobes and overlaps
/// thinner than a millionth of the profile's size are passed over, and so are lines that are drawn twice. Nothing for open
/// profiles.
std::optional<WrongSide> findWrongSide(const Profile& profile);

} // namespace vitrine
