/// Joints that share bodies with others, in nets and lattices, are solved in several forests, one after the other
/// (joint_forests.h): sweeps over them converge slowly, because each undoes a part of what the one before has
/// done. The impulses that satisfy all of them minimise
///   f = v . M v / 2 + lambda . (b + gamma lambda / 2),   v = v0 + M^-1 J^T lambda
/// for b = gamma = 0 the kinetic energy. A sweep changes lambda by d. Conjugate gradients with the sweep as
/// preconditioner go on from lambda by
///   p' = alpha d + beta p
/// where p is the step before, and alpha and beta minimise f:
///   | d.Ad  d.Ap | |alpha|     | d.f' |
///   | p.Ad  p.Ap | |beta | = - | p.f' |
///   d.Ap = dv . M pv + d.(gamma p),   d.f' = dv . M v + d.(b + gamma lambda)
/// (Knyazev 1991, locally optimal), with dv and pv the changes of velocity by d and p. No step increases f,
/// whatever the sweep.
///
/// The impulses so far, of the last sub-step and of the sweeps before, are the first p: nothing of them is kept
/// that does not reduce f. In a net with more rows than its bodies can move in, they would grow against each other.
/// A calm net is satisfied by the first sweeps alone, which cost half as much.
///
/// Limits and contacts are inequalities, for which this is not valid: groups with one of them are only swept.
#pragma once
#include <span>
#include <vector>

#include "engine/solver/constraints.h"

namespace engine {

class ConjugateJoints {
public:
    /// Before the groups of a sub-step. `masses`: of all bodies; they have to stay until the last goOn().
    void prepare(std::span<const InverseMass> masses) { masses_ = masses; }
    /// Before the first sweep that is completed by goOn().
    void begin(Constraints& c, JointTrees& trees, int group, std::span<Velocity> v);
    /// After a sweep: completes it by the same sweep back, and takes the best step.
    void goOn(Constraints& c, JointTrees& trees, int group, std::span<Velocity> v);

private:
    struct Row {
        double at = 0.0, swept = 0.0, step = 0.0;  // N s (N m s): lambda, d, p
        double bias = 0.0, softness = 0.0;         // b, gamma
    };
    struct Body {
        int number = -1;
        double mass = 0.0;             // kg
        Mat3 inertia = Mat3::Zero();   // kg m^2, in world axes
        Velocity at, swept, step;      // v, dv, pv
    };
    struct Shares {
        double alpha = 1.0, beta = 0.0;
    };
    void add(int body);
    Shares bestShares() const;

    std::span<const InverseMass> masses_;
    std::vector<Row> rows_;
    std::vector<Body> bodies_;
    std::vector<char> isThere_;  // by body
};

}  // namespace engine
