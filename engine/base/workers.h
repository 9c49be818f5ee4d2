/// Threads that share the work of a step: the only place of the engine that knows of any. They split
/// what is done, never the order in which the contacts of a body are solved, so that the bits are those
/// of one thread. Between calls they look out for work for some microseconds, then sleep.
#pragma once
#include <memory>

namespace engine {

class Workers {
public:
    Workers();
    ~Workers();

    /// In all, the caller's included; fewer if the system does not give as many.
    void setCount(int threads);
    int count() const { return count_; }

    /// work(0), ... work(count - 1), each on a thread of its own; comes back when all are done.
    template <class Work>
    void run(const Work& work) {
        if (count_ == 1)
            work(0);
        else
            runAll([](const void* w, int i) { (*static_cast<const Work*>(w))(i); }, &work);
    }

    /// work(first, end, part) for parts of [0, n); in one piece if that is less than `least` a thread.
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

/// How far one thread has come in a common order, for others that wait for what it does.
class Progress {
public:
    Progress();
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void reset(int threads);
    /// All places of thread i before `place` are done.
    void reached(int i, int place);
    /// Comes back when thread i has reached `place`, with the place that it has reached.
    int waitFor(int i, int place) const;

private:
    struct Places;
    std::unique_ptr<Places> places_;
};

}  // namespace engine
