#include "spectrum/uplift_table.h"

// The file comes with the build (src/spectrum/tools/table.cmake); as source it would take a compiler minutes.
asm(R"(
    .section .rodata
    .balign 64
    .globl vitrine_uplift_srgb
vitrine_uplift_srgb:
    .incbin ")" VITRINE_UPLIFT_SRGB R"("
    .previous
)");

extern "C" const vitrine::UpliftTable vitrine_uplift_srgb;

namespace vitrine {

const UpliftTable& UpliftTable::srgb() {
    return vitrine_uplift_srgb;
}

} // namespace vitrine
