/// Joints that form trees, solved exactly: one linear system for a whole tree.
///   A lambda = -(J v + b),   A = J M^-1 J^T
/// A has a block for every joint and one for every two joints that share a movable body. It is
/// factored as L D L^T with blocks, joints of low degree first, so that a chain costs time linear in
/// its links and a tree hardly more. Sweeping a chain of a heavy ball on light links needs thousands
/// of sweeps instead (Catto, GDC 2014: they grow with the ratio of the masses).
///
/// A joint that would close a loop is left to the sweep, and so is a hinge or weld that would hold a
/// tree at a second fixed body: a row of parallel hinges between two banks holds the directions across
/// twice, but for a play so small that dividing by it throws the planks about. A row that follows from the others (the three
/// directions that a row of parallel hinges holds twice) shows as a pivot that vanishes; its impulse
/// is 0, so that contradicting joints do not tear at each other with ever larger impulses.
#pragma once
#include <span>
#include <vector>

#include "engine/constraints/contact_constraint.h"
#include "engine/constraints/joint_constraint.h"

namespace engine {

class JointTrees {
public:
    /// Chooses the forest and the order of elimination; sets `inTree`. For when joints come or go;
    /// their `count` of rows is known by then.
    void build(std::span<JointConstraint<double>> joints, std::span<const InverseMass<double>> masses);
    bool empty() const { return order_.empty(); }

    /// Factors A for the rows as they are now.
    void factor(std::span<const JointConstraint<double>> joints);

    /// x = A^-1 x for all trees at once; x holds kRows numbers for every joint of order().
    void solve(std::vector<double>& x) const;
    static constexpr int kRows = 6;

    /// One exact solve of J v + b = 0: lambda is added up and applied.
    void solveVelocities(std::span<JointConstraint<double>> joints,
                         std::span<Velocity<double>> v, Correction<double>& correction);
    /// Trees live in double; a float problem has its joints in the sweep.
    void solveVelocities(std::span<JointConstraint<float>>, std::span<Velocity<float>>,
                         Correction<float>&) {}

    /// Joints in order of elimination, by their place in the constraint list.
    const std::vector<int>& order() const { return order_; }

private:
    using Block = Eigen::Matrix<double, kRows, kRows>;  // its top left corner is used
    /// A joint eliminated later that this one is coupled with, directly or by fill-in.
    struct Neighbour {
        int place;                     // in order_
        int body;                      // the movable body in common; -1: fill-in
        Block block = Block::Zero();   // A_ik, then W_ik = A_ik D_k^-1
    };
    struct Node {
        int rows = 0;
        Block diagonal = Block::Zero();  // D_k, then its inverse
        std::vector<Neighbour> later;
    };

    void choose(std::span<JointConstraint<double>> joints,
                std::span<const InverseMass<double>> masses);
    void eliminate(int place);

    std::vector<int> order_;
    std::vector<Node> nodes_;
    std::vector<double> work_;
};

}  // namespace engine
