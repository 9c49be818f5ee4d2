/// Two threads for one large group. All sweeps run from the top down: while one thread sweeps the lower half,
/// the other begins the next sweep in the upper half. Each keeps its half in its own cache. A batch waits for
/// the other half only where they share a body, once per sweep, and usually that is done long before:
///   upper half, sweep s       after  lower half, sweep s - 1, as far as it holds bodies of the batch
///   lower half, sweep s       after  upper half, sweep s, with the same condition
/// Every body is solved in the same order as with one thread, so the bits are the same. But whether another
/// sweep follows must be known earlier: the sweep before last decides, also with one thread.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "engine/base/workers.h"
#include "engine/step_report.h"
#include "engine/wide/contact_kernels.h"
#include "engine/wide/schedule.h"

namespace engine {

/// Sweeps end after `least` with a residual below `tolerance` (m/s), even after `fewest` with a hundredth of it,
/// where nothing moves, and after `usual` with one below `bearable`.
struct SweepLimits {
    int fewest = 0, least = 0, usual = 0, most = 0;
    double tolerance = 0.0, bearable = 0.0;

    bool areEnough(int sweeps, double residual) const {
        if (sweeps >= usual && residual < bearable) return true;
        return sweeps >= fewest && residual < (sweeps >= least ? tolerance : 0.01 * tolerance);
    }
};

/// Largest velocity correction and sum of impulses over all lanes.
SweepReport reportOf(const WideSums& sums);

class Overlap {
public:
    /// For a group with this number of contacts: all of them, if it is too small to divide.
    static std::size_t sizeOfUpperHalf(std::size_t contacts);

    /// Once per step: finds which batches wait for which.
    void find(std::span<const std::array<int, 8>> batches, std::span<const BodyPair> pairs,
              std::span<const int> firstBatch, std::span<const int> middle, int bodies);
    int halfOf(int batch) const { return half_[batch]; }  // 0 upper, 1 lower

    /// Called before the passes of a group; pass 0 is the warm start, pass s + 1 is sweep s.
    void begin(int mostSweeps);
    /// Waits for the batches of the other half that batch k depends on in this pass.
    void waitFor(int k, int pass, int otherFirst, int otherCount);
    void reached(int half, int place) { progress_.reached(half, place); }
    /// Reports the end of sweep s in one half.
    void report(int half, int sweep, const SweepReport& swept) { swept_[half][sweep] = swept; }
    /// Whether sweep s is needed; waits until the other half has finished the sweep before last.
    bool follows(int half, int sweep, const SweepLimits& limits, int otherCount);
    /// The reports of both halves combined.
    std::span<const SweepReport> reports(int sweeps);

private:
    Progress progress_;            // in batches, over all passes
    int known_[2] = {};            // the other half's progress as known to each
    std::vector<char> half_;       // by batch
    std::vector<int> needs_;       // by batch: the last of the other half that shares a body, or -1
    std::vector<int> last_;        // by body, used by find()
    std::vector<SweepReport> swept_[2], both_;
};

}  // namespace engine
