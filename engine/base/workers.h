/// The threads that share the work of a step; no other part of the engine creates threads. They split the
/// work but keep the order in which the contacts of a body are solved, so the bits are those of one thread.
/// Between calls they poll for work for some microseconds, then sleep.
#pragma once
#include <memory>

namespace engine {

class Workers {
public:
    Workers();
    ~Workers();

    /// The total, including the caller's thread; fewer if the system cannot provide them.
    void setCount(int threads);
    int count() const { return count_; }

    /// Calls work(0), ... work(count - 1), each on its own thread; returns when all are done.
    template <class Work>
    void run(const Work& work) {
        if (count_ == 1)
            work(0);
        else
            runAll([](const void* w, int i) { (*static_cast<const Work*>(w))(i); }, &work);
    }

    /// Calls work(first, end, part) for parts of [0, n), each with at least `least` items; one part if n is
    /// too small.
    template <class Work>
    void share(int n, int least, const Work& work) {
        const int parts = n / least < count_ ? (n < least ? 1 : n / least) : count_;
        if (parts == 1) {
            work(0, n, 0);
            return;
        }
        run([&](int i) {
            const auto at = [&](long long k) { return static_cast<int>(k * n / parts); };
            if (i < parts) work(at(i), at(i + 1), i);
        });
    }

private:
    struct Team;
    void runAll(void (*call)(const void*, int), const void* work);

    int count_ = 1;
    std::unique_ptr<Team> team_;
};

/// How far each thread has come in a common order, for threads that wait for its results.
class Progress {
public:
    Progress();
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void reset(int threads);
    /// Reports that thread i has finished all places before `place`.
    void reached(int i, int place);
    /// Waits until thread i has reached `place`; returns the place it has reached.
    int waitFor(int i, int place) const;

private:
    struct Places;
    std::unique_ptr<Places> places_;
};

}  // namespace engine
