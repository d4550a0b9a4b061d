// Scene texts that together use everything that is supported, small enough to be built ten thousand times a minute.
#pragma once

#include <string>
#include <vector>

namespace vitrine::test {

struct SampleScene {
    std::string name;
    std::string text;
};

/// Header (camera, film, filter, sampler, integrator) number `n` of its combinations; ends with WorldBegin.
std::string sampleHeader(unsigned n);

/// One scene each for analytic shapes, meshes and instances, materials, lights, blocks and spaces, and files. The last
/// needs what writeSampleFiles() writes, in the folder that it is read in.
std::vector<SampleScene> sampleScenes();

/// Everything in one scene.
std::string wholeSample();

/// A PLY mesh, a spectrum, an environment picture and an included scene text.
void writeSampleFiles(const std::string& folder);

} // namespace vitrine::test
