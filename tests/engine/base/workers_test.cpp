// Threads share work: every item is done once, by any thread, and all are done when the call returns.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <vector>

#include "engine/base/workers.h"

namespace engine {
namespace {

TEST(Workers, CallEveryThreadOnceAndWaitForAll) {
    Workers workers;
    for (const int threads : {1, 2, 4, 3, 1}) {
        workers.setCount(threads);
        ASSERT_EQ(workers.count(), threads);
        for (int call = 0; call < 200; ++call) {
            std::vector<int> called(threads, 0);
            workers.run([&](int i) { ++called[i]; });
            EXPECT_EQ(called, std::vector<int>(threads, 1));
        }
    }
}

TEST(Workers, ShareEveryPlaceOnceInOrder) {
    Workers workers;
    workers.setCount(3);
    for (const int n : {0, 1, 10, 11, 99, 1000}) {
        std::vector<int> owner(n, -1);
        std::atomic<int> done{0};
        workers.share(n, 10, [&](int first, int end, int part) {
            for (int i = first; i < end; ++i) owner[i] = part, ++done;
        });
        EXPECT_EQ(done, n);
        EXPECT_TRUE(std::is_sorted(owner.begin(), owner.end())) << n;
        EXPECT_EQ(n > 0 && owner.back() > 0, n >= 20) << n;  // a thread has at least ten
    }
}

TEST(Progress, LetsNobodyPassBeforeItsTime) {
    Workers workers;
    workers.setCount(2);
    Progress progress;
    constexpr int kPlaces = 5000;
    std::vector<int> log;  // the two alternate, so no lock is needed
    progress.reset(2);
    workers.run([&](int me) {
        for (int i = 0; i < kPlaces; ++i) {
            progress.waitFor(1 - me, me == 0 ? i : i + 1);
            log.push_back(me);
            progress.reached(me, i + 1);
        }
    });
    ASSERT_EQ(log.size(), 2u * kPlaces);
    for (int i = 0; i < 2 * kPlaces; ++i) ASSERT_EQ(log[i], i % 2) << i;
}

}  // namespace
}  // namespace engine
