// MuJoCo's models, simulated by MuJoCo and here: the positions of all bodies after a second. Where
// they differ for a reason, the model has its own tolerance and states the reason.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <fstream>

#include "demos/mjcf/model_reader.h"
#include "demos/play/stage.h"
#include "tests/demos/mjcf/mujoco_samples.h"
#include "tests/support/temporary_folder.h"

namespace demos::test {
namespace {

namespace fs = std::filesystem;

Vec3 yUp(const mjtNum* v) { return {v[0], v[2], -v[1]}; }

/// A model simulated by MuJoCo itself.
class Theirs {
public:
    explicit Theirs(const fs::path& file) {
        char error[500] = "";
        model_ = mj_loadXML(file.c_str(), nullptr, error, sizeof error);
        if (!model_) throw std::runtime_error(error);
        data_ = mj_makeData(model_);
        if (model_->nkey > 0) mju_copy(data_->ctrl, model_->key_ctrl, model_->nu);
    }
    Theirs(const Theirs&) = delete;
    Theirs& operator=(const Theirs&) = delete;
    ~Theirs() {
        mj_deleteData(data_);
        mj_deleteModel(model_);
    }

    void playFor(double seconds) {
        model_->opt.timestep = std::min<mjtNum>(model_->opt.timestep, 5e-4);  // for its accuracy
        const int steps = static_cast<int>(seconds / model_->opt.timestep + 0.5);
        for (int i = 0; i < steps; ++i) mj_step(model_, data_);
        mj_forward(model_, data_);
    }

    /// The bodies that have joints, in the file's order.
    std::vector<int> moving() const {
        std::vector<int> bodies;
        for (int i = 1; i < model_->nbody; ++i)
            if (model_->body_jntnum[i] > 0) bodies.push_back(i);
        return bodies;
    }

    /// The centre of mass of the body and all that is rigidly attached: m, y up.
    Vec3 centreOf(int number) const {
        Vec3 sum = Vec3::Zero();
        double mass = 0.0;
        for (int i = 0; i < model_->nbody; ++i) {
            if (model_->body_weldid[i] != model_->body_weldid[number]) continue;
            sum += model_->body_mass[i] * yUp(data_->xipos + 3 * i);
            mass += model_->body_mass[i];
        }
        return sum / mass;
    }

private:
    mjModel* model_ = nullptr;
    mjData* data_ = nullptr;
};

struct Difference {
    int bodies = 0;
    double worst = 0.0, mean = 0.0;  // m
    std::string where;
};

Difference differenceAfter(double seconds, const fs::path& file) {
    Stage stage(mjcf::loadModel(file, {}));
    for (int i = 0; i < static_cast<int>(seconds * stage.scene.hz + 0.5); ++i)
        if (!stage.step()) throw std::runtime_error("the world diverged");
    Theirs theirs(file);
    theirs.playFor(seconds);
    const std::vector<int> numbers = theirs.moving();
    std::size_t next = 0;
    Difference difference;
    for (std::size_t i = 0; i < stage.scene.bodies.size() && next < numbers.size(); ++i) {
        const BodyDescription& body = stage.scene.bodies[i];
        if (body.def.kind != engine::BodyKind::dynamic) continue;
        const Vec3 centre = theirs.centreOf(numbers[next++]);
        const double apart = (stage.world.pose(stage.bodies[i]).position - centre).norm();
        ++difference.bodies;
        difference.mean += apart;
        if (apart >= difference.worst) difference.worst = apart, difference.where = body.name;
    }
    difference.mean /= std::max(difference.bodies, 1);
    return difference;
}

void expectAlike(const MujocoSample& sample, const fs::path& file) {
    const Difference found = differenceAfter(sample.seconds, file);
    std::printf("%-28s %.2f s: %2d bodies, %8.3f mm on average, %8.3f mm at most (%s)%s%s\n",
                sample.name, sample.seconds, found.bodies, 1e3 * found.mean, 1e3 * found.worst,
                found.where.c_str(), *sample.why ? "; " : "", sample.why);
    EXPECT_GT(found.bodies, 0);
    EXPECT_LE(found.worst, sample.within) << found.where;
}

class MujocoPeer : public testing::TestWithParam<MujocoSample> {};

TEST_P(MujocoPeer, OwnSamplesMoveAlike) {
    const support::TemporaryFolder folder;
    std::ofstream(folder / "model.xml") << GetParam().text;
    expectAlike(GetParam(), folder / "model.xml");
}

INSTANTIATE_TEST_SUITE_P(Samples, MujocoPeer, testing::ValuesIn(kMujocoSamples),
                         [](const auto& of) { return std::string(of.param.name); });

class MujocoModels : public testing::TestWithParam<MujocoSample> {};

TEST_P(MujocoModels, OfItsOwnMoveAlike) {
    const fs::path file = fs::path(IMPULSE_MUJOCO_MODELS) / GetParam().text;
    if (!fs::exists(file)) GTEST_SKIP() << "skipped: " << file << " is not installed";
    expectAlike(GetParam(), file);
}

INSTANTIATE_TEST_SUITE_P(Models, MujocoModels, testing::ValuesIn(kMujocoModels),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace demos::test
