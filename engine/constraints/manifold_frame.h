/// The plane that a manifold's points are put in: across the normal they stay where they are, along it
/// they go to the height of the one that is touched first. Where along its gap a point is makes no
/// difference to the normal rows; in one plane, friction of all points is one force and one twist.
#pragma once
#include "engine/constraints/contact.h"

namespace engine {

struct ManifoldFrame {
    Vec3 t1, t2;
    Vec3 centre = Vec3::Zero();  // r_a of the middle of the points, m
    double reach = 0.0;          // m, of the points from there, along t1 or t2
    int count = 0;
    double x[Contact::kMaxPoints], y[Contact::kMaxPoints];  // m, from the centre along t1 and t2
    double gap[Contact::kMaxPoints];                        // C, m

    /// A point in the middle between the two surfaces, and how far they are apart.
    void add(const Vec3& armA, double separation) {
        if (count == 0 || separation < gap[deepest_]) deepest_ = count;
        arms_[count] = armA;
        gap[count++] = separation;
        centre += armA;
    }

    void finish(const Vec3& n) {
        tangents(n, t1, t2);
        centre /= static_cast<double>(count);
        centre += n.dot(arms_[deepest_] - centre) * n;
        for (int i = 0; i < count; ++i) {
            x[i] = count > 1 ? t1.dot(arms_[i] - centre) : 0.0;
            y[i] = count > 1 ? t2.dot(arms_[i] - centre) : 0.0;
            reach = larger(reach, larger(std::abs(x[i]), std::abs(y[i])));
        }
    }

    Vec3 arm(int i) const { return centre + x[i] * t1 + y[i] * t2; }

private:
    Vec3 arms_[Contact::kMaxPoints];
    int deepest_ = 0;
};

}  // namespace engine
