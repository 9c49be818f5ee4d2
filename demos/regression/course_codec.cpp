#include "demos/regression/course_codec.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "demos/packed.h"
#include "demos/regression/byte_stream.h"

namespace demos {
namespace {

constexpr std::int64_t kCourseVersion = 1;
constexpr std::size_t kMostSteps = 100'000'000, kMostNames = 1'000'000, kMostName = 200;
constexpr std::size_t kMostBytes = 256u << 20;  // unpacked
constexpr double kFarthest = 4e15;              // resolutions: an exact double
constexpr double kExtentStep = 1e-4;            // m
constexpr double kDepthStep = 1e-7;             // m, of penetration and separation

/// One number over all moments, as a value of the course or into it.
using Column = std::function<double&(CourseMoment&)>;

/// Where what was told so far leads: to the last number, or along the last two.
class Guess {
public:
    explicit Guess(bool straight) : straight_(straight) {}
    std::int64_t next() const { return straight_ ? 2 * last_ - before_ : last_; }
    void see(std::int64_t value) {
        before_ = seen_ ? last_ : value;  // nothing is known of the speed at first
        last_ = value;
        seen_ = true;
    }

private:
    bool straight_;
    std::int64_t last_ = 0, before_ = 0;
    bool seen_ = false;
};

/// How far each number is from the guess; one that is within a step of it is told as 0, and then
/// taken to be it, so that what trembles about a boundary costs nothing.
std::vector<std::int64_t> restsOf(Course& course, double step, const Column& column,
                                  bool straight) {
    Guess guess(straight);
    std::vector<std::int64_t> rests;
    for (CourseMoment& moment : course.moments) {
        const double number = std::clamp(column(moment) / step, -kFarthest, kFarthest);
        const auto far = number - static_cast<double>(guess.next());
        rests.push_back(std::abs(far) <= 1.0 ? 0 : std::llround(far));
        guess.see(guess.next() + rests.back());
    }
    return rests;
}

void writeColumn(ByteWriter& out, Course& course, double step, const Column& column) {
    const auto cost = [](const std::vector<std::int64_t>& rests) {
        double bits = 0.0;
        for (const std::int64_t rest : rests) bits += std::log2(1.0 + std::abs(static_cast<double>(rest)));
        return bits;
    };
    const std::vector<std::int64_t> still = restsOf(course, step, column, false);
    const std::vector<std::int64_t> straight = restsOf(course, step, column, true);
    const bool better = cost(straight) < cost(still);
    out.whole(better ? 1 : 0);
    for (const std::int64_t rest : better ? straight : still) out.whole(rest);
}

bool readColumn(ByteReader& in, Course& course, double step, const Column& column) {
    Guess guess(in.count(1) == 1);
    for (CourseMoment& moment : course.moments) {
        const std::int64_t rest = in.whole();
        if (std::abs(static_cast<double>(rest)) > 4 * kFarthest) return false;
        const std::int64_t value = guess.next() + rest;
        if (std::abs(static_cast<double>(value)) > 2 * kFarthest) return false;
        guess.see(value);
        column(moment) = static_cast<double>(value) * step;
    }
    return in.good();
}

/// Calls `visit(resolution, column)` for everything but impulses, in the order of the bytes.
template <class Visit>
void visitColumns(std::size_t bodies, const CourseResolution& resolution, const Visit& visit) {
    visit(resolution.energy, [](CourseMoment& m) -> double& { return m.energy; });
    visit(kDepthStep, [](CourseMoment& m) -> double& { return m.penetration; });
    visit(kDepthStep, [](CourseMoment& m) -> double& { return m.separation; });
    for (std::size_t body = 0; body < bodies; ++body) {
        for (int i = 0; i < 3; ++i)
            visit(resolution.position,
                  [=](CourseMoment& m) -> double& { return m.poses[body].position[i]; });
        for (int i = 0; i < 4; ++i)
            visit(resolution.rotation, [=](CourseMoment& m) -> double& {
                return m.poses[body].rotation.coeffs()[i];
            });
    }
}

/// A constraint that acts does so for a while: where it begins, how long, and by how much.
struct Run {
    std::size_t first = 0;
    std::vector<double> values;
};

std::vector<std::vector<Run>> runsOf(const Course& course) {
    std::vector<std::vector<Run>> runs(course.constraints.size());
    for (std::size_t moment = 0; moment < course.moments.size(); ++moment)
        for (const CourseImpulse& impulse : course.moments[moment].impulses) {
            std::vector<Run>& own = runs[impulse.constraint];
            if (own.empty() || own.back().first + own.back().values.size() != moment)
                own.push_back({moment, {}});
            own.back().values.push_back(impulse.value);
        }
    return runs;
}

void writeImpulses(ByteWriter& out, const Course& course, double step) {
    for (const std::vector<Run>& runs : runsOf(course)) {
        out.whole(static_cast<std::int64_t>(runs.size()));
        for (const Run& run : runs) {
            out.whole(static_cast<std::int64_t>(run.first));
            out.whole(static_cast<std::int64_t>(run.values.size()));
            std::int64_t last = 0;
            for (const double impulse : run.values) {
                const std::int64_t value = std::llround(std::min(impulse / step, kFarthest));
                out.whole(value - last);
                last = value;
            }
        }
    }
}

void readImpulses(ByteReader& in, Course& course, double step) {
    for (std::size_t constraint = 0; constraint < course.constraints.size(); ++constraint)
        for (std::size_t runs = in.count(in.left()); runs > 0 && in.good(); --runs) {
            const std::size_t first = in.count(course.moments.size());
            const std::size_t size = in.count(course.moments.size() - first);
            double value = 0.0;
            for (std::size_t i = 0; i < size && in.good(); ++i) {
                value += static_cast<double>(in.whole());
                course.moments[first + i].impulses.push_back(
                    {static_cast<int>(constraint), value * step});
            }
        }
}

void writeNames(ByteWriter& out, const std::vector<std::string>& names) {
    out.whole(static_cast<std::int64_t>(names.size()));
    for (const std::string& name : names) out.text(name);
}

std::vector<std::string> readNames(ByteReader& in) {
    std::vector<std::string> names(in.count(std::min(kMostNames, in.left())));
    for (std::string& name : names) name = in.text(kMostName);
    return names;
}

/// A rotation goes on with the sign it had, so that its numbers do not jump.
void keepSigns(Course& course) {
    for (std::size_t k = 1; k < course.moments.size(); ++k)
        for (std::size_t body = 0; body < course.bodies.size(); ++body) {
            const Quat& before = course.moments[k - 1].poses[body].rotation;
            Quat& rotation = course.moments[k].poses[body].rotation;
            if (rotation.dot(before) < 0.0) rotation.coeffs() *= -1.0;
        }
}

std::vector<std::uint8_t> bytesOf(Course course, const CourseResolution& resolution) {
    keepSigns(course);
    ByteWriter out;
    for (const std::int64_t value :
         {kCourseVersion, std::int64_t{course.hz}, std::int64_t{course.dense},
          static_cast<std::int64_t>(course.hashes.size())})
        out.whole(value);
    writeNames(out, course.bodies);
    writeNames(out, course.constraints);
    for (const Vec3& extent : course.extents)
        for (int i = 0; i < 3; ++i) out.whole(std::llround(extent[i] / kExtentStep));
    for (const std::uint32_t hash : course.hashes) out.bits32(hash);
    for (const double step : {resolution.position, resolution.rotation, resolution.impulse,
                              resolution.energy})
        out.number(step);
    visitColumns(course.bodies.size(), resolution,
                 [&](double step, const Column& column) { writeColumn(out, course, step, column); });
    writeImpulses(out, course, resolution.impulse);
    return packed(out.bytes());
}

/// How many moments a course of this length has.
std::size_t momentCount(const Course& course) {
    std::size_t count = 1;
    for (int step = 0; step < course.lastStep(); ++step)
        if (hasMoment(step, course.dense)) ++count;
    return count;
}

void makeMoments(Course& course) {
    const std::vector<engine::Pose> poses(course.bodies.size());
    for (int step = 0; step <= course.lastStep(); ++step)
        if (hasMoment(step, course.dense) || step == course.lastStep())
            course.moments.push_back({step, poses, 0, 0, 0, {}});
}

/// Each of their numbers takes a byte at least: what is asked for is in proportion to what came.
bool momentsFit(const Course& course, std::size_t bytes) {
    return momentCount(course) * (3 + 7 * course.bodies.size()) <= bytes;
}

bool readHead(ByteReader& in, Course& course) {
    if (in.count(kCourseVersion) != kCourseVersion) return false;
    course.hz = static_cast<int>(in.count(100'000));
    course.dense = static_cast<int>(in.count(Course::kAll));
    course.hashes.resize(in.count(std::min(kMostSteps, in.left())));
    course.bodies = readNames(in);
    course.constraints = readNames(in);
    course.extents.resize(course.bodies.size());
    for (Vec3& extent : course.extents)
        for (int i = 0; i < 3; ++i) extent[i] = static_cast<double>(in.whole()) * kExtentStep;
    for (std::uint32_t& hash : course.hashes) hash = in.bits32();
    for (double* step : {&course.resolution.position, &course.resolution.rotation,
                         &course.resolution.impulse, &course.resolution.energy})
        *step = in.number();
    return in.good() && course.hz > 0 && course.dense > 0 && !course.hashes.empty();
}

}  // namespace

CourseResolution resolutionOf(const Course& course, const Tolerance& tolerance) {
    constexpr double kFiner = 0.1, kShare = 1e-4, kRadians = 0.017453292519943295;
    double impulse = 0.0, energy = 0.0;
    for (const CourseMoment& moment : course.moments) {
        energy = std::max(energy, std::abs(moment.energy));
        for (const CourseImpulse& one : moment.impulses) impulse = std::max(impulse, one.value);
    }
    // A turn by an angle changes the four numbers by half of it.
    return {kFiner * tolerance.position, kFiner * tolerance.angleDegrees * kRadians / 2,
            impulse > 0.0 ? kShare * impulse : kShare, energy > 0.0 ? kShare * energy : kShare};
}

bool hasMoment(int step, int dense) {
    int stride = 1;
    for (long long until = dense; step > until; until *= 2) stride *= 2;
    return step % stride == 0;
}

Course thinned(const Course& course, int dense) {
    Course out = course;
    out.dense = dense;
    out.moments.clear();
    for (const CourseMoment& moment : course.moments)
        if (hasMoment(moment.step, dense) || moment.step == course.lastStep())
            out.moments.push_back(moment);
    return out;
}

std::vector<std::uint8_t> encodeCourse(const Course& course, const CourseResolution& resolution,
                                       std::size_t most) {
    std::vector<std::uint8_t> bytes = bytesOf(course, resolution);
    for (int dense = std::min(course.lastStep(), course.dense) / 2; bytes.size() > most && dense > 0;
         dense = dense * 3 / 4)
        bytes = bytesOf(thinned(course, dense), resolution);
    return bytes;
}

std::optional<Course> decodeCourse(std::span<const std::uint8_t> bytes) {
    const std::optional<std::vector<std::uint8_t>> plain = unpacked(bytes, kMostBytes);
    if (!plain) return std::nullopt;
    ByteReader in(*plain);
    Course course;
    if (!readHead(in, course) || !momentsFit(course, in.left())) return std::nullopt;
    makeMoments(course);
    bool good = true;
    visitColumns(course.bodies.size(), course.resolution, [&](double step, const Column& column) {
        good = good && readColumn(in, course, step, column);
    });
    if (!good) return std::nullopt;
    readImpulses(in, course, course.resolution.impulse);
    if (!in.good() || !in.atEnd()) return std::nullopt;
    for (CourseMoment& moment : course.moments)
        for (engine::Pose& pose : moment.poses) {
            if (!(pose.rotation.norm() > 0.5)) return std::nullopt;
            pose.rotation.normalize();
        }
    return course;
}

}  // namespace demos
