#include "demos/regression/trajectory_codec.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "demos/text/byte_stream.h"
#include "demos/text/deflate.h"

namespace demos {
namespace {

constexpr std::int64_t kTrajectoryVersion = 2;
constexpr std::size_t kMostSteps = 100'000'000, kMostNames = 1'000'000, kMostName = 200;
constexpr std::size_t kMostBytes = 256u << 20;  // unpacked
// A recorded trajectory has 200000 poses until it is thinned, and 100000 more whenever its length
// doubles.
constexpr std::size_t kMostReadPoses = 4'000'000, kMostReadImpulses = 16'000'000;
constexpr double kFarthest = 4e15;              // resolutions: an exact double
constexpr double kExtentStep = 1e-4;            // m
constexpr double kDepthStep = 1e-7;             // m, of penetration and separation

/// Access to one number of every moment, for reading and writing.
using Column = std::function<double&(TrajectoryMoment&)>;

/// Predicts the next number: equal to the last one, or on the line through the last two.
class Guess {
public:
    explicit Guess(bool straight) : straight_(straight) {}
    std::int64_t next() const { return straight_ ? 2 * last_ - before_ : last_; }
    void see(std::int64_t value) {
        before_ = seen_ ? last_ : value;  // the speed is not known at first
        last_ = value;
        seen_ = true;
    }

private:
    bool straight_;
    std::int64_t last_ = 0, before_ = 0;
    bool seen_ = false;
};

/// The difference of each number from its guess. One within a step of the guess becomes 0, and the
/// guess is then used as its value, so that a number that jitters about a boundary costs nothing.
std::vector<std::int64_t> restsOf(Trajectory& trajectory, double step, const Column& column,
                                  bool straight) {
    Guess guess(straight);
    std::vector<std::int64_t> rests;
    for (TrajectoryMoment& moment : trajectory.moments) {
        const double exact = column(moment) / step;
        const double number = std::isnan(exact) ? 0.0 : std::clamp(exact, -kFarthest, kFarthest);
        const auto far = number - static_cast<double>(guess.next());
        rests.push_back(std::abs(far) <= 1.0 ? 0 : std::llround(far));
        guess.see(guess.next() + rests.back());
    }
    return rests;
}

void writeColumn(ByteWriter& out, Trajectory& trajectory, double step, const Column& column) {
    const auto cost = [](const std::vector<std::int64_t>& rests) {
        double bits = 0.0;
        for (const std::int64_t rest : rests)
            bits += std::log2(1.0 + std::abs(static_cast<double>(rest)));
        return bits;
    };
    const std::vector<std::int64_t> still = restsOf(trajectory, step, column, false);
    const std::vector<std::int64_t> straight = restsOf(trajectory, step, column, true);
    const bool better = cost(straight) < cost(still);
    out.whole(better ? 1 : 0);
    for (const std::int64_t rest : better ? straight : still) out.whole(rest);
}

bool readColumn(ByteReader& in, Trajectory& trajectory, double step, const Column& column) {
    Guess guess(in.count(1) == 1);
    for (TrajectoryMoment& moment : trajectory.moments) {
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
void visitColumns(std::size_t bodies, const TrajectoryResolution& resolution, const Visit& visit) {
    visit(resolution.energy, [](TrajectoryMoment& m) -> double& { return m.energy; });
    visit(kDepthStep, [](TrajectoryMoment& m) -> double& { return m.penetration; });
    visit(kDepthStep, [](TrajectoryMoment& m) -> double& { return m.separation; });
    for (std::size_t body = 0; body < bodies; ++body) {
        for (int i = 0; i < 3; ++i)
            visit(resolution.position,
                  [=](TrajectoryMoment& m) -> double& { return m.poses[body].position[i]; });
        for (int i = 0; i < 4; ++i)
            visit(resolution.rotation, [=](TrajectoryMoment& m) -> double& {
                return m.poses[body].rotation.coeffs()[i];
            });
    }
}

/// A constraint usually acts over several moments in sequence: the first one, and its values.
struct Run {
    std::size_t first = 0;
    std::vector<double> values;
};

std::vector<std::vector<Run>> runsOf(const Trajectory& trajectory) {
    std::vector<std::vector<Run>> runs(trajectory.constraints.size());
    for (std::size_t moment = 0; moment < trajectory.moments.size(); ++moment)
        for (const TrajectoryImpulse& impulse : trajectory.moments[moment].impulses) {
            std::vector<Run>& own = runs[impulse.constraint];
            if (own.empty() || own.back().first + own.back().values.size() != moment)
                own.push_back({moment, {}});
            own.back().values.push_back(impulse.value);
        }
    return runs;
}

void writeImpulses(ByteWriter& out, const Trajectory& trajectory, double step) {
    for (const std::vector<Run>& runs : runsOf(trajectory)) {
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

bool readImpulses(ByteReader& in, Trajectory& trajectory, double step) {
    std::size_t left = kMostReadImpulses;
    for (std::size_t constraint = 0; constraint < trajectory.constraints.size(); ++constraint)
        for (std::size_t runs = in.count(in.left()); runs > 0 && in.good(); --runs) {
            const std::size_t first = in.count(trajectory.moments.size());
            const std::size_t size = in.count(trajectory.moments.size() - first);
            if (size > left) return false;
            left -= size;
            double value = 0.0;
            for (std::size_t i = 0; i < size && in.good(); ++i) {
                value += static_cast<double>(in.whole());
                trajectory.moments[first + i].impulses.push_back(
                    {static_cast<int>(constraint), value * step});
            }
        }
    return in.good();
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

/// A trajectory without masses has zeros, which are not compared.
void writeMasses(ByteWriter& out, const Trajectory& trajectory) {
    for (std::size_t i = 0; i < trajectory.bodies.size(); ++i)
        out.number(i < trajectory.masses.size() ? trajectory.masses[i] : 0.0);
    out.number(trajectory.gravity);
    for (std::size_t i = 0; i < trajectory.constraints.size(); ++i)
        for (int side = 0; side < 2; ++side)
            out.whole(i < trajectory.ends.size() ? trajectory.ends[i][side] + 1 : 0);
}

bool readMasses(ByteReader& in, Trajectory& trajectory) {
    trajectory.masses.resize(trajectory.bodies.size());
    for (double& mass : trajectory.masses) mass = in.number();
    trajectory.gravity = in.number();
    trajectory.ends.resize(trajectory.constraints.size());
    for (std::array<int, 2>& ends : trajectory.ends)
        for (int& body : ends) body = static_cast<int>(in.count(trajectory.bodies.size())) - 1;
    return in.good();
}

/// Each rotation keeps the sign of the one before, so that its numbers do not jump.
void keepSigns(Trajectory& trajectory) {
    for (std::size_t k = 1; k < trajectory.moments.size(); ++k)
        for (std::size_t body = 0; body < trajectory.bodies.size(); ++body) {
            const Quat& before = trajectory.moments[k - 1].poses[body].rotation;
            Quat& rotation = trajectory.moments[k].poses[body].rotation;
            if (rotation.dot(before) < 0.0) rotation.coeffs() *= -1.0;
        }
}

std::vector<std::uint8_t> bytesOf(Trajectory trajectory, const TrajectoryResolution& resolution) {
    keepSigns(trajectory);
    ByteWriter out;
    for (const std::int64_t value :
         {kTrajectoryVersion, std::int64_t{trajectory.hz}, std::int64_t{trajectory.dense},
          static_cast<std::int64_t>(trajectory.hashes.size())})
        out.whole(value);
    writeNames(out, trajectory.bodies);
    writeNames(out, trajectory.constraints);
    for (const Vec3& extent : trajectory.extents)
        for (int i = 0; i < 3; ++i) out.whole(std::llround(extent[i] / kExtentStep));
    writeMasses(out, trajectory);
    for (const std::uint32_t hash : trajectory.hashes) out.bits32(hash);
    for (const double step :
         {resolution.position, resolution.rotation, resolution.impulse, resolution.energy})
        out.number(step);
    visitColumns(trajectory.bodies.size(), resolution, [&](double step, const Column& column) {
        writeColumn(out, trajectory, step, column);
    });
    writeImpulses(out, trajectory, resolution.impulse);
    return deflated(out.bytes());
}

/// Around this step every so many steps have a moment.
int strideAt(int step, int dense) {
    int stride = 1;
    for (long long until = dense; step > until; until *= 2) stride *= 2;
    return stride;
}

/// The next step that has a moment, if the run does not end before it.
int nextMoment(int step, int dense) {
    const int stride = strideAt(step + 1, dense);
    return (step / stride + 1) * stride;
}

/// Calls `visit` with each step that has a moment, until it returns false.
template <class Visit>
void visitSteps(const Trajectory& trajectory, const Visit& visit) {
    const int last = trajectory.lastStep();
    for (int step = 0; step < last; step = std::min(nextMoment(step, trajectory.dense), last))
        if (!visit(step)) return;
    visit(last);
}

/// Each number takes a byte at least, so memory is allocated only in proportion to the input.
bool momentsFit(const Trajectory& trajectory, std::size_t bytes) {
    const std::size_t bodies = trajectory.bodies.size();
    const std::size_t most = std::min(bytes / (3 + 7 * bodies), kMostReadPoses / (1 + bodies));
    std::size_t count = 0;
    visitSteps(trajectory, [&](int) { return ++count <= most; });
    return count <= most;
}

void makeMoments(Trajectory& trajectory) {
    const std::vector<engine::Pose> poses(trajectory.bodies.size());
    visitSteps(trajectory, [&](int step) {
        trajectory.moments.push_back({step, poses, 0, 0, 0, {}});
        return true;
    });
}

bool readHead(ByteReader& in, Trajectory& trajectory) {
    const std::size_t version = in.count(kTrajectoryVersion);
    if (version == 0) return false;
    trajectory.hz = static_cast<int>(in.count(100'000));
    trajectory.dense = static_cast<int>(in.count(Trajectory::kAll));
    trajectory.hashes.resize(in.count(std::min(kMostSteps, in.left() / 4)));
    trajectory.bodies = readNames(in);
    trajectory.constraints = readNames(in);
    trajectory.extents.resize(trajectory.bodies.size());
    for (Vec3& extent : trajectory.extents)
        for (int i = 0; i < 3; ++i) extent[i] = static_cast<double>(in.whole()) * kExtentStep;
    if (version > 1 && !readMasses(in, trajectory)) return false;
    for (std::uint32_t& hash : trajectory.hashes) hash = in.bits32();
    for (double* step : {&trajectory.resolution.position, &trajectory.resolution.rotation,
                         &trajectory.resolution.impulse, &trajectory.resolution.energy})
        *step = in.number();
    return in.good() && trajectory.hz > 0 && trajectory.dense > 0 && !trajectory.hashes.empty();
}

}  // namespace

TrajectoryResolution resolutionOf(const Trajectory& trajectory, const Tolerance& tolerance) {
    constexpr double kFiner = 0.1, kShare = 1e-4, kRadians = 0.017453292519943295;
    constexpr double kMost = 1e300;  // the start of a body that is slowed down may overflow
    double impulse = 0.0, energy = 0.0;
    for (const TrajectoryMoment& moment : trajectory.moments) {
        energy = std::max(energy, std::min(std::abs(moment.energy), kMost));
        for (const TrajectoryImpulse& one : moment.impulses)
            impulse = std::max(impulse, std::min(one.value, kMost));
    }
    // A turn by an angle changes the quaternion's numbers by up to half of it.
    return {kFiner * tolerance.position, kFiner * tolerance.angleDegrees * kRadians / 2,
            impulse > 0.0 ? kShare * impulse : kShare, energy > 0.0 ? kShare * energy : kShare};
}

bool hasMoment(int step, int dense) {
    return step % strideAt(step, dense) == 0;
}

Trajectory thinned(const Trajectory& trajectory, int dense) {
    Trajectory out = trajectory;
    out.dense = dense;
    out.moments.clear();
    std::map<int, double> sums;  // since the moment before
    for (const TrajectoryMoment& moment : trajectory.moments) {
        for (const TrajectoryImpulse& impulse : moment.impulses)
            sums[impulse.constraint] += impulse.value;
        if (!hasMoment(moment.step, dense) && moment.step != trajectory.lastStep()) continue;
        TrajectoryMoment& kept = out.moments.emplace_back(moment);
        kept.impulses.clear();
        for (const auto& [constraint, value] : sums) kept.impulses.push_back({constraint, value});
        sums.clear();
    }
    return out;
}

std::vector<std::uint8_t> encodeTrajectory(const Trajectory& trajectory,
                                           const TrajectoryResolution& resolution,
                                           std::size_t most) {
    std::vector<std::uint8_t> bytes = bytesOf(trajectory, resolution);
    for (int dense = std::min(trajectory.lastStep(), trajectory.dense) / 2;
         bytes.size() > most && dense > 0; dense = dense * 3 / 4)
        bytes = bytesOf(thinned(trajectory, dense), resolution);
    return bytes;
}

std::optional<Trajectory> decodeTrajectory(std::span<const std::uint8_t> bytes) {
    const std::optional<std::vector<std::uint8_t>> plain = inflated(bytes, kMostBytes);
    if (!plain) return std::nullopt;
    ByteReader in(*plain);
    Trajectory trajectory;
    if (!readHead(in, trajectory) || !momentsFit(trajectory, in.left())) return std::nullopt;
    makeMoments(trajectory);
    bool good = true;
    visitColumns(trajectory.bodies.size(), trajectory.resolution,
                 [&](double step, const Column& column) {
                     good = good && readColumn(in, trajectory, step, column);
                 });
    if (!good) return std::nullopt;
    if (!readImpulses(in, trajectory, trajectory.resolution.impulse) || !in.atEnd())
        return std::nullopt;
    for (TrajectoryMoment& moment : trajectory.moments)
        for (engine::Pose& pose : moment.poses) {
            if (!(pose.rotation.norm() > 0.5)) return std::nullopt;
            pose.rotation.normalize();
        }
    return trajectory;
}

}  // namespace demos
