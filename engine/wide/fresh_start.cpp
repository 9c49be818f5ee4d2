// solver/fresh_start.h and joined_start.h, in lanes: the velocities of a group without joints are what its
// impulses changed.
#include "engine/wide/wide_contacts.h"

namespace engine {
namespace {

void forget(ContactBatch& c, int lane) {
    for (WidePoint& point : c.point)
        point.lambda[lane] = point.friction[0][lane] = point.friction[1][lane] = 0.0f;
    c.roll.moment[0][lane] = c.roll.moment[1][lane] = 0.0f;
}

}  // namespace

template <class What>
void WideContacts::eachLane(int group, const What& what) {
    for (int k = firstBatch_[group]; k < firstBatch_[group + 1]; ++k)
        for (int lane = 0; lane < 8; ++lane) {
            const int contact = records_[k].contact[lane];
            if (contact >= 0) what(k, lane, groups_->islandOf(contact));
        }
}

void WideContacts::addBrought(int group, std::span<double> brought) {
    float energy[8];
    int measured = -1;
    eachLane(group, [&](int k, int lane, int island) {
        if (measured != k) kernels_->measure(batches_[k], now_.data(), energy);
        measured = k;
        brought[island] += static_cast<double>(energy[lane]);
    });
}

bool WideContacts::takeBack(int group) {
    eachLane(group, [&](int, int, int island) { brought_[island] = 0.0; });
    addBrought(group, brought_);
    bool any = false;
    eachLane(group, [&](int k, int lane, int island) {
        if (!(brought_[island] > 0.0)) return;
        any = true;
        ContactBatch& c = batches_[k];
        forget(c, lane);
        now_[c.a[lane]] = now_[c.b[lane]] = {};
    });
    return any;
}

void WideContacts::withdraw(int group, std::span<const double> brought) {
    WideStep step = step_;
    step.keep = -1.0f;
    for (int k = firstBatch_[group]; k < firstBatch_[group + 1]; ++k) {
        ContactBatch taken = batches_[k];
        for (int lane = 0; lane < 8; ++lane) {
            const int contact = records_[k].contact[lane];
            const bool bad = contact >= 0 && brought[groups_->islandOf(contact)] > 0.0;
            forget(bad ? batches_[k] : taken, lane);
        }
        kernels_->warmStart(taken, now_.data(), step);
    }
}

}  // namespace engine
