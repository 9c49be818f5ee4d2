/// The number of sub-steps an island needs (an island: bodies connected by contacts and joints).
///   links under tension     omega = sqrt(F r / I) is the rate at which a link pulled with F at the arm
///                           r swings across the pull; the feedback of joint nudges is stable and
///                           keeps its energy while h omega < 1 (1000 kg swung on 1 kg links: joints
///                           separate by 0.2 mm; at 1.2 by 2 mm, at 1.4 by 30 mm, and energy
///                           grows)
///   fast joints             h (|w1| + 2 |w1 - w0|) < 0.1: the rotation of the arms in a sub-step is nearly
///                           linear. w0, w1: at the start of the last and of the coming step, because a short
///                           link among long ones can triple its spin within a step. If h |w| is larger
///                           during the step, it is undone and repeated with more sub-steps. h |w1| < 0.3 in
///                           an island with contacts, which lose energy in any case; 0.5 in a net, whose
///                           tension decides (without h omega < 1 a strip of 5 by 40 balls tears when it whips)
///   columns and walls       more for taller ones (columns.h)
///   thin bodies that land   h v < t / 2, v: how fast two approach, t: the thickness of the thinner, on average over
///                           those that need more than usual, if they are more than one contact in fifty
///   heavy on light          four if a body rests on one of a tenth of its mass, eight on a fiftieth; on a
///                           hundredth, 3.2 for every level of the column (1000:1 on four: 16)
/// The number is 4, 8, 12, 16, 24, 32 ... (with 4 `substeps`), never above `maxSubsteps`, and above 32
/// only for fast joints without contacts, up to 2048 sub-steps times joints. It rises at once, and
/// falls only after a second in which fewer would have been enough; with joints and no contacts, after ten
/// seconds, because a symplectic integrator conserves energy only while its step is constant (five links lose
/// 10 % in two minutes with one second, 0.4 % with ten).
#pragma once
#include "engine/solver/columns.h"
#include "engine/solver/solver.h"

namespace engine {

/// What a choice depends on besides bodies and rows.
struct SubstepChoice {
    const Vec3& gravity;
    const Settings& settings;
    double dt;                         // s, the coming step
    std::span<const Velocity> before;  // by body, at the start of the last step; newer bodies may be missing
};

class Substeps {
public:
    /// Chooses the number of every awake body's island for the coming step. `islands`: the connected bodies.
    /// Returns the largest.
    int choose(DisjointSets& islands, std::span<const Contact> contacts,
               std::span<const Joint> joints, const Bodies& bodies, const Solver& solver,
               const SubstepChoice& step);
    /// After a sub-step: measures how fast the joints turn.
    void measure(std::span<const Joint> joints, const Bodies& bodies, const Solver& solver);
    /// After a step: raises the number of islands without contacts whose joints turned faster than foreseen.
    /// Returns whether there are any: then the step should be repeated.
    bool raise(DisjointSets& islands, std::span<const Contact> contacts, const Bodies& bodies,
               const Solver& solver, const SubstepChoice& step);
    int of(int body) const { return chosen_[body].current; }

    /// What is kept of it in a state (base/state_bytes.h). `most`: the largest number that can be chosen.
    template <class Bytes>
    void keep(Bytes& bytes, int most) {
        bytes(chosen_);
        if constexpr (!Bytes::kReads) return;
        for (const Chosen& c : chosen_)
            bytes.require(c.current >= 0 && c.current <= most && c.enough >= 0 && c.enough <= most);
    }

private:
    struct Chosen {
        int current = 0;     // 0: none yet
        int enough = 0;      // largest number needed
        double calm = 0.0;   // s, during this time

        template <class Bytes>
        void keep(Bytes& bytes) {
            bytes(current, enough, calm);
        }
    };
    struct Island {
        Chosen chosen;
        double needed = 0.0;
        double turn = 0.0;        // rad/s, of the fastest joint
        double turnToCome = 0.0;  // rad/s, during the step
        int joints = 0;           // of trees
        int contacts = 0, thin = 0;  // thin: between bodies that are fast for their thickness
        double thinSum = 0.0;        // the sub-steps that these need
        bool touching = false, any = false;
    };

    void addJoints(DisjointSets& islands, std::span<const Joint> joints, const Bodies& bodies,
                   const Solver& solver, const SubstepChoice& step);
    void addTurns(const Bodies& bodies, double dt);
    void addContacts(DisjointSets& islands, std::span<const Contact> contacts,
                     const Bodies& bodies, const Solver& solver, const SubstepChoice& step);
    static int mostOf(const Island& island, const Settings& settings);

    Columns columns_;
    std::vector<Chosen> chosen_;   // by body
    std::vector<Island> islands_;  // by leader
    std::vector<double> fastest_;  // rad/s, by joint constraint, in this step
};

/// Estimates, to first order, the forces in trees whose joints have changed, in the coming step; the next
/// choice uses them.
void estimateTension(std::span<Joint> joints, const Bodies& bodies, const Vec3& gravity,
                     Solver& solver, double dt);

}  // namespace engine
