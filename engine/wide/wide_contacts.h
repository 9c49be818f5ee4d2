/// The contacts of a world in single precision, eight side by side: the fast form of solver/impulses.h and
/// solver/nudges.h for contacts. Poses and velocities are in double; floats hold only the changes by the
/// solver, so other motion keeps all its digits.
#pragma once
#include <span>
#include <vector>

#include "engine/base/workers.h"
#include "engine/constraints/contact.h"
#include "engine/dynamics/bodies.h"
#include "engine/settings.h"
#include "engine/step_report.h"
#include "engine/wide/contact_kernels.h"
#include "engine/wide/groups.h"
#include "engine/wide/overlap.h"
#include "engine/wide/schedule.h"

namespace engine {

/// The impulses of one point, N s: in the last sub-step, and over the whole step.
struct PointImpulses {
    double normal = 0.0, total = 0.0;
    Vec3 friction = Vec3::Zero(), totalFriction = Vec3::Zero();
};

class WideContacts {
public:
    /// Makes the rows of all contacts at the present poses, once per step. `order` is the order of a sweep.
    /// The groups and workers are used during this step.
    void prepare(std::span<const Contact> contacts, std::span<const int> order,
                 const ContactGroups& groups, const Bodies& bodies, const Settings& settings,
                 Workers& workers);

    bool empty() const { return batches_.empty(); }

    /// Finds which groups act in this sub-step; the functions below skip the others.
    void beginSubstep(const Bodies& bodies);
    bool acts(int group) const { return spans_[group] > 0.0; }
    /// Sets biases from the velocities before solving.
    void begin(std::span<const Velocity> v, const Settings& settings);
    /// Sets the bounce impulse of a point (solver/impacts.h), N s; adds `ahead` (m) to its gap; after begin().
    void setBounce(int contact, int i, double impulse, double ahead);
    /// Sets the slip that friction leaves, m/s, and turns its start impulses (rad): see
    /// solver/riding_contacts.h. After begin(), before warmStart().
    void setLead(int contact, const Vec3& lead, const Vec3& turn);
    void warmStart(int group);
    SweepReport sweep(int group);
    /// Large groups (overlap.h): solveLarge does warm start and sweeps, possibly with two threads.
    bool isLarge(int group) const { return middle_[group] < firstBatch_[group + 1]; }
    std::span<const SweepReport> solveLarge(int group, const SweepLimits& limits);
    /// Takes back the impulses of the islands of a group without joints that have brought energy:
    /// solver/fresh_start.h. Returns whether there was one. A large group is one island, so solveLarge may
    /// follow.
    bool takeBack(int group);
    /// The same for a group with joints (solver/joined_start.h): adds the energies that its contacts have brought, by
    /// island; takes back the impulses of the islands where that is above 0.
    void addBrought(int group, std::span<double> brought);
    void withdraw(int group, std::span<const double> brought);
    /// take: reads velocities that joints have changed. give: writes back the changes by sweeps.
    void take(std::span<const Velocity> v, std::span<const int> bodies);
    void give(std::span<Velocity> v, std::span<const int> bodies);
    /// Writes back all velocities, and adds the impulses of the sub-step to the totals.
    void finish(std::span<Velocity> v);

    /// Updates C of every point at the present poses; true if some overlap is deeper than the slop.
    bool separate(const Bodies& bodies, double slop);
    /// The same also where bodies wait; after prepare(), for bodies that were at other poses then.
    bool separateAll(const Bodies& bodies, double slop);
    /// Updates the masses of contacts whose bodies have turned far since their rows were made; after
    /// separate().
    void followTurns(const Bodies& bodies);
    /// Nudges all contacts once, limited by `most` (m) and the depenetration speed, after separate(). Returns
    /// the bodies' translations (m) and rotations (rad).
    std::span<const WideVelocity> nudge(const Settings& settings, double most);

    PointImpulses impulses(int contact, int point) const;
    Vec3 normalOf(int contact) const;
    /// Stores the impulses of the last sub-step for the next step.
    void store(std::span<Contact> contacts) const;

    /// What is kept of it in a state (base/state_bytes.h): of bodies that rest, what they had when they moved.
    template <class Bytes>
    void keep(Bytes& bytes) {
        for (std::size_t i = start_.size(); i < now_.size(); ++i) now_[i] = {};  // slots, not bodies
        bytes(now_, motions_, atStart_, start_, turned_, farTurn_);
        if constexpr (!Bytes::kReads) return;
        axes_.clear();
        for (const Pose& pose : start_) axes_.push_back(pose.rotation.toRotationMatrix());
    }

private:
    void arrange(std::span<const Contact> contacts, std::span<const int> order,
                 const Bodies& bodies);
    void prepareBodies(const Bodies& bodies);
    void fillBatch(int batch, std::span<const Contact> contacts, const Bodies& bodies);
    void give(Velocity& v, int body);
    bool hasTurned(int batch, int lane) const;
    void measureMotion(const Bodies& bodies, int i);
    template <class Measure>
    bool separate(double slop, const Measure& measure);
    void store(int k, Contact& contact) const;
    SweepReport sweepBatches(int first, int end);
    int solveHalf(int group, int half, const SweepLimits& limits);
    void pass(int group, int half, int number);

    /// Calls work(batch) for all acting batches, or work(body) for all bodies, in any order.
    template <class Work>
    void eachBatch(const Work& work);
    template <class Work>
    void eachBody(const Work& work);
    /// Calls what(batch, lane, island) for the contacts of a group, in a fixed order.
    template <class What>
    void eachLane(int group, const What& what);
    const ContactKernels* kernels_ = nullptr;
    Workers* workers_ = nullptr;
    const ContactGroups* groups_ = nullptr;
    Schedule schedule_;
    std::vector<std::vector<int>> orders_;   // by group
    std::vector<int> firstBatch_;            // by group, and the end
    std::vector<double> spans_;              // s, sub-step by group; 0: it waits
    std::vector<float> batchSpans_;          // the same by batch
    std::vector<int> middle_;                // by group: the first batch of the lower half
    Overlap overlap_;
    std::vector<ContactBatch> batches_;
    std::vector<ContactRecord> records_;
    std::vector<ContactSlip> slips_;
    std::vector<int> place_;                 // by contact: 8 batch + lane
    std::vector<BodyPair> pairs_;
    // By body; then a slot of zeros that empty lanes read, and one per half for unused results.
    std::vector<WideVelocity> now_, before_, motions_, ways_;
    std::vector<int> active_;                // of Bodies: nothing changes of the others
    std::vector<Velocity> atStart_;          // velocities before solving the sub-step
    std::vector<Pose> start_;                // where the rows were made
    std::vector<Mat3> axes_;                 // their rotations
    std::vector<char> turned_;               // has turned far since then
    std::vector<double> farTurn_;            // rad, by body
    bool anyTurned_ = false;
    std::vector<double> brought_;            // J, by island
    WideStep step_;
};

}  // namespace engine
