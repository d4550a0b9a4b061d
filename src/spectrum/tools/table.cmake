# The table of sigmoid polynomials (src/spectrum/uplift_table.h): a program of ours makes it in a second or two, and
# uplift_table.cpp links it in. Optimised and without sanitizers in every configuration: it is a tool, not the library.
find_package(Threads REQUIRED)
add_executable(make_uplift_table spectrum/tools/make_table.cpp spectrum/uplift_solver.cpp)
target_include_directories(make_uplift_table PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_compile_options(make_uplift_table PRIVATE
  -O3 -march=${VITRINE_ARCH} -ffp-contract=off -fno-math-errno -fno-trapping-math -Wall -Wextra -Wpedantic -Wshadow -Wno-psabi)
target_link_libraries(make_uplift_table PRIVATE Threads::Threads)

set(uplift_srgb ${CMAKE_CURRENT_BINARY_DIR}/uplift_srgb.bin)
add_custom_command(OUTPUT ${uplift_srgb}
  COMMAND make_uplift_table ${uplift_srgb}
  DEPENDS make_uplift_table
  COMMENT "Fitting spectra to sRGB colours" VERBATIM)
target_sources(vitrine_spectrum PRIVATE ${uplift_srgb})
set_source_files_properties(spectrum/uplift_table.cpp PROPERTIES
  OBJECT_DEPENDS ${uplift_srgb}
  COMPILE_DEFINITIONS VITRINE_UPLIFT_SRGB="${uplift_srgb}")
