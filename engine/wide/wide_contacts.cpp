#include "engine/wide/wide_contacts.h"

#include <atomic>
#include <cstring>
#include <utility>

#include "engine/dynamics/rotation.h"

namespace engine {
namespace {

void set3(double (&x)[3][8], int lane, const Vec3& v) {
    for (int i = 0; i < 3; ++i) x[i][lane] = v[i];
}
/// The upper triangle of a symmetric matrix.
template <class Number>
void set6(Number (&x)[6][8], int lane, const Mat3& m) {
    constexpr int kRow[6] = {0, 0, 0, 1, 1, 2}, kColumn[6] = {0, 1, 2, 1, 2, 2};
    for (int i = 0; i < 6; ++i) x[i][lane] = static_cast<Number>(m(kRow[i], kColumn[i]));
}
void set3(float (&x)[4], const Vec3& v) {
    for (int i = 0; i < 3; ++i) x[i] = static_cast<float>(v[i]);
}
Vec3 get3(const float (&x)[3][8], int lane) {
    return Eigen::Vector3f(x[0][lane], x[1][lane], x[2][lane]).cast<double>();
}

/// Slots are separated, so that two threads never write to one cache line.
int wasteOf(int bodies, int half) { return bodies + 4 * (half + 1); }

/// In place: to copy four floats at once after three have been written one by one makes a processor wait.
void narrow(const Velocity& v, WideVelocity& w) { set3(w.linear, v.linear), set3(w.angular, v.angular); }

/// The contacts of a batch lie anywhere in the list: while one is read, the next is on its way to the cache.
void fetchAhead(const Contact& contact) {
    constexpr std::size_t kCacheLine = 64;
    const auto* bytes = reinterpret_cast<const char*>(&contact);
    for (std::size_t at = 0; at < sizeof(Contact); at += kCacheLine) __builtin_prefetch(bytes + at);
}

void addContact(const Contact& contact, int lane, ContactInputs& inputs) {
    static const ContactPoint none;
    inputs.count[lane] = contact.count;
    for (int i = 0; i < Contact::kMaxPoints; ++i) {
        const ContactPoint& point = i < contact.count ? contact.points[i] : none;
        set3(inputs.anchorA[i], lane, point.anchorA), set3(inputs.anchorB[i], lane, point.anchorB);
        inputs.impulse[i][lane] = point.impulse;
        set3(inputs.friction[i], lane, point.friction);
    }
    set3(inputs.normal, lane, contact.normal);
    set3(inputs.slideA, lane, contact.slideA), set3(inputs.slideB, lane, contact.slideB);
    set3(inputs.rollingMoment, lane, contact.rollingMoment);
    inputs.mu[lane] = contact.friction, inputs.rolling[lane] = contact.rolling;
    inputs.restitution[lane] = contact.restitution;
}

void addBodies(const Bodies& bodies, const Contact& contact, std::span<const Mat3> axes, int lane,
               ContactInputs& inputs) {
    set3(inputs.apart, lane, bodies.poses[contact.a].position - bodies.poses[contact.b].position);
    const InverseMass &a = bodies.inverseMasses[contact.a], &b = bodies.inverseMasses[contact.b];
    inputs.massA[lane] = a.linear, inputs.massB[lane] = b.linear;
    set6(inputs.turnA, lane, a.angular), set6(inputs.turnB, lane, b.angular);
    for (int i = 0; i < 9; ++i) {
        inputs.axesA[i][lane] = axes[contact.a].data()[i];
        inputs.axesB[i][lane] = axes[contact.b].data()[i];
    }
}

/// Bodies that do not move, without a point.
void leaveEmpty(int lane, ContactInputs& inputs) {
    static const Contact none;
    addContact(none, lane, inputs);
    set3(inputs.apart, lane, Vec3::Zero());
    inputs.massA[lane] = inputs.massB[lane] = 0.0;
    set6(inputs.turnA, lane, Mat3::Zero()), set6(inputs.turnB, lane, Mat3::Zero());
    for (int i = 0; i < 9; ++i) inputs.axesA[i][lane] = inputs.axesB[i][lane] = 0.0;
}

/// Copies the data of one lane; the other lanes keep every bit.
template <class Batch>
void copyLane(const Batch& from, int lane, Batch& to) {
    constexpr std::size_t kLane = sizeof(float), kRow = 8 * kLane;
    static_assert(sizeof(Batch) % kRow == 0, "rows of eight, and nothing between them");
    const auto* source = reinterpret_cast<const char*>(&from) + kLane * lane;
    auto* target = reinterpret_cast<char*>(&to) + kLane * lane;
    for (std::size_t at = 0; at < sizeof(Batch); at += kRow)
        std::memcpy(target + at, source + at, kLane);
}

}  // namespace

template <class Work>
void WideContacts::eachBatch(const Work& work) {
    constexpr int kLeast = 32;  // batches per thread
    workers_->share(static_cast<int>(batches_.size()), kLeast, [&](int first, int end, int) {
        for (int k = first; k < end; ++k)
            if (batchSpans_[k] > 0.0f) work(k);
    });
}

template <class Work>
void WideContacts::eachBody(const Work& work) {
    constexpr int kLeast = 512;  // bodies per thread
    workers_->share(static_cast<int>(active_.size()), kLeast, [&](int first, int end, int) {
        for (int k = first; k < end; ++k) work(active_[k]);
    });
}

void WideContacts::prepare(std::span<const Contact> contacts, std::span<const int> order,
                           const ContactGroups& groups, const Bodies& bodies,
                           const Settings& settings, Workers& workers) {
    kernels_ = &contactKernels(settings.instructions);
    workers_ = &workers;
    groups_ = &groups;
    arrange(contacts, order, bodies);
    prepareBodies(bodies);
    const int count = static_cast<int>(schedule_.batches().size());
    batches_.resize(count), records_.resize(count), slips_.resize(count);
    place_.resize(contacts.size());
    batchSpans_.assign(count, 1.0f);  // all are filled
    eachBatch([&](int k) { fillBatch(k, contacts, bodies); });
}

void WideContacts::prepareBodies(const Bodies& bodies) {
    active_ = bodies.active;
    const std::size_t count = bodies.poses.size(), slots = wasteOf(bodies.count(), 2);
    start_.resize(count), axes_.resize(count), turned_.resize(count), farTurn_.resize(count);
    atStart_.resize(count), brought_.resize(count);
    for (std::vector<WideVelocity>* v : {&now_, &before_, &motions_, &ways_})
        if (v->size() != slots) v->assign(slots, {});  // other slots are waste now
    for (const int i : active_) {
        start_[i] = bodies.poses[i];
        axes_[i] = start_[i].rotation.toRotationMatrix();
        turned_[i] = 0;
        farTurn_[i] = kFarTurn;
        motions_[i] = {};
    }
    for (const int i : groups_->jointedBodies()) farTurn_[i] = kFarTurnOfJointed;
    anyTurned_ = false;
}

void WideContacts::arrange(std::span<const Contact> contacts, std::span<const int> order,
                           const Bodies& bodies) {
    const auto moved = [&](int body) { return bodies.isDynamic(body) ? body : -1; };
    pairs_.clear();
    for (const Contact& c : contacts) pairs_.push_back({moved(c.a), moved(c.b)});
    if (static_cast<int>(orders_.size()) < groups_->count()) orders_.resize(groups_->count());
    for (std::vector<int>& list : orders_) list.clear();
    for (const int contact : order) orders_[groups_->of(contact)].push_back(contact);
    schedule_.begin(bodies.count());
    firstBatch_.assign(1, 0);
    middle_.clear();
    const auto batches = [&] { return static_cast<int>(schedule_.batches().size()); };
    for (int g = 0; g < groups_->count(); ++g) {
        const std::span<const int> all = orders_[g];
        const std::size_t upper = groups_->hasJoints(g) ? all.size() : Overlap::sizeOfUpperHalf(all.size());
        schedule_.add(pairs_, all.first(upper));
        middle_.push_back(batches());
        schedule_.add(pairs_, all.subspan(upper));
        firstBatch_.push_back(batches());
    }
    overlap_.find(schedule_.batches(), pairs_, firstBatch_, middle_, bodies.count());
}

void WideContacts::fillBatch(int batch, std::span<const Contact> contacts, const Bodies& bodies) {
    const std::array<int, 8>& lanes = schedule_.batches()[batch];
    ContactBatch& c = batches_[batch];
    ContactRecord& record = records_[batch];
    const int zeros = static_cast<int>(start_.size()), waste = wasteOf(bodies.count(), overlap_.halfOf(batch));
    ContactInputs inputs;
    for (int lane = 0; lane < 8; ++lane) {
        const int number = record.contact[lane] = lanes[lane];
        if (lane < 7 && lanes[lane + 1] >= 0) fetchAhead(contacts[lanes[lane + 1]]);
        if (number < 0) {
            c.a[lane] = c.b[lane] = zeros;
            c.writeA[lane] = c.writeB[lane] = waste;
            leaveEmpty(lane, inputs);
            continue;
        }
        place_[number] = 8 * batch + lane;
        const Contact& contact = contacts[number];
        c.a[lane] = contact.a, c.b[lane] = contact.b;
        c.writeA[lane] = pairs_[number].a >= 0 ? contact.a : waste;
        c.writeB[lane] = pairs_[number].b >= 0 ? contact.b : waste;
        addContact(contact, lane, inputs);
        addBodies(bodies, contact, axes_, lane, inputs);
    }
    kernels_->fill(inputs, c, record);
    kernels_->prepare(c, record, slips_[batch]);
}

void WideContacts::beginSubstep(const Bodies& bodies) {
    spans_.assign(groups_->count(), 0.0);
    for (int g = 0; g < groups_->count(); ++g) {
        if (orders_[g].empty()) continue;  // joints only
        const int k = orders_[g].front(), batch = place_[k] / 8, lane = place_[k] % 8;
        const ContactBatch& c = batches_[batch];
        const int body = bodies.movable(c.a[lane], c.b[lane]);
        if (bodies.acts[body]) spans_[g] = bodies.spans[body];
        std::fill(batchSpans_.begin() + firstBatch_[g], batchSpans_.begin() + firstBatch_[g + 1],
                  static_cast<float>(spans_[g]));
    }
}

void WideContacts::begin(std::span<const Velocity> v, const Settings& settings) {
    if (empty()) return;
    step_.slop = static_cast<float>(settings.slop);
    step_.baumgarte = static_cast<float>(settings.baumgarte);
    step_.bounceSpeed = static_cast<float>(settings.bounceSpeed);
    step_.bounceByBias = settings.bounce == Bounce::bias ? 1.0f : 0.0f;
    step_.keep = settings.warmStart ? 1.0f : 0.0f;
    eachBody([&](int i) {
        atStart_[i] = v[i];
        narrow(v[i], now_[i]);
    });
    eachBatch([&](int k) {
        WideStep step = step_;
        step.h = batchSpans_[k];
        kernels_->setBiases(batches_[k], records_[k], now_.data(), step);
    });
    eachBody([&](int i) { now_[i] = before_[i] = {}; });
}

void WideContacts::setBounce(int contact, int i, double impulse, double ahead) {
    const int batch = place_[contact] / 8, lane = place_[contact] % 8;
    WidePoint& point = batches_[batch].point[i];
    point.bounce[lane] = static_cast<float>(impulse);
    const float gap = records_[batch].separation[i][lane];
    point.bias[lane] +=
        (larger(gap + static_cast<float>(ahead), 0.0f) - larger(gap, 0.0f)) / batchSpans_[batch];
}

void WideContacts::setLead(int contact, const Vec3& lead, const Vec3& turn) {
    const int batch = place_[contact] / 8, lane = place_[contact] % 8;
    ContactBatch& c = batches_[batch];
    c.slip[0][lane] -= static_cast<float>(get3(c.t1, lane).dot(lead));
    c.slip[1][lane] -= static_cast<float>(get3(c.t2, lane).dot(lead));
    const auto angle = static_cast<float>(get3(c.n, lane).dot(turn));
    for (WidePoint& point : c.point) {
        const float f1 = point.friction[0][lane], f2 = point.friction[1][lane];
        point.friction[0][lane] = f1 - angle * f2, point.friction[1][lane] = f2 + angle * f1;
    }
}

void WideContacts::warmStart(int group) {
    for (int k = firstBatch_[group]; k < firstBatch_[group + 1]; ++k)
        kernels_->warmStart(batches_[k], now_.data(), step_);
}

SweepReport WideContacts::sweepBatches(int first, int end) {
    WideSums sums;
    kernels_->sweep(batches_.data() + first, slips_.data() + first, end - first, now_.data(), sums);
    return reportOf(sums);
}

SweepReport WideContacts::sweep(int group) {
    return sweepBatches(firstBatch_[group], firstBatch_[group + 1]);
}

void WideContacts::take(std::span<const Velocity> v, std::span<const int> bodies) {
    for (const int i : bodies) {
        const Velocity change{v[i].linear - atStart_[i].linear, v[i].angular - atStart_[i].angular};
        narrow(change, now_[i]), narrow(change, before_[i]);
    }
}

void WideContacts::give(Velocity& v, int body) {
    const WideVelocity &now = now_[body], &before = before_[body];
    for (int k = 0; k < 3; ++k) {
        v.linear[k] += static_cast<double>(now.linear[k] - before.linear[k]);
        v.angular[k] += static_cast<double>(now.angular[k] - before.angular[k]);
    }
    before_[body] = now;
}

void WideContacts::give(std::span<Velocity> v, std::span<const int> bodies) {
    for (const int i : bodies) give(v[i], i);
}

void WideContacts::finish(std::span<Velocity> v) {
    if (empty()) return;
    eachBody([&](int i) { give(v[i], i); });
    eachBatch([&](int k) { kernels_->book(batches_[k], records_[k]); });
}

void WideContacts::measureMotion(const Bodies& bodies, int i) {
    const Pose &now = bodies.poses[i], &start = start_[i];
    const Vec3 turn = turnBetween(start, now);
    narrow({now.position - start.position, turn}, motions_[i]);
    turned_[i] = bodies.isDynamic(i) && !bodies.masses[i].isRound &&
                 turn.squaredNorm() > farTurn_[i] * farTurn_[i];
}

template <class Measure>
bool WideContacts::separate(double slop, const Measure& measure) {
    if (empty()) return false;
    std::atomic<bool> turned{false};
    eachBody([&](int i) {
        measure(i);
        if (turned_[i]) turned.store(true, std::memory_order_relaxed);
    });
    anyTurned_ = turned;
    step_.slop = static_cast<float>(slop);
    std::atomic<bool> deep{false};
    eachBatch([&](int k) {
        if (kernels_->separate(batches_[k], records_[k], motions_.data(), step_))
            deep.store(true, std::memory_order_relaxed);
    });
    return deep;
}

bool WideContacts::separate(const Bodies& bodies, double slop) {
    return separate(slop, [&](int i) {
        if (bodies.isGoing(i)) measureMotion(bodies, i);
    });
}

bool WideContacts::separateAll(const Bodies& bodies, double slop) {
    return separate(slop, [&](int i) { measureMotion(bodies, i); });
}

void WideContacts::followTurns(const Bodies& bodies) {
    if (empty() || !anyTurned_) return;
    eachBatch([&](int k) {
        ContactBatch& c = batches_[k];
        ContactBatch made = c;
        bool any = false;
        for (int lane = 0; lane < 8; ++lane) {
            if (!hasTurned(k, lane)) continue;
            set6(made.turnA, lane, bodies.inverseMasses[c.a[lane]].angular);
            set6(made.turnB, lane, bodies.inverseMasses[c.b[lane]].angular);
            any = true;
        }
        if (!any) return;
        ContactSlip slips = slips_[k];
        kernels_->prepare(made, records_[k], slips);
        for (int lane = 0; lane < 8; ++lane)
            if (hasTurned(k, lane)) copyLane(made, lane, c), copyLane(slips, lane, slips_[k]);
    });
}

bool WideContacts::hasTurned(int batch, int lane) const {
    const ContactBatch& c = batches_[batch];
    return records_[batch].contact[lane] >= 0 && (turned_[c.a[lane]] || turned_[c.b[lane]]);
}

std::span<const WideVelocity> WideContacts::nudge(const Settings& settings, double most) {
    step_.nudgeFactor = static_cast<float>(settings.nudgeFactor);
    const double speed = settings.depenetrationSpeed / settings.nudges;
    eachBody([&](int i) { ways_[i] = {}; });
    for (int g = 0; g < groups_->count(); ++g) {
        step_.mostNudge = static_cast<float>(smaller(most, speed * spans_[g]));
        for (int k = firstBatch_[g]; acts(g) && k < firstBatch_[g + 1]; ++k)
            kernels_->nudge(batches_[k], records_[k], ways_.data(), step_);
    }
    return ways_;
}

PointImpulses WideContacts::impulses(int contact, int i) const {
    const int batch = place_[contact] / 8, lane = place_[contact] % 8;
    const ContactBatch& c = batches_[batch];
    const ContactRecord& record = records_[batch];
    const WidePoint& point = c.point[i];
    const Vec3 t1 = get3(c.t1, lane), t2 = get3(c.t2, lane);
    PointImpulses got;
    got.normal = static_cast<double>(point.lambda[lane]);
    got.total = static_cast<double>(record.total[i][lane]);
    got.friction = static_cast<double>(point.friction[0][lane]) * t1 +
                   static_cast<double>(point.friction[1][lane]) * t2;
    got.totalFriction = static_cast<double>(record.totalFriction[i][0][lane]) * t1 +
                        static_cast<double>(record.totalFriction[i][1][lane]) * t2;
    return got;
}

Vec3 WideContacts::normalOf(int contact) const { return get3(batches_[place_[contact] / 8].n, place_[contact] % 8); }

void WideContacts::store(std::span<Contact> contacts) const {
    constexpr int kLeast = 256;  // contacts per thread
    workers_->share(static_cast<int>(contacts.size()), kLeast, [&](int first, int end, int) {
        for (int k = first; k < end; ++k) store(k, contacts[k]);
    });
}

void WideContacts::store(int k, Contact& contact) const {
    const int lane = place_[k] % 8;
    const ContactBatch& c = batches_[place_[k] / 8];
    const Vec3 t1 = get3(c.t1, lane), t2 = get3(c.t2, lane);
    contact.rollingMoment = static_cast<double>(c.roll.moment[0][lane]) * t1 +
                            static_cast<double>(c.roll.moment[1][lane]) * t2;
    for (int i = 0; i < contact.count; ++i) {
        const WidePoint& point = c.point[i];
        contact.points[i].impulse = static_cast<double>(point.lambda[lane]);
        contact.points[i].friction = static_cast<double>(point.friction[0][lane]) * t1 +
                                     static_cast<double>(point.friction[1][lane]) * t2;
    }
}

}  // namespace engine
