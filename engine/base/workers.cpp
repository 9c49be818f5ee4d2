#include "engine/base/workers.h"

#include <atomic>
#include <cstdint>
#include <system_error>
#include <thread>
#include <vector>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace engine {
namespace {

// How often a thread polls before it yields the processor (there may be fewer processors than
// threads, so the thread it waits for may need this one's processor), and before it sleeps.
constexpr int kBeforeYielding = 100, kBeforeSleeping = 1000;
constexpr int kLine = 64;        // bytes: threads write to separate cache lines

void breathe() {
#if defined(__SSE2__)
    _mm_pause();
#endif
}

template <class Seen>
bool lookFor(const Seen& seen, int most) {
    for (int looks = 0; looks < most; ++looks) {
        if (seen()) return true;
        if (looks < kBeforeYielding)
            breathe();
        else
            std::this_thread::yield();
    }
    return false;
}

template <class Seen>
void lookUntil(const Seen& seen) {
    while (!lookFor(seen, 1 << 20)) {
    }
}

}  // namespace

struct Workers::Team {
    alignas(kLine) std::atomic<std::uint32_t> call{0};  // counts the calls of run()
    alignas(kLine) std::atomic<int> working{0};
    void (*work)(const void*, int) = nullptr;
    const void* context = nullptr;
    bool over = false;
    std::vector<std::thread> threads;

    void waitForWork(int i) {
        for (std::uint32_t known = 0;; ++known) {
            lookFor([&] { return call.load(std::memory_order_acquire) != known; }, kBeforeSleeping);
            call.wait(known, std::memory_order_acquire);
            if (over) return;
            work(context, i);
            working.fetch_sub(1, std::memory_order_release);
        }
    }

    void begin() {
        working.store(static_cast<int>(threads.size()), std::memory_order_relaxed);
        call.fetch_add(1, std::memory_order_release);
        call.notify_all();
    }
};

Workers::Workers() = default;
Workers::~Workers() { setCount(1); }

void Workers::setCount(int threads) {
    if (threads == count_) return;
    if (team_) {
        team_->over = true;
        team_->begin();
        for (std::thread& thread : team_->threads) thread.join();
        team_.reset();
    }
    count_ = 1;
    if (threads <= 1) return;
    team_ = std::make_unique<Team>();
    try {
        for (; count_ < threads; ++count_)
            team_->threads.emplace_back(
                [team = team_.get(), i = count_] { team->waitForWork(i); });
    } catch (const std::system_error&) {
        // The system provides no more threads: continue with those started so far.
    }
}

void Workers::runAll(void (*call)(const void*, int), const void* work) {
    team_->work = call, team_->context = work;
    team_->begin();
    call(work, 0);
    lookUntil([&] { return team_->working.load(std::memory_order_acquire) == 0; });
}

struct Progress::Places {
    struct alignas(kLine) Place {
        std::atomic<int> reached{0};
    };
    std::vector<Place> of;
    explicit Places(int threads) : of(threads) {}
};

Progress::Progress() = default;
Progress::~Progress() = default;

void Progress::reset(int threads) {
    if (!places_ || static_cast<int>(places_->of.size()) < threads)
        places_ = std::make_unique<Places>(threads);
    for (Places::Place& place : places_->of) place.reached.store(0, std::memory_order_relaxed);
}

void Progress::reached(int i, int place) {
    places_->of[i].reached.store(place, std::memory_order_release);
}

int Progress::waitFor(int i, int place) const {
    int now = 0;
    lookUntil([&] {
        now = places_->of[i].reached.load(std::memory_order_acquire);
        return now >= place;
    });
    return now;
}

}  // namespace engine
