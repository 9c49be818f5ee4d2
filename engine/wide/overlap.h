/// Two threads for one large group. A sweep runs from the top down, and so does the next: while one
/// thread sweeps the lower half, the other begins the next sweep above. Each keeps its half in its own
/// cache; a batch waits for the other half where they share a body, which is once a sweep and well
/// ahead:
///   upper half, sweep s       after  lower half, sweep s - 1, as far as it holds bodies of the batch
///   lower half, sweep s       after  upper half, sweep s, likewise
/// The order in which any body is solved is that of one thread, so the bits are the same. Only whether
/// another sweep follows has to be known earlier: the sweep before last decides, with one thread too.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "engine/base/workers.h"
#include "engine/step_report.h"
#include "engine/wide/contact_kernels.h"
#include "engine/wide/schedule.h"

namespace engine {

struct SweepLimits {
    int least = 0, most = 0;
    double tolerance = 0.0;  // m/s
};

/// Largest velocity correction and sum of impulses of all lanes.
SweepReport reportOf(const WideSums& sums);

class Overlap {
public:
    /// Of a group of so many contacts: all of them, if it is too small to be cut.
    static std::size_t sizeOfUpperHalf(std::size_t contacts);

    /// Once a step: which batches wait for which.
    void find(std::span<const std::array<int, 8>> batches, std::span<const BodyPair> pairs,
              std::span<const int> firstBatch, std::span<const int> middle, int bodies);
    int halfOf(int batch) const { return half_[batch]; }  // 0 upper, 1 lower

    /// Before the passes of a group; pass 0 is the warm start, pass s + 1 is sweep s.
    void begin(int mostSweeps);
    /// Waits for what batch k of its half needs before it is done in this pass.
    void waitFor(int k, int pass, int otherFirst, int otherCount);
    void reached(int half, int place) { progress_.reached(half, place); }
    /// Sweep s of one half is over.
    void report(int half, int sweep, const SweepReport& swept) { swept_[half][sweep] = swept; }
    /// Whether sweep s is done; waits until the sweep before last is over in the other half.
    bool follows(int half, int sweep, const SweepLimits& limits, int otherCount);
    /// Of both halves together.
    std::span<const SweepReport> reports(int sweeps);

private:
    Progress progress_;            // in batches over all passes
    int known_[2] = {};            // how far each half knows the other to be
    std::vector<char> half_;       // of every batch
    std::vector<int> needs_;       // of every batch: the last of the other half with a body of it, or -1
    std::vector<int> last_;        // of every body, while they are found
    std::vector<SweepReport> swept_[2], both_;
};

}  // namespace engine
