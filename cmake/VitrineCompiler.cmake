# One set of flags for every target.
#
# -fno-tree-slp-vectorize: GCC packs the coordinates of 3-vectors into registers of four and unpacks them again, which
# makes a path trace 7 % slower than leaving them alone (docs/benchmarks.md). Loops are still vectorised.
#
# -ffp-contract=off: whether a*b+c becomes one rounding or two must not depend on inlining, or the exact predicates of
# the root finder and the reproducibility of pictures go. Where a fused operation is wanted, std::fma is written.
add_library(vitrine_flags INTERFACE)
target_compile_options(vitrine_flags INTERFACE
  -march=${VITRINE_ARCH} -ffp-contract=off -fno-math-errno -fno-trapping-math -fno-tree-slp-vectorize
  -Wall -Wextra -Wpedantic -Wshadow=local -Wnon-virtual-dtor -Wno-psabi)

set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

if(VITRINE_SANITIZE)
  target_compile_options(vitrine_flags INTERFACE -fsanitize=${VITRINE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(vitrine_flags INTERFACE -fsanitize=${VITRINE_SANITIZE})
endif()

find_program(VITRINE_CCACHE ccache)
if(VITRINE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # The sloppiness is what ccache's manual asks for with precompiled headers.
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${VITRINE_CCACHE})
  target_compile_options(vitrine_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()
