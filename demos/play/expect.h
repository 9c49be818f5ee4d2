/// A scene's physics contract, checked while it plays.
///
/// What each kind measures, in the window from `after` to `until` (times included):
///   drift        m     how far a body has moved horizontally since time 0, at most
///   penetration  m     the deepest contact of the world
///   separation   m     of a joint, at most
///   energy             |E - E0| at most / the largest kinetic energy since time 0; E0 of time 0
///   speed        m/s   of a body's centre of mass, at most
///   position     m     how far a body is from the point `near` when the window closes (between two
///                      steps: on the line between its places of both)
///   angle_deg    deg   between a body's y axis and the vertical, at most
///   period       s     of a body's swing along x (z, if it moves farther along z): the mean over
///                      all full swings through the middle between its two ends
///   count              bodies that were more than 0.5 m from their place of time 0
///   height       m     of a body's centre of mass above the origin, against gravity: the lowest
///   spread       m     standard deviation of the bodies' x when the window closes
/// A bound holds for every body or joint of `of`: the value told is that of the worst one.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "demos/play/stage.h"

namespace demos {

struct ExpectationResult {
    std::string text;    // "drift of box* below 0.005 m, 0 s to 3 s"
    double value = 0.0;  // measured
    std::string unit;    // "m", "s", or nothing
    bool passed = false;
    std::string why;         // the scene's reason
    std::string what = {};   // of the text: "drift"
    std::string of = {};     // "box*", "all"; empty of what the whole world has
    std::string asked = {};  // "below 0.005 m, 0 s to 3 s"
};

/// The value with its unit, six digits: "0.00123 m".
std::string cameOut(const ExpectationResult& result);

/// How numbers with their units are written.
struct QuantityWriter {
    std::function<std::string(double, const std::string& unit)> number;
    std::function<std::string(const Vec3&, const std::string& unit)> point;
};

/// ExpectationResult::asked, written so. `seconds`: of the scene.
std::string askedText(const Expectation& expectation, double seconds, const QuantityWriter& write);

class ExpectationChecker {
public:
    explicit ExpectationChecker(const Stage& stage);

    /// At time 0, and after every step.
    void look(const Stage& stage);
    std::vector<ExpectationResult> results() const;

private:
    struct Swing {
        double time = 0.0;
        double x = 0.0, z = 0.0;
    };
    /// One body or joint under one expectation.
    struct Watched {
        int number = 0;      // in scene.bodies or scene.joints
        double value = 0.0;  // so far; energy: J; spread: x
        std::vector<Swing> swings;
        std::optional<double> lookedAt;  // s: position and height, the last look
        Vec3 place{0, 0, 0};             // m, then
    };
    struct Watch {
        Expectation expectation;
        double until = 0.0;
        bool measured = false;
        std::vector<Watched> watched;  // one, without a number, for what the whole world has
    };

    bool isOpen(const Watch& watch, double time) const;
    void measure(const Stage& stage, const Watch& watch, Watched& watched) const;
    static Vec3 placeAtClosing(const Watch& watch, Watched& watched, double time,
                               const Vec3& place);
    double horizontalMove(const Stage& stage, int body) const;
    static double period(const std::vector<Swing>& swings);
    double valueOf(const Expectation& expectation, const Watched& watched) const;
    static double spreadOf(const std::vector<Watched>& watched);
    double worstOf(const Watch& watch) const;

    std::vector<Watch> watches_;
    std::vector<Vec3> start_;  // m, by body
    Vec3 up_{0, 1, 0};
    double halfStep_ = 0.0;                            // s: no window is missed by rounding
    double startEnergy_ = 0.0, largestKinetic_ = 0.0;  // J
};

}  // namespace demos
