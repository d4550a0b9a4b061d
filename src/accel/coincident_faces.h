// Faces of different shapes in the very same plane: a glass on the table it stands on. Embree reports either of them.
#pragma once

#include "accel/embree_query.h"

namespace vitrine::embree {

/// Lists of faces that a hit may have to give way to, in the order of their numbers.
class CoincidentFaces {
  public:
    /// Finds, for each face of the table, the faces of shapes with a lower number that overlap it in its plane, and
    /// writes where its list is into PrimitiveRef::rivals.
    explicit CoincidentFaces(std::vector<PrimitiveRef>& table);

    /// \param rivals PrimitiveRef::rivals, not 0
    const std::vector<PrimitiveRef>& list(std::uint32_t rivals) const { return lists_[rivals - 1]; }

  private:
    std::vector<std::vector<PrimitiveRef>> lists_;
};

} // namespace vitrine::embree
