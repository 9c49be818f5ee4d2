/// Verdicts with pictures and runs of known contents, for tests of the report.
#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "demos/regression/report_page.h"
#include "render/encode/png.h"

namespace support {

inline render::Image flatImage(int width, int height, std::uint8_t level) {
    render::Image image{width, height, {}};
    image.pixels.assign(std::size_t{4} * width * height, level);
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 255;
    return image;
}

inline void paintSquare(render::Image& image, int left, int top, int side, std::uint8_t level) {
    for (int y = top; y < top + side; ++y)
        for (int x = left; x < left + side; ++x) std::fill_n(image.at(x, y), 3, level);
}

/// The file's name.
inline std::string saved(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    return file.string();
}

inline std::string saved(const std::filesystem::path& file, const render::Image& image) {
    const auto bytes = render::encodePng(image);
    return saved(file, std::string(bytes.begin(), bytes.end()));
}

inline demos::PictureVerdict plantedPicture(double time, demos::PictureVerdict::Kind kind,
                                            const std::string& baseline,
                                            const std::string& actual) {
    demos::PictureVerdict picture;
    picture.time = time;
    picture.kind = kind;
    picture.baseline = baseline;
    picture.actual = actual;
    return picture;
}

inline demos::SceneVerdict plantedScene(const std::string& name, demos::SceneVerdict::State state) {
    demos::SceneVerdict scene;
    scene.name = scene.scene = scene.title = name;
    scene.state = state;
    scene.physics.kind = demos::PhysicsVerdict::Kind::same;
    return scene;
}

/// Bodies "body0", "body1", ... in a row along x: each falls its number times `fall` metres per
/// second, so that body0 does not move.
inline demos::Trajectory fallingBodies(int bodies, int moments, double fall) {
    demos::Trajectory trajectory;
    for (int i = 0; i < bodies; ++i) {
        trajectory.bodies.push_back("body" + std::to_string(i));
        trajectory.extents.push_back(demos::Vec3(0.5, 0.25, 0.125));
    }
    for (int step = 0; step < moments; ++step) {
        demos::TrajectoryMoment moment;
        moment.step = step;
        moment.energy = 100.0 - step;
        for (int i = 0; i < bodies; ++i) {
            engine::Pose pose;
            pose.position = demos::Vec3(i, 2.0 - fall * i * step / trajectory.hz, 0.0);
            moment.poses.push_back(pose);
        }
        trajectory.moments.push_back(moment);
    }
    return trajectory;
}

}  // namespace support
