#include <algorithm>

#include "engine/wide/wide_contacts.h"

namespace engine {
namespace {

constexpr std::size_t kLarge = 1024;  // contacts: smaller groups are not divided
constexpr int kInOneGo = 8;           // batches between two checks of the other half's progress

}  // namespace

SweepReport reportOf(const WideSums& sums) {
    SweepReport report;
    for (int lane = 0; lane < 8; ++lane) {
        report.residual = larger(report.residual, static_cast<double>(sums.velocity[lane]));
        report.delta += static_cast<double>(sums.impulse[lane]);
    }
    return report;
}

std::size_t Overlap::sizeOfUpperHalf(std::size_t contacts) {
    return contacts < kLarge ? contacts : contacts / 2;
}

void Overlap::find(std::span<const std::array<int, 8>> batches, std::span<const BodyPair> pairs,
                   std::span<const int> firstBatch, std::span<const int> middle, int bodies) {
    half_.assign(batches.size(), 0);
    needs_.assign(batches.size(), -1);
    const auto eachBody = [&](int k, const auto& what) {
        for (const int contact : batches[k]) {
            if (contact < 0) continue;
            if (pairs[contact].a >= 0) what(pairs[contact].a);
            if (pairs[contact].b >= 0) what(pairs[contact].b);
        }
    };
    const auto needed = [&](int first, int end, int otherFirst, int otherEnd) {
        last_.assign(bodies, -1);
        for (int k = otherFirst; k < otherEnd; ++k)
            eachBody(k, [&](int body) { last_[body] = k; });
        for (int k = first; k < end; ++k)
            eachBody(k, [&](int body) { needs_[k] = std::max(needs_[k], last_[body]); });
    };
    for (std::size_t g = 0; g < middle.size(); ++g) {
        const int first = firstBatch[g], cut = middle[g], end = firstBatch[g + 1];
        if (cut == end) continue;
        std::fill(half_.begin() + cut, half_.begin() + end, 1);
        needed(first, cut, cut, end);
        needed(cut, end, first, cut);
    }
}

void Overlap::begin(int mostSweeps) {
    progress_.reset(2);
    known_[0] = known_[1] = 0;
    for (std::vector<SweepReport>& swept : swept_) swept.assign(mostSweeps, {});
}

void Overlap::waitFor(int k, int pass, int otherFirst, int otherCount) {
    if (needs_[k] < 0) return;
    const int half = half_[k];
    const int theirs = half == 0 ? pass - 1 : pass;  // the other half's pass before this one
    if (theirs < 0) return;
    const int place = theirs * otherCount + (needs_[k] - otherFirst) + 1;
    if (known_[half] < place) known_[half] = progress_.waitFor(1 - half, place);
}

bool Overlap::follows(int half, int sweep, const SweepLimits& limits, int otherCount) {
    if (sweep >= limits.most) return false;
    if (sweep < limits.fewest || sweep < 2) return true;
    const int decides = sweep - 2;
    const int place = (decides + 2) * otherCount;
    if (known_[half] < place) known_[half] = progress_.waitFor(1 - half, place);
    return !limits.areEnough(sweep, swept_[0][decides].residual) ||
           !limits.areEnough(sweep, swept_[1][decides].residual);
}

std::span<const SweepReport> Overlap::reports(int sweeps) {
    both_.clear();
    for (int s = 0; s < sweeps; ++s)
        both_.push_back({larger(swept_[0][s].residual, swept_[1][s].residual),
                         swept_[0][s].delta + swept_[1][s].delta});
    return both_;
}

void WideContacts::pass(int group, int half, int number) {
    const int cut = middle_[group], start = firstBatch_[group], stop = firstBatch_[group + 1];
    const int first = half == 0 ? start : cut, end = half == 0 ? cut : stop;
    const int otherFirst = half == 0 ? cut : start, otherCount = half == 0 ? stop - cut : cut - start;
    WideSums sums;
    for (int k = first; k < end; k += kInOneGo) {
        const int until = smaller(k + kInOneGo, end);
        for (int j = k; j < until; ++j) overlap_.waitFor(j, number, otherFirst, otherCount);
        if (number > 0) kernels_->sweep(&batches_[k], &slips_[k], until - k, now_.data(), sums);
        for (int j = k; number == 0 && j < until; ++j)
            kernels_->warmStart(batches_[j], now_.data(), step_);
        if (until == end && number > 0) overlap_.report(half, number - 1, reportOf(sums));
        overlap_.reached(half, number * (end - first) + (until - first));
    }
}

int WideContacts::solveHalf(int group, int half, const SweepLimits& limits) {
    const int cut = middle_[group];
    const int otherCount = half == 0 ? firstBatch_[group + 1] - cut : cut - firstBatch_[group];
    pass(group, half, 0);
    int s = 0;
    for (; overlap_.follows(half, s, limits, otherCount); ++s) pass(group, half, s + 1);
    return s;
}

std::span<const SweepReport> WideContacts::solveLarge(int group, const SweepLimits& limits) {
    overlap_.begin(limits.most);
    int sweeps = 0;
    if (workers_->count() > 1) {
        workers_->run([&](int thread) {
            if (thread == 0) sweeps = solveHalf(group, 0, limits);
            if (thread == 1) solveHalf(group, 1, limits);
        });
        return overlap_.reports(sweeps);
    }
    const int lower = firstBatch_[group + 1] - middle_[group];
    for (const int half : {0, 1}) pass(group, half, 0);
    for (; overlap_.follows(0, sweeps, limits, lower); ++sweeps)
        for (const int half : {0, 1}) pass(group, half, sweeps + 1);
    return overlap_.reports(sweeps);
}

}  // namespace engine
