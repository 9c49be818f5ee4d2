/// The contacts of a world in single precision, eight side by side: the fast form of
/// solver/impulses.h and solver/nudges.h for contacts. Poses and velocities stay in double; floats hold
/// what solving changes of them, so that what no impulse touches keeps all its digits.
#pragma once
#include <span>
#include <vector>

#include "engine/base/workers.h"
#include "engine/constraints/contact.h"
#include "engine/constraints/manifold_frame.h"
#include "engine/dynamics/bodies.h"
#include "engine/settings.h"
#include "engine/step_report.h"
#include "engine/wide/contact_kernels.h"
#include "engine/wide/groups.h"
#include "engine/wide/overlap.h"
#include "engine/wide/schedule.h"

namespace engine {

/// What one point got, N s: in the last sub-step, and over the whole step.
struct PointImpulses {
    double normal = 0.0, total = 0.0;
    Vec3 friction = Vec3::Zero(), totalFriction = Vec3::Zero();
};

class WideContacts {
public:
    /// Rows of all contacts, at the bodies' present poses; once a step. `order` is that of a sweep. The
    /// workers are for this step.
    void prepare(std::span<const Contact> contacts, std::span<const int> order,
                 std::span<const Joint> joints, const Bodies& bodies, DisjointSets& islands,
                 const Settings& settings, Workers& workers);

    bool empty() const { return batches_.empty(); }
    const ContactGroups& groups() const { return groups_; }

    /// Whose turn it is: of all that follows, what bodies wait for is left alone.
    void beginSubstep(const Bodies& bodies);
    bool acts(int group) const { return spans_[group] > 0.0; }
    /// Biases, from the velocities before solving.
    void begin(std::span<const Velocity> v, const Settings& settings);
    /// What a point got when its bodies met (solver/impacts.h), N s; after begin().
    void setBounce(int contact, int i, double impulse);
    void warmStart(int group);
    SweepReport sweep(int group);
    /// Warm start and sweeps of a large group (overlap.h), which may be shared by two threads.
    bool isLarge(int group) const { return middle_[group] < firstBatch_[group + 1]; }
    std::span<const SweepReport> solveLarge(int group, const SweepLimits& limits);
    /// Takes in the velocities of bodies that others have changed; gives back what sweeps changed.
    void take(std::span<const Velocity> v, std::span<const int> bodies);
    void give(std::span<Velocity> v, std::span<const int> bodies);
    /// All of them, and the sub-step's impulses into the totals.
    void finish(std::span<Velocity> v);

    /// C of every point at the bodies' present poses; true: some overlap is deeper than the slop.
    bool separate(const Bodies& bodies, double slop);
    /// Masses of the contacts whose bodies have turned far since their rows were made; after separate().
    void followTurns(const Bodies& bodies);
    /// One nudge of all contacts by at most `most` (m) and the depenetration speed, after separate(): the
    /// bodies' ways (m) and turns (rad).
    std::span<const WideVelocity> nudge(const Settings& settings, double most);

    PointImpulses impulses(int contact, int point) const;
    /// Those of the last sub-step to where the next step finds them.
    void store(std::span<Contact> contacts) const;

private:
    void arrange(std::span<const Contact> contacts, std::span<const int> order,
                 const Bodies& bodies);
    void fillBatch(int batch, std::span<const Contact> contacts, const Bodies& bodies);
    void fillLane(int batch, int lane, const Contact& contact, const Bodies& bodies);
    void fillEmptyLane(int batch, int lane);
    void fillPoint(int batch, int lane, int i, const ContactPoint& from,
                   const ManifoldFrame& frame);
    void fillNoPoint(int batch, int lane, int i);
    void give(Velocity& v, int body);
    bool hasTurned(int batch, int lane) const;
    void store(int k, Contact& contact) const;
    SweepReport sweepBatches(int first, int end);
    int solveHalf(int group, int half, const SweepLimits& limits);
    void pass(int group, int half, int number);

    /// work(batch) for all batches whose turn it is, work(body) for all bodies, in any order.
    template <class Work>
    void eachBatch(const Work& work);
    template <class Work>
    void eachBody(const Work& work);
    const ContactKernels* kernels_ = nullptr;
    Workers* workers_ = nullptr;
    ContactGroups groups_;
    Schedule schedule_;
    std::vector<std::vector<int>> orders_;   // of every group
    std::vector<int> firstBatch_;            // of every group, and the end
    std::vector<double> spans_;              // s, of every group's sub-step; 0: it waits
    std::vector<float> batchSpans_;          // likewise of every batch
    std::vector<int> middle_;                // of every group: the first batch of the lower half
    Overlap overlap_;
    std::vector<ContactBatch> batches_;
    std::vector<ContactRecord> records_;
    std::vector<int> place_;                 // of every contact: 8 batch + lane
    std::vector<BodyPair> pairs_;
    // Of every body; then a slot of zeros for empty lanes to read, and for either half one for waste.
    std::vector<WideVelocity> now_, before_, motions_, ways_;
    std::vector<Velocity> atStart_;          // of the sub-step, before solving
    std::vector<Pose> start_;                // where the rows were made
    std::vector<Mat3> axes_;                 // their rotations
    std::vector<char> turned_;               // far, since then
    std::vector<double> farTurn_;            // rad, of every body
    bool anyTurned_ = false;
    WideStep step_;
};

}  // namespace engine
