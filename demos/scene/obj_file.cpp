// Wavefront OBJ. tinyobjloader cuts faces into triangles. It reads a word as 0 and accepts any
// number as an index, so it gets checked lines only. Coordinates are parsed here: no bit depends on
// its arithmetic.
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>

#define TINYOBJLOADER_USE_DOUBLE  // as libtinyobjloader_double is built; its .pc does not say so
#include <tiny_obj_loader.h>

#include "demos/scene/mesh_file.h"

namespace demos {
namespace {

constexpr std::size_t kMostSides = 256;  // of a face: the work grows with their cube

class ObjLines {
public:
    explicit ObjLines(std::string_view text) {
        if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
        std::string joined;  // of lines that end in a backslash
        for (int lines = 1; !text.empty(); ++lines) {
            const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
            const std::string_view line = text.substr(0, end);
            text.remove_prefix(end + (text.substr(end, 2) == "\r\n" ? 2 : end < text.size()));
            if (joined.empty()) number_ = lines;
            const bool comment = joined.empty() && line.starts_with('#');
            if (line.ends_with('\\') && !comment) {
                (joined += line).back() = ' ';
                continue;
            }
            take(joined.empty() ? line : joined += line);
            joined.clear();
        }
        take(joined);
        for (const Face& face : faces_) write(face);
    }

    const std::vector<engine::Vec3>& corners() const { return corners_; }
    /// Only the lines "v x y z" and "f 1 2 3".
    const std::string& text() const { return text_; }
    std::size_t triangles() const { return triangles_; }

private:
    struct Face {
        int line;
        std::vector<int> corners;
    };

    [[noreturn]] static void fail(int line, const std::string& what) {
        throw MeshFileError("line " + std::to_string(line) + ": " + what);
    }

    void take(std::string_view line) {
        std::vector<std::string_view> words;  // no more than the longest face has
        for (std::size_t at = line.find_first_not_of(" \t");
             at < line.size() && words.size() < kMostSides + 2;) {
            const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
            words.push_back(line.substr(at, end - at));
            at = line.find_first_not_of(" \t", end);
        }
        if (words.empty()) return;
        if (words[0] == "v") takeCorner(words);
        if (words[0] == "f") takeFace(words);
    }

    double coordinate(std::string_view word) const {
        const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
        double value = 0.0;
        const char* end = digits.data() + digits.size();
        const auto read = std::from_chars(digits.data(), end, value);
        if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value))
            fail(number_, "'" + shown(word) + "' should be a finite number");
        return value;
    }

    void takeCorner(const std::vector<std::string_view>& words) {
        if (words.size() < 4)
            fail(number_,
                 std::to_string(words.size() - 1) + " coordinates; a corner should have three");
        engine::Vec3 corner;
        text_ += "v";
        for (int k = 0; k < 3; ++k) {
            const std::string_view word = words[static_cast<std::size_t>(k) + 1];
            corner[k] = coordinate(word);
            (text_ += ' ') += word;
        }
        text_ += '\n';
        corners_.push_back(corner);
        if (corners_.size() > kMostMeshCorners) fail(number_, "more than three million corners");
    }

    /// "7", "7/1", "7//3", "-1": a corner's number from 1, or back from the last one so far.
    int reference(std::string_view word) const {
        int number = 0;
        const char* end = word.data() + word.size();
        const auto read = std::from_chars(word.data(), end, number);
        if (read.ec != std::errc() || (read.ptr != end && *read.ptr != '/') || number == 0)
            fail(number_, "'" + shown(word) +
                              "' should be a corner's number: from 1, or backwards from -1");
        const int known = static_cast<int>(corners_.size());
        if (number < -known)
            fail(number_, "corner " + std::to_string(number) + "; there are " +
                              std::to_string(known) + " corners before it");
        return number > 0 ? number : known + 1 + number;
    }

    void takeFace(const std::vector<std::string_view>& words) {
        const std::size_t sides = words.size() - 1;
        if (sides < 3 || sides > kMostSides)
            fail(number_, "a face of " +
                              (sides < 3 ? std::to_string(sides)
                                         : "more than " + std::to_string(kMostSides)) +
                              " corners; it should have 3 to " + std::to_string(kMostSides));
        Face face{number_, {}};
        for (std::size_t i = 1; i < words.size(); ++i) face.corners.push_back(reference(words[i]));
        faces_.push_back(std::move(face));
        triangles_ += sides - 2;
        if (triangles_ > kMostTriangles) fail(number_, "more than a million triangles");
    }

    void write(const Face& face) {
        text_ += 'f';
        for (const int corner : face.corners) {
            if (corner > static_cast<int>(corners_.size()))
                fail(face.line, "corner " + std::to_string(corner) +
                                    "; the file has corners 1 to " +
                                    std::to_string(corners_.size()));
            (text_ += ' ') += std::to_string(corner);
        }
        text_ += '\n';
    }

    int number_ = 0;
    std::vector<engine::Vec3> corners_;
    std::vector<Face> faces_;
    std::size_t triangles_ = 0;
    std::string text_;
};

}  // namespace

TriangleMesh objMesh(const std::string& text) {
    const ObjLines lines(text);
    std::istringstream stream(lines.text());
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    // Without a material reader it does not open other files.
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, nullptr,
                          true))
        throw MeshFileError("is not an OBJ file: " + error);
    TriangleMesh mesh{lines.corners(), {}};
    for (const tinyobj::shape_t& shape : shapes)
        for (std::size_t i = 0; i + 2 < shape.mesh.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) {
                return shape.mesh.indices[i + k].vertex_index;
            };
            mesh.triangles.push_back({corner(0), corner(1), corner(2)});
        }
    if (mesh.triangles.size() != lines.triangles())
        throw MeshFileError(
            "not all of its faces can be cut into triangles; they should be flat and "
            "not cross themselves");
    return mesh;
}

}  // namespace demos
