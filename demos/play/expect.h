/// A scene's expectations, checked during the simulation.
///
/// What each kind measures, in the window from `after` to `until` (times included):
///   drift        m     largest horizontal distance of a body from its place at time 0
///   penetration  m     the deepest contact of the world
///   separation   m     largest separation of a joint; one that has broken fails
///   energy             largest |E - E0| / the largest kinetic energy since time 0; E0 at time 0
///   speed        m/s   largest speed of a body's centre of mass
///   position     m     distance of a body from the point `near` when the window closes (between
///                      two steps: interpolated linearly)
///   angle_deg    deg   largest angle between a body's y axis and the vertical
///   period       s     of a body's swing along x (z, if it moves farther along z): the mean over
///                      all full swings through the middle between its two ends; a passage counts
///                      if the body has been below it by a hundredth of the swing
///   count              number of bodies that were more than 0.5 m from their place at time 0
///   height       m     lowest height of a body's centre of mass above the origin, against gravity
///   spread       m     standard deviation of the bodies' x when the window closes
/// A bound applies to every body or joint of `of`; the reported value is that of the worst one.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "demos/play/stage.h"

namespace demos {

struct ExpectationResult {
    std::string text;    // "largest drift of box* below 0.005 m, 0 s to 3 s"
    double value = 0.0;  // measured
    std::string unit;    // "m", "s", or nothing
    bool passed = false;
    std::string why;         // the scene's reason
    std::string what = {};   // part of the text: "drift"
    std::string of = {};     // "box*", "all"; empty if the whole world is measured
    std::string asked = {};  // "below 0.005 m, 0 s to 3 s"
    std::string worst = {};  // if it failed, where and when: "'box7' at 1.2 s"
    bool finished = true;    // the run went on to the end of its window
};

/// The value with its unit, six digits, and the worst: "0.00123 m ('box7' at 1.2 s)".
std::string cameOut(const ExpectationResult& result);

/// "2 of 3 expectations failed, first: largest drift of ..."; empty if none failed whose window
/// the run has passed.
std::string failedLine(const std::vector<ExpectationResult>& results);

/// Writes numbers with their units.
struct QuantityWriter {
    std::function<std::string(double, const std::string& unit)> number;
    std::function<std::string(const Vec3&, const std::string& unit)> point;
};

/// ExpectationResult::asked, written by `write`. `seconds`: length of the scene.
std::string askedText(const Expectation& expectation, double seconds, const QuantityWriter& write);

class ExpectationChecker {
public:
    explicit ExpectationChecker(const Stage& stage);

    /// To be called at time 0 and after every step.
    void look(const Stage& stage);
    std::vector<ExpectationResult> results() const;

private:
    struct Swing {
        double time = 0.0;
        double x = 0.0, z = 0.0;
    };
    /// One body or joint under one expectation.
    struct Watched {
        int number = -1;     // index in scene.bodies or scene.joints; -1: the whole world
        double value = 0.0;  // so far; energy: J; spread: x
        double time = 0.0;   // s, of this value
        std::vector<Swing> swings;
        std::optional<double> lookedAt;  // s: time of the last look
        bool broken = false;             // separation: the joint is gone
        Vec3 place{0, 0, 0};             // m, at that time
    };
    struct Watch {
        Expectation expectation;
        double until = 0.0;
        bool measured = false, finished = false;
        std::vector<Watched> watched;  // a single one, without a number, for the whole world
    };

    bool isOpen(const Watch& watch, double time) const;
    void measure(const Stage& stage, const Watch& watch, Watched& watched) const;
    static Vec3 placeAtClosing(const Watch& watch, Watched& watched, double time,
                               const Vec3& place);
    double horizontalMove(const Stage& stage, int body) const;
    /// Nothing if there is no full swing.
    static std::optional<double> period(const std::vector<Swing>& swings);
    /// Why there is no value; empty: there is one.
    static std::string unmeasured(const Watch& watch);
    double valueOf(const Expectation& expectation, const Watched& watched) const;
    static double spreadOf(const std::vector<Watched>& watched);
    double worstOf(const Watch& watch, const Watched*& worst) const;
    /// Which bodies moved, or did not.
    std::string countText(const Watch& watch, double value) const;
    std::string worstText(const Watch& watch, const Watched* worst, double value) const;

    std::vector<Watch> watches_;
    std::vector<std::string> bodies_, joints_;  // names
    std::vector<Vec3> start_;                   // m, by body
    Vec3 up_{0, 1, 0};
    double halfStep_ = 0.0;                            // s: so that rounding misses no window
    double startEnergy_ = 0.0, largestKinetic_ = 0.0;  // J
};

}  // namespace demos
