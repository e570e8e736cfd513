// lixel-bench-shapes: what it costs to read the shapes of a mesh from its buffers, in the frame
// that first sees it and in those after it, and how many frames it takes.
//
//     lixel-bench-shapes [--vertices N]
//
// Twice, with buffers that have a shadow copy in memory and with write-only ones that have none.
// Times are CPU time of the process, Mesa's threads included. A frame's time is spent by counting
// what is read (plugin/scene/MeshReading.cpp); here stands what that took.
#include "HeadlessOgre.h"

#include "scene/MeshShapes.h"

#include <OgreEntity.h>
#include <OgreHardwareBufferManager.h>
#include <OgreMesh.h>
#include <OgreMeshManager.h>
#include <OgreSceneManager.h>
#include <OgreSubMesh.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace Lixel::Tests {
namespace {

double millisecondsSince(std::clock_t begin) {
    return 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// A landscape of side x side vertices.
Ogre::MeshPtr makeHills(const std::string& name, unsigned side, bool shadowBuffers) {
    const Ogre::MeshPtr mesh =
        Ogre::MeshManager::getSingleton().createManual(name, Ogre::RGN_DEFAULT);
    Ogre::SubMesh* const part = mesh->createSubMesh();
    part->useSharedVertices = false;
    part->vertexData = OGRE_NEW Ogre::VertexData();
    part->vertexData->vertexCount = Ogre::uint32{side} * side;
    Ogre::VertexDeclaration& declaration = *part->vertexData->vertexDeclaration;
    declaration.addElement(0, 0, Ogre::VET_FLOAT3, Ogre::VES_POSITION);
    declaration.addElement(0, 12, Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
    declaration.addElement(0, 24, Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
    std::vector<float> floats;
    const auto last = static_cast<float>(side - 1);
    for (unsigned z = 0; z < side; ++z)
        for (unsigned x = 0; x < side; ++x) {
            const float u = static_cast<float>(x) / last;
            const float v = static_cast<float>(z) / last;
            const float height = 0.3f * std::sin(7 * u) * std::sin(5 * v);
            floats.insert(floats.end(), {u - 0.5f, height, v - 0.5f, 0, 1, 0, u, v});
        }
    auto& buffers = Ogre::HardwareBufferManager::getSingleton();
    const auto vertices =
        buffers.createVertexBuffer(declaration.getVertexSize(0), part->vertexData->vertexCount,
                                   Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY, shadowBuffers);
    vertices->writeData(0, floats.size() * sizeof(float), floats.data());
    part->vertexData->vertexBufferBinding->setBinding(0, vertices);
    std::vector<std::uint32_t> indices;
    for (unsigned z = 0; z + 1 < side; ++z)
        for (unsigned x = 0; x + 1 < side; ++x) {
            const unsigned i = z * side + x;
            indices.insert(indices.end(), {i, i + side, i + 1, i + 1, i + side, i + side + 1});
        }
    part->indexData->indexCount = static_cast<Ogre::uint32>(indices.size());
    part->indexData->indexBuffer =
        buffers.createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT, indices.size(),
                                  Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY, shadowBuffers);
    part->indexData->indexBuffer->writeData(0, indices.size() * sizeof(std::uint32_t),
                                            indices.data());
    mesh->_setBounds(Ogre::AxisAlignedBox(-0.5f, -0.3f, -0.5f, 0.5f, 0.3f, 0.5f), false);
    mesh->_setBoundingSphereRadius(1);
    mesh->load();
    return mesh;
}

/// Frame by frame until the shape is there.
void measure(const char* what, const std::function<const void*(MeshShapes&)>& shape) {
    MeshShapes atOnce;
    atOnce.setFrameTime(std::numeric_limits<double>::infinity());
    atOnce.beginPicture(1);
    const std::clock_t beginAtOnce = std::clock();
    shape(atOnce);
    const double whole = millisecondsSince(beginAtOnce);

    MeshShapes meshes;
    std::vector<double> frames;
    const void* found = nullptr;
    while (found == nullptr && frames.size() < 100000) {
        meshes.beginPicture(frames.size() + 1);
        const std::clock_t begin = std::clock();
        found = shape(meshes);
        frames.push_back(millisecondsSince(begin));
    }
    double sum = 0.0;
    for (const double frame : frames)
        sum += frame;
    const double first = frames.front();
    std::sort(frames.begin(), frames.end());
    std::printf("%-8s |%10.2f |%8zu %8.3f %8.3f %8.3f %8.3f\n", what, whole, frames.size(), first,
                sum / static_cast<double>(frames.size()), frames[frames.size() * 99 / 100],
                frames.back());
    std::fflush(stdout);
}

int run(int argc, char** argv) {
    int vertices = 1000000;
    if (argc == 3 && std::string(argv[1]) == "--vertices") vertices = std::atoi(argv[2]);
    if ((argc != 1 && argc != 3) || vertices < 4) {
        std::fprintf(stderr, "usage: lixel-bench-shapes [--vertices N]\n");
        return 2;
    }
    const auto side = static_cast<unsigned>(std::sqrt(vertices));
    HeadlessOgre ogre;
    Ogre::SceneManager& manager = *ogre.root().createSceneManager(DefaultManager);
    std::printf("A mesh of %u vertices and %u triangles; milliseconds; of a frame's time, %.3f may "
                "go into reading meshes\n\n",
                side * side, 2 * (side - 1) * (side - 1), MeshShapes::DefaultFrameTime / 1000.0);
    std::printf("         |prepared  |within frames                             \n");
    std::printf("         |at once   |  frames    first     mean     99 %%  longest\n");
    for (const bool shadowBuffers : {true, false}) {
        std::printf("%s\n", shadowBuffers ? "with shadow copies:" : "without:");
        const Ogre::MeshPtr mesh =
            makeHills(shadowBuffers ? "with" : "without", side, shadowBuffers);
        Ogre::Entity* const entity = manager.createEntity(mesh);
        entity->setMaterialName("BaseWhite"); // which has no programs
        measure("hull", [&](MeshShapes& meshes) { return meshes.hullOf(*entity); });
        measure("surface", [&](MeshShapes& meshes) { return meshes.cloudOf(*entity); });
    }
    return 0;
}

} // namespace
} // namespace Lixel::Tests

int main(int argc, char** argv) {
    try {
        return Lixel::Tests::run(argc, argv);
    } catch (const std::exception& exception) {
        std::fprintf(stderr, "lixel-bench-shapes: %s\n", exception.what());
        return 1;
    }
}
