/// Springs, motors and limits of the joints of a tree, solved together with it. With the tree's rows J_t, the velocities
/// after its next solve respond to impulses by
///   S = M^-1 - M^-1 J_t^T (J_t M^-1 J_t^T)^-1 J_t M^-1
/// so the rows J of its drives (constraints/drive.h) are a small problem in numbers,
///   w = J v + b + gamma lambda,   A = J S J^T + gamma,   low <= lambda <= high:
///   w = 0, or w > 0 at low, or w < 0 at high
/// A column of A is one solve of the tree, S J^T, which is kept: impulses are applied with it. Only rows that act get
/// one: a limb has two or three at its limits.
///
/// To sweep over bodies instead, with a solve of the tree after each pass, hardly converges where a limit moves much
/// behind other joints: limits of light limbs on heavy ones gained energy. The problem in numbers is swept too, which
/// costs little, and in between all rows that are not at a bound are solved at once, as far as the bounds allow
/// (Silcowitz, Niebe, Erleben, 'Projected Gauss-Seidel subspace minimization method for interactive rigid body
/// dynamics', 2010). Both reduce the energy, so stopping early is safe.
#pragma once
#include <span>
#include <vector>

#include "engine/constraints/contact_constraint.h"
#include "engine/solver/constraints.h"

namespace engine {

class TreeDrives {
public:
    /// After drives and trees were sorted into groups: which drives are solved with a tree.
    void sort(const Constraints& c, const JointTrees& trees, int groups);
    /// Once per sub-step of a group: J and M have changed.
    void begin(int group, const JointTrees& trees);
    /// Solves the drives of a group; those of trees so that the tree stays solved. `moved`: joints outside the trees
    /// have changed velocities since the trees were solved.
    void solve(int group, bool moved, Constraints& c, JointTrees& trees, std::span<Velocity> v, Correction& correction);

private:
    struct Unknown {
        int drive = 0, row = 0;
        int column = -1;                  // of A; -1: none yet
        double k = 0.0;                   // J M^-1 J^T
        double w = 0.0, lambda = 0.0;
        double low = 0.0, high = 0.0, softness = 0.0;
        bool isAtBound() const { return (w >= 0.0 && lambda <= low) || (w <= 0.0 && lambda >= high); }
    };
    struct System {
        int tree = -1, group = -1;
        int always = 0;                 // rows that always act
        int columns = 0;
        bool tooMany = false;           // rows that act
        std::vector<Unknown> rows;
        std::vector<double> a;          // A without gamma, column by column
        std::vector<Velocity> changes;  // S J^T of each column, of the tree's bodies in their order
        std::vector<double> impulses;   // of the tree for each column

        double at(int row, int of) const { return a[rows[of].column * rows.size() + row]; }
        bool canMove(int row) const;
    };

    void read(System& s, const Constraints& c, std::span<const Velocity> v) const;
    bool addColumn(System& s, int row, const Constraints& c, JointTrees& trees);
    double sweepOnce(System& s, const Constraints& c, JointTrees& trees);
    void findInside(const System& s);
    void eliminate(const System& s);
    void solveInside(System& s);
    static void change(System& s, int row, double lambda);
    void write(System& s, Constraints& c, JointTrees& trees, std::span<Velocity> v, Correction& correction) const;
    void applyColumn(const System& s, int row, double lambda, JointTrees& trees, std::span<Velocity> v) const;

    std::vector<System> systems_;
    ByGroup byGroup_;                 // systems
    std::vector<int> systemOfTree_;   // -1: none
    std::vector<char> inSystem_;      // by drive
    std::vector<Velocity> response_;  // by body; 0 between two columns
    std::vector<int> inside_;         // rows of a system: strictly between their bounds,
    std::vector<double> matrix_, x_;  // and their A x = -w
};

}  // namespace engine
