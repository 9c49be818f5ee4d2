// Pixel centre (u, v), lens f, c; in eye axes its ray is  e = ((u - c_x)/f_x, (c_y - v)/f_y, -1),
// so that t of eye + t R^T e is the depth.  R, p: the view's rotation and translation.
// A point X of a body that moves from pose (x, Q) to (x', Q') goes to  X' = x' + Q' S Q^T (X - x),
// with S = 1 except for rods, which stretch.   flow = project'(X') - (u, v)
#include "render/data_images.h"

#include <Eigen/LU>

#include "render/ray_surface.h"
#include "render/shortest_turn.h"

namespace render {
namespace {

/// The camera in double precision, from the same matrices that the picture is drawn with.
struct Eye {
    Lens lens;
    Mat3d rotation, back;  // world to eye, eye to world
    Vec3d translation, position;

    Eye(const Camera& camera, int width, int height) {
        const View view =
            makeView(camera, static_cast<float>(width) / static_cast<float>(height));
        lens = lensOf(view, width, height);
        rotation = view.view.block<3, 3>(0, 0).cast<double>();
        back = rotation.inverse();
        translation = view.view.block<3, 1>(0, 3).cast<double>();
        position = -(back * translation);
    }

    Ray through(const Eigen::Vector2d& pixel) const {
        const Vec3d way((pixel.x() - lens.centreX) / lens.focalX,
                        (lens.centreY - pixel.y()) / lens.focalY, -1.0);
        return {position, back * way};
    }

    /// From eye axes. The point must not be behind the eye.
    Eigen::Vector2d project(const Vec3d& p) const {
        return {lens.centreX - lens.focalX * p.x() / p.z(),
                lens.centreY + lens.focalY * p.y() / p.z()};
    }
};

/// How the points of a surface move until the next frame.
struct Motion {
    bool known = false, still = false;
    Mat3d turn = Mat3d::Identity();
    Vec3d shift{0, 0, 0};
};

Motion motionBetween(const Surface& now, const Surface& next) {
    Motion motion;
    motion.known = true;
    motion.still = now == next;
    Mat3d axes = next.axes;
    Vec3d stretch(1, 1, 1);
    if (now.kind == SurfaceKind::bar || now.kind == SurfaceKind::plane)  // their spin is not visible
        axes = shortestTurn<double>(now.axes.col(1), next.axes.col(1)).toRotationMatrix() * now.axes;
    if (now.kind == SurfaceKind::bar && now.half.y() > 0.0)
        stretch.y() = next.half.y() / now.half.y();
    motion.turn = axes * stretch.asDiagonal() * now.axes.transpose();
    motion.shift = next.at - motion.turn * now.at;
    return motion;
}

std::vector<Motion> motionsOf(const std::vector<Surface>& now, const std::vector<Surface>& next) {
    std::vector<Motion> motions(now.size());
    for (std::size_t i = 0; i < now.size() && i < next.size(); ++i)
        if (now[i].id == next[i].id && now[i].kind == next[i].kind)
            motions[i] = motionBetween(now[i], next[i]);
    return motions;
}

bool sameView(const Camera& a, const Camera& b) {
    return a.from == b.from && a.lookAt == b.lookAt && a.up == b.up &&
           a.fovDegrees == b.fovDegrees;
}

/// One frame's geometry, for lookups pixel by pixel.
class SeenFrame {
public:
    SeenFrame(const Frame& now, const Frame* next, const SurfaceMap& map, const DataPasses& wanted)
        : map_(map), wanted_(wanted), eye_(now.camera, map.width, map.height), later_(eye_),
          surfaces_(surfacesOf(now)), motions_(surfaces_.size()) {
        images_.width = map.width, images_.height = map.height;
        known_ = next != nullptr;
        if (!next) return;
        later_ = Eye(next->camera, map.width, map.height);
        cameraStill_ = sameView(now.camera, next->camera);
        motions_ = motionsOf(surfaces_, surfacesOf(*next));
    }

    DataImages images() {
        for (int y = 0; y < map_.height; ++y)
            for (int x = 0; x < map_.width; ++x) add(x, y);
        return std::move(images_);
    }

private:
    void add(int x, int y) {
        const int surface = map_.surface(x, y);
        const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
        const Ray ray = eye_.through(pixel);
        const bool sky = surface == kNoSurface;
        const bool asked = wanted_.depth || wanted_.normal || wanted_.flow;
        const Hit hit = sky || !asked ? Hit{} : enter(surfaces_[surface], map_.face(x, y), ray);
        if (wanted_.depth) images_.depth.push_back(sky ? kNoDepth : static_cast<float>(hit.t));
        if (wanted_.normal)
            images_.normal.push_back(sky ? Vec3(Vec3::Zero()) : Vec3(hit.normal.cast<float>()));
        if (wanted_.id)
            images_.id.push_back(
                static_cast<std::uint16_t>(sky ? 0 : surfaces_[surface].id + 1));
        if (!wanted_.flow) return;
        images_.flow.push_back(sky ? flowOfSky(ray, pixel) : flowOf(surface, ray, hit, pixel));
    }

    Eigen::Vector2f flowTo(const Vec3d& inLaterEye, const Eigen::Vector2d& pixel) const {
        if (!(inLaterEye.z() < 0.0)) return {kNoFlow, kNoFlow};
        return (later_.project(inLaterEye) - pixel).cast<float>();
    }

    Eigen::Vector2f flowOfSky(const Ray& ray, const Eigen::Vector2d& pixel) const {
        if (!known_) return {kNoFlow, kNoFlow};
        if (cameraStill_) return {0, 0};
        return flowTo(later_.rotation * ray.along, pixel);
    }

    Eigen::Vector2f flowOf(int surface, const Ray& ray, const Hit& hit,
                           const Eigen::Vector2d& pixel) const {
        const Motion& motion = motions_[surface];
        if (!motion.known) return {kNoFlow, kNoFlow};
        if (motion.still && cameraStill_) return {0, 0};  // exactly, without rounding errors
        const Vec3d point = ray.from + hit.t * ray.along;
        const Vec3d moved = motion.still ? point : Vec3d(motion.turn * point + motion.shift);
        return flowTo(later_.rotation * moved + later_.translation, pixel);
    }

    const SurfaceMap& map_;
    const DataPasses wanted_;
    Eye eye_, later_;
    bool known_ = false, cameraStill_ = false;
    std::vector<Surface> surfaces_;
    std::vector<Motion> motions_;
    DataImages images_;
};

}  // namespace

DataImages dataImages(const Frame& now, const Frame* next, const SurfaceMap& map,
                      const DataPasses& wanted) {
    return SeenFrame(now, next, map, wanted).images();
}

Lens lensOf(const View& view, int width, int height) {
    return {0.5 * width * static_cast<double>(view.projection(0, 0)),
            0.5 * height * static_cast<double>(view.projection(1, 1)), 0.5 * width, 0.5 * height};
}

}  // namespace render
