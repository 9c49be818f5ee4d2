// Shapes from files: OBJ, glTF and binary glTF, valid and invalid.

#include <gtest/gtest.h>

#include <fstream>

#include "demos/load/load_scene.h"
#include "demos/play/stage.h"
#include "demos/scene/mesh_file.h"
#include "engine/shapes/hull.h"
#include "engine/shapes/mass.h"
#include "engine/shapes/mesh.h"
#include "tests/demos/reading.h"
#include "tests/support/temporary_folder.h"

namespace demos::test {
namespace {

const std::string kTetrahedron =
    "# four faces, one given backwards\nmtllib none.mtl\no rock\nv 0 0 0\nv +1 0 0\nv 0 1. 0\n"
    "v 0 0 1e0 1.0\nvt 0 0\ns off\nf 1/1 3/1 2/1\r\nf 1 2 4\nf -3//1 -2//1 -1//1\nf 1 4 3";

/// Three positions and three indices as in glTF, little-endian.
std::string triangleBytes() {
    std::string bytes;
    const float positions[] = {0, 0, 0, 0, 0, 2, 2, 0, 0};
    const std::uint16_t numbers[] = {0, 1, 2};
    bytes.append(reinterpret_cast<const char*>(positions), sizeof positions);
    bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
    return bytes;
}

/// The same 42 bytes.
const std::string kBase64 = "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAABAAAAAQAAAAAAAAAAAAAABAAIA";

struct Gltf {
    std::string buffer =
        R"({"uri":"data:application/octet-stream;base64,)" + kBase64 + R"(","byteLength":42})";
    std::string views =
        R"({"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6})";
    std::string positions = R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})";
    std::string numbers = R"({"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"})";
    std::string part = R"({"attributes":{"POSITION":0},"indices":1})";
    std::string nodes = R"({"mesh":0})";
    std::string more = R"("asset":{"version":"2.0"},"scenes":[{"nodes":[0]}])";

    std::string text() const {
        return "{" + more + R"(,"buffers":[)" + buffer + R"(],"bufferViews":[)" + views +
               R"(],"accessors":[)" + positions + "," + numbers + R"(],"meshes":[{"primitives":[)" +
               part + R"(]}],"nodes":[)" + nodes + "]}";
    }
};

std::string word(std::uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xffu);
    return bytes;
}

std::string glb(std::string text, const std::string& binary) {
    while (text.size() % 4 != 0) text += ' ';
    const auto size = [](const std::string& s) { return static_cast<std::uint32_t>(s.size()); };
    return "glTF" + word(2) + word(12 + 8 + size(text) + 8 + size(binary)) + word(size(text)) +
           "JSON" + text + word(size(binary)) + std::string("BIN\0", 4) + binary;
}

class MeshFiles : public testing::Test {
protected:
    void write(const std::string& name, const std::string& bytes) {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
    }

    SceneDescription read(const std::string& shape, const std::string& more = "fixed = true\n") {
        return readScene(text(shape, more), "a.toml", "a", {}, folder_.path());
    }

    /// The error message about a file.
    std::string errorOf(const std::string& name, const std::string& bytes,
                        const std::string& key = "mesh") {
        write(name, bytes);
        try {
            read(key + " = '" + name + "'");
        } catch (const SceneError& error) {
            return error.what();
        }
        return "nothing";
    }

    static std::string text(const std::string& shape, const std::string& more) {
        return "format = 1\n[[body]]\nname = 'b'\nshape = { " + shape + " }\n" + more;
    }

    support::TemporaryFolder folder_;
};

TEST_F(MeshFiles, AnObjIsAHullOrAMesh) {
    write("rock.obj", kTetrahedron);
    const engine::Shape hull = read("hull = 'rock.obj', scale = 2", "").bodies[0].def.shape;
    EXPECT_NEAR(engine::volume(hull), 8.0 / 6.0, 1e-14);
    EXPECT_NEAR((hull.origin + Vec3(0.5, 0.5, 0.5)).norm(), 0.0, 1e-14);
    const engine::Shape mesh = read("mesh = 'rock.obj'").bodies[0].def.shape;
    ASSERT_EQ(mesh.mesh->triangles.size(), 4u);
    EXPECT_EQ(mesh.mesh->corners[3], Vec3(0, 0, 1));
    Vec3 sum = Vec3::Zero();  // the faces of a closed mesh cancel: none is reversed
    for (const engine::Mesh::Triangle& t : mesh.mesh->triangles)
        sum +=
            0.5 * (mesh.mesh->corners[t.corners[1]] - mesh.mesh->corners[t.corners[0]])
                      .cross(mesh.mesh->corners[t.corners[2]] - mesh.mesh->corners[t.corners[0]]);
    EXPECT_NEAR(sum.norm(), 0.0, 1e-15);
}

/// An L of six corners, which a fan from its first corner does not fill.
TEST_F(MeshFiles, FacesAreCutIntoTriangles) {
    const TriangleMesh mesh =
        objMesh("v 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nv 2 0 0\nf 1 2 3 4 5 6\n");
    ASSERT_EQ(mesh.triangles.size(), 4u);
    double area = 0.0;
    for (const auto& t : mesh.triangles) {
        const Vec3 a = mesh.corners[t[0]], b = mesh.corners[t[1]], c = mesh.corners[t[2]];
        const double z = 0.5 * (b - a).cross(c - a).z();
        EXPECT_GT(z, 0.0);  // counter-clockwise, like the face
        area += z;
    }
    EXPECT_NEAR(area, 3.0, 1e-14);
}

TEST_F(MeshFiles, NumbersAreReadToTheLastBit) {
    const TriangleMesh mesh = objMesh("v 0.1 1e-3 123456.789012345678\n");
    EXPECT_EQ(mesh.corners.at(0), Vec3(0.1, 1e-3, 123456.789012345678));
}

TEST_F(MeshFiles, ABackslashContinuesALine) {
    const TriangleMesh mesh = objMesh(
        "# no line goes on: \\\nv 0 \\\n0\\\r\n 0\nv 1 0 0\nv 0 1 0\nf \\\n1 2\\\n 3\nf 3 2 1\\");
    ASSERT_EQ(mesh.corners.size(), 3u);
    EXPECT_EQ(mesh.corners[0], Vec3(0, 0, 0));
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.triangles[0], (std::array<int, 3>{0, 1, 2}));
    // The error is at the first of the joined lines.
    EXPECT_NE(errorOf("bad.obj", "v 0 0 0\n\nv 1 \\\n2 \\\nx\nv 0 1 0\n").find("line 3: 'x' should be"),
              std::string::npos);
}

TEST_F(MeshFiles, ManyBodiesShareAFile) {
    write("rock.obj", kTetrahedron);
    const SceneDescription scene = readScene(
        "format = 1\n[[repeat]]\ncount = 3\nbody = { name = 'b{i}', shape = { hull = 'rock.obj' } "
        "}\n"
        "[[body]]\nname = 'large'\nshape = { hull = 'rock.obj', scale = 2 }\n",
        "a.toml", "a", {}, folder_.path());
    EXPECT_EQ(scene.bodies[0].def.shape.hull, scene.bodies[2].def.shape.hull);
    EXPECT_NE(scene.bodies[0].def.shape.hull, scene.bodies[3].def.shape.hull);
    // Prevents resuming a film after a file was changed.
    const std::uint64_t before = read("hull = 'rock.obj'", "").contents;
    EXPECT_EQ(read("hull = 'rock.obj'", "").contents, before);
    write("rock.obj", "v 0 0 -1\n" + kTetrahedron);
    EXPECT_NE(read("hull = 'rock.obj'", "").contents, before);
}

TEST_F(MeshFiles, AreLookedForBesideTheScene) {
    write("rock.obj", kTetrahedron);
    write("a.toml", text("hull = 'rock.obj'", ""));
    const SceneDescription scene = loadScene((folder_ / "a.toml").string());
    EXPECT_EQ(scene.bodies[0].def.shape.hull->corners.size(), 4u);
}

TEST_F(MeshFiles, GltfInItsThreeForms) {
    Gltf file;
    write("data.gltf", file.text());
    file.buffer = R"({"uri":"the%20triangle.bin","byteLength":42})";
    write("beside.gltf", file.text());
    write("the triangle.bin", triangleBytes());
    file.buffer = R"({"byteLength":42})";
    write("all.glb", glb(file.text(), triangleBytes()));
    for (const char* name : {"data.gltf", "beside.gltf", "all.glb"}) {
        const engine::Mesh mesh =
            *read(std::string("mesh = '") + name + "'").bodies[0].def.shape.mesh;
        ASSERT_EQ(mesh.triangles.size(), 1u) << name;
        EXPECT_EQ(mesh.corners[2], Vec3(2, 0, 0)) << name;
        EXPECT_EQ(mesh.triangles[0].normal, Vec3(0, 1, 0)) << name;
    }
}

TEST_F(MeshFiles, GltfNodesPlaceTheirMeshes) {
    Gltf file;
    file.part = R"({"attributes":{"POSITION":0}})";  // without indices: corner after corner
    file.nodes = R"({"children":[2,1],"translation":[1,0,0]},{"mesh":0,"scale":[-1,1,1]},)"
                 R"({"mesh":0,"rotation":[0,1,0,0],"translation":[0,5,0]},)"
                 R"({"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,7,1]})";
    file.more = R"("asset":{"version":"2.0"},"scene":1,"scenes":[{},{"nodes":[0,3]}])";
    const TriangleMesh mesh = gltfMesh(file.text(), folder_.path());
    ASSERT_EQ(mesh.corners.size(), 9u);
    EXPECT_NEAR((mesh.corners[2] - Vec3(-1, 5, 0)).norm(), 0.0, 1e-15);  // half a turn about y
    EXPECT_EQ(mesh.corners[5], Vec3(-1, 0, 0));
    EXPECT_EQ(mesh.corners[8], Vec3(2, 0, 7));
    EXPECT_EQ(mesh.triangles[1], (std::array<int, 3>{3, 5, 4}));  // mirrored, so the order is reversed
}

/// Outputs must not overwrite these files: each is listed once, also the buffer of a glTF file.
TEST_F(MeshFiles, TheSceneNamesEveryFileThatItReads) {
    write("rock.obj", kTetrahedron);
    Gltf file;
    file.buffer = R"({"uri":"my%20bytes.bin","byteLength":42})";
    write("a.gltf", file.text());
    write("my bytes.bin", triangleBytes());
    const SceneDescription scene = readScene(
        "format = 1\n[[body]]\nname = 'a'\nshape = { hull = 'rock.obj' }\n[[body]]\nname = 'b'\n"
        "shape = { hull = 'rock.obj', scale = 2 }\nat = [9, 0, 0]\n[[body]]\nname = 'c'\n"
        "fixed = true\nshape = { mesh = 'a.gltf' }\nat = [0, 9, 0]\n",
        "s.toml", "s", {}, folder_.path());
    EXPECT_EQ(scene.files, (std::vector<std::string>{(folder_ / "rock.obj").string(),
                                                     (folder_ / "a.gltf").string(),
                                                     (folder_ / "my bytes.bin").string()}));
}

TEST_F(MeshFiles, BrokenObjFilesAreReported) {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const std::pair<std::string, const char*> bad[] = {
        {"v 1 2\n", "a.toml:4:11: bad.obj: line 1: 2 coordinates; a corner should have three"},
        {"\nv 1 x 2\n", "line 2: 'x' should be a finite number"},
        {"v 1 nan 2\n", "'nan' should be a finite number"},
        {"v 1 1e999 2\n", "'1e999' should be a finite number"},
        {corners + "f 1 2\n", "line 4: a face of 2 corners; it should have 3 to 256"},
        {corners + "f 1 2 0\n", "'0' should be a corner's number"},
        {corners + "f 1 2 3x\n", "'3x' should be a corner's number"},
        {corners + "f 1 2 4\n", "line 4: corner 4; the file has corners 1 to 3"},
        {corners + "f 1 2 -4\n", "line 4: corner -4; there are 3 corners before it"},
        {corners + "f 1 2 99999999999\n", "'99999999999' should be a corner's number"},
        {corners, "bad.obj has no triangles"},
        {corners + "f 1 2 2\n", "no triangle of bad.obj has an area"},
        {"", "bad.obj has no triangles"},
        {"v 1e6 0 0\n", "bad.obj has a point (1000000, 0, 0); all should be within 100000 m"},
    };
    for (const auto& [text, message] : bad)
        EXPECT_NE(errorOf("bad.obj", text).find(message), std::string::npos)
            << text << errorOf("bad.obj", text);
    EXPECT_NE(errorOf("flat.obj", corners, "hull").find("flat.obj is flat, 3 points"),
              std::string::npos);
}

TEST_F(MeshFiles, FilesThatAreNoneAreReported) {
    const auto error = [&](const std::string& name) {
        try {
            read("mesh = '" + name + "'");
        } catch (const SceneError& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_EQ(error("no.obj"), "a.toml:4:11: no.obj: there is no such file");
    std::filesystem::create_directory(folder_ / "dir.obj");
    EXPECT_NE(error("dir.obj").find("dir.obj: is not a regular file"), std::string::npos);
    EXPECT_NE(error("a.stl").find("a.stl: its name ends in '.stl'; it should end in .obj"),
              std::string::npos);
    write("large.obj", "");
    std::filesystem::resize_file(folder_ / "large.obj", (64u << 20) + 1);
    EXPECT_EQ(error(""),
              "a.toml:4:11: mesh is an empty text; it should be a file name, like \"rock.obj\"");
    EXPECT_NE(error("large.obj").find("is 67108865 bytes; it should be at most 64 MiB"),
              std::string::npos);
}

TEST_F(MeshFiles, BrokenGltfFilesAreReported) {
    const auto with = [](std::string Gltf::*part, const std::string& text) {
        Gltf file;
        file.*part = text;
        return file.text();
    };
    const std::string asset = R"("asset":{"version":"2.0"},)";
    const std::pair<std::string, const char*> bad[] = {
        {"{", "is not JSON; it should be glTF 2.0"},
        {"[]", "is not JSON"},
        {R"({"asset":{"version":"2.0"},"extensionsRequired":[)" + std::string(100'000, '[') +
             std::string(100'000, ']') + "]}",
         "is nested deeper than 64"},
        {with(&Gltf::more, R"("asset":{"version":"1.0"})"), "is not of version 2.0"},
        {with(&Gltf::more, asset + R"("extensionsRequired":["KHR_draco_mesh_compression"])"),
         "needs the extension 'KHR_draco_mesh_compression', which is not supported"},
        {with(&Gltf::more, asset + R"("extensionsRequired":[{"a":[1,2,3]}])"),
         "needs the extension that is object, which is not supported"},
        {with(&Gltf::more, R"("asset":{"version":"2.0"})"), "there is no scenes 0; it has 0"},
        {with(&Gltf::more, asset + R"("scenes":[{"nodes":[1]}])"), "there is no nodes 1; it has 1"},
        {with(&Gltf::more, asset + R"("scenes":[{"nodes":[-1]}])"), "should be numbers of nodes"},
        {with(&Gltf::more, asset + R"("scenes":[{"nodes":[]}])"), "has no triangles"},
        {with(&Gltf::nodes, R"({"children":[0]})"), "node 0 is a child of two nodes, or of itself"},
        {with(&Gltf::nodes, R"({"mesh":1})"), "there is no meshes 1"},
        {with(&Gltf::nodes, R"({"mesh":0,"skin":0})"), "skins are not supported"},
        {with(&Gltf::nodes, R"({"mesh":0,"scale":[1,2]})"), "a node's scale should be 3 numbers"},
        {with(&Gltf::nodes, R"({"mesh":0,"rotation":[0,0,0,0]})"), "should be a quaternion"},
        {with(&Gltf::nodes, R"({"mesh":0,"scale":[1e300,1,1]})"), "all should be within 100000 m"},
        {with(&Gltf::part, R"({"attributes":{}})"), "a primitive has no POSITION"},
        {with(&Gltf::part, R"({"attributes":{"POSITION":0},"mode":5})"),
         "a primitive of mode 5 is not supported; it should be 4, triangles"},
        {with(&Gltf::part, R"({"attributes":{"POSITION":0},"targets":[]})"), "morph targets"},
        {with(&Gltf::part, R"({"attributes":{"POSITION":1}})"),
         "accessor 1 should be VEC3 of floats"},
        {with(&Gltf::part, R"({"attributes":{"POSITION":0},"indices":0})"),
         "accessor 0 should be SCALAR of unsigned"},
        {with(&Gltf::part, R"({"attributes":{"POSITION":"0"}})"), "a 'POSITION' should be a whole"},
        {with(&Gltf::positions, R"({"bufferView":0,"componentType":5126,"count":2,"type":"VEC3"})"),
         "index 2 is not a corner of its primitive; it should be below 2"},
        {with(&Gltf::positions, R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})"),
         "accessor 0 reaches beyond the end of its buffer"},
        {with(&Gltf::positions,
              R"({"bufferView":0,"componentType":5126,"count":2147483647,"type":"VEC3"})"),
         "accessor 0 reaches beyond the end"},
        {with(&Gltf::positions, R"({"componentType":5126,"count":3,"type":"VEC3"})"),
         "lacks a 'bufferView'"},
        {with(&Gltf::positions,
              R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":{}})"),
         "accessor 0 is sparse"},
        {with(&Gltf::numbers, R"({"bufferView":1,"componentType":5123,"count":2,"type":"SCALAR"})"),
         "2 indices do not make triangles"},
        {with(&Gltf::views, R"({"buffer":0,"byteLength":36,"byteStride":4},{"buffer":0})"),
         "accessor 0 has a byteStride of 4; byteStride should be 12 or more"},
        {with(&Gltf::views, R"({"buffer":0,"byteOffset":40,"byteLength":36},{"buffer":0})"),
         "accessor 0 reaches beyond the end"},
        {with(&Gltf::views, R"({"buffer":1,"byteLength":36})"), "there is no buffers 1"},
        {with(&Gltf::buffer, R"({"byteLength":42})"), "buffer 0 has no uri and no binary chunk"},
        {with(&Gltf::buffer, R"({"uri":"data:;base64,AA#A","byteLength":42})"),
         "a data uri should be base64"},
        {with(&Gltf::buffer, R"({"uri":"data:;base64,AAAA","byteLength":42})"),
         "buffer 0 has 3 bytes; its byteLength is 42"},
        {with(&Gltf::buffer, R"({"uri":"none.bin","byteLength":42})"),
         "its buffer none.bin: there is no such file"},
        {with(&Gltf::buffer, R"({"uri":"data:;base64,AADAfwAAwH8AAMB/AADAfwAAwH8AAMB/AADAfwAAwH8)"
                             R"(AAMB/AAAAAAAA","byteLength":42})"),
         "accessor 0 holds a number that is not finite"},
    };
    for (const auto& [text, message] : bad)
        EXPECT_NE(errorOf("bad.gltf", text).find(message), std::string::npos)
            << text << "\n"
            << errorOf("bad.gltf", text) << "\nnot: " << message;
}

TEST_F(MeshFiles, AGltfFileReadsOnlyWhatIsBesideIt) {
    std::filesystem::create_directory(folder_ / "sub");
    write("outside.bin", triangleBytes());
    const std::string outside = (folder_ / "outside.bin").string();
    for (const char* uri : {outside.c_str(), "../outside.bin", "%2e%2e/outside.bin", "/dev/zero",
                            "sub/../../outside.bin"}) {
        Gltf file;
        file.buffer = R"({"uri":")" + std::string(uri) + R"(","byteLength":42})";
        EXPECT_NE(errorOf("sub/bad.gltf", file.text()).find("is outside the glTF file's folder"),
                  std::string::npos)
            << errorOf("sub/bad.gltf", file.text());
    }
    std::filesystem::create_symlink("../outside.bin", folder_ / "sub/link.bin");
    Gltf linked;
    linked.buffer = R"({"uri":"link.bin","byteLength":42})";
    EXPECT_NE(errorOf("sub/bad.gltf", linked.text()).find("is a link out of the glTF file's folder"),
              std::string::npos);
    Gltf file;
    file.buffer = R"({"uri":"file.bin%00","byteLength":42})";
    EXPECT_NE(errorOf("bad.gltf", file.text()).find("is not a file name"), std::string::npos);
}

TEST_F(MeshFiles, AnObjFileMayBeginWithAByteOrderMark) {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(errorOf("good.obj", "\xEF\xBB\xBF" + triangle), "nothing");
    const std::string zero("f 1 2 3\0\0\n", 10);
    EXPECT_NE(errorOf("bad.obj", triangle + zero).find("line 5: '3\\x00\\x00' should be a corner's number"),
              std::string::npos)
        << errorOf("bad.obj", triangle + zero);
}

TEST_F(MeshFiles, LongValuesAreCut) {
    const std::string many(3'000'000, '7');
    Gltf needy;
    needy.more = R"("asset":{"version":"2.0"},"extensionsRequired":[")" + many + "\"]";
    Gltf far;
    far.buffer = R"({"uri":")" + many + R"(","byteLength":42})";
    for (const std::string& error :
         {errorOf("bad.gltf", needy.text()), errorOf("bad.gltf", far.text()),
          errorOf("bad.obj", "v 1 2 x" + many), errorOf("bad.obj", "v 0 0 0\nf 1 1 " + many),
          errorsOf("format = 1\n[[body]]\nname = 'b'\nshape = { mesh = '" + many + ".obj' }\n")
              .front()}) {
        EXPECT_NE(error, "nothing");
        EXPECT_LT(error.size(), 300u) << error.substr(0, 300);
    }
}

TEST_F(MeshFiles, ManyScalesOfAFileAreTooMuchToRead) {
    write("large.obj", kTetrahedron + "\n#" + std::string(10u << 20, ' '));
    write("a.toml", "format = 1\n[[repeat]]\ncount = 40\nbody = { name = 'b{i}', "
                    "shape = { hull = 'large.obj', scale = '1 + i' } }\n");
    try {
        loadScene((folder_ / "a.toml").string());
        ADD_FAILURE() << "was read";
    } catch (const SceneError& error) {
        ASSERT_EQ(error.lines().size(), 1u);
        EXPECT_NE(error.lines()[0].find("more than 256 MiB of shapes are read"), std::string::npos)
            << error.lines()[0];
    }
}

TEST_F(MeshFiles, BrokenBinaryGltfFilesAreReported) {
    Gltf file;
    file.buffer = R"({"byteLength":42})";
    const std::string whole = glb(file.text(), triangleBytes());
    EXPECT_NE(errorOf("bad.glb", "glTF").find("is not a binary glTF of version 2"),
              std::string::npos);
    EXPECT_NE(errorOf("bad.glb", whole.substr(0, 16)).find("has no JSON chunk"), std::string::npos);
    EXPECT_NE(errorOf("bad.glb", whole.substr(0, 40)).find("is cut off: a chunk of"),
              std::string::npos);
    EXPECT_NE(errorOf("bad.glb", whole.substr(0, whole.size() - 1)).find("is cut off"),
              std::string::npos);
    // Every truncated file is an error.
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_NE(errorOf("bad.glb", whole.substr(0, size)), "nothing") << size;
}

}  // namespace
}  // namespace demos::test
