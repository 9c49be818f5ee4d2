/// The common plane of a manifold's points: they are moved along the normal to the height of the point that
/// touches first. The normal rows do not depend on where along its gap a point is, and in one plane the
/// friction of all points is one force and one twist.
#pragma once
#include "engine/constraints/contact.h"

namespace engine {

struct ManifoldFrame {
    Vec3 t1, t2;
    Vec3 centre = Vec3::Zero();  // r_a of the mean of the points, m
    double reach = 0.0;          // m, largest distance of a point from it along t1 or t2
    int count = 0;
    double x[Contact::kMaxPoints], y[Contact::kMaxPoints];  // m, from the centre along t1 and t2
    double gap[Contact::kMaxPoints];                        // C, m

    /// Adds a point midway between the two surfaces, and their separation.
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
