/// What is done to a batch of eight contacts, in one text that is compiled for several instruction
/// sets (contact_kernels.cpp). All of them give the same bits.
#pragma once
#include "engine/settings.h"
#include "engine/wide/contact_batch.h"

namespace engine {

/// The numbers of a sub-step, in single precision.
struct WideStep {
    float h = 0.0f;             // s
    float slop = 0.0f;          // m
    float baumgarte = 0.0f;     // 1 or 0: see Settings
    float nudgeFactor = 0.0f;
    float mostNudge = 0.0f;     // m
    float bounceSpeed = 0.0f;   // m/s
    float bounceByBias = 0.0f;  // 1: restitution goes to b, not to solver/impacts.h
    float keep = 1.0f;          // 0: sweeps start from nothing
};

/// Of every lane: largest |velocity correction along a row| (m/s), sum of |change of lambda| (N s).
struct alignas(64) WideSums {
    float velocity[8] = {}, impulse[8] = {};
};

struct ContactKernels {
    const char* name;
    /// K, its inverse and the friction masses, of arms, normals and masses.
    void (*prepare)(ContactBatch&, const ContactRecord&);
    /// C = C0 + J (way, turn since then); true: some overlap is deeper than the slop.
    bool (*separate)(const ContactBatch&, ContactRecord&, const WideVelocity* motions,
                     const WideStep&);
    /// b of every row, of the velocities before solving; and 0 for the bounces.
    void (*setBiases)(ContactBatch&, ContactRecord&, const WideVelocity*, const WideStep&);
    /// v += M^-1 J^T lambda
    void (*warmStart)(ContactBatch&, WideVelocity*, const WideStep&);
    /// One batch after the other: the normals of a manifold together, then its friction.
    void (*sweep)(ContactBatch*, int count, WideVelocity*, WideSums&);
    /// Ways and turns that take the share beta of every overlap away; true: there was one.
    bool (*nudge)(const ContactBatch&, const ContactRecord&, WideVelocity* ways, const WideStep&);
    /// Adds the sub-step's impulses to the totals.
    void (*book)(const ContactBatch&, ContactRecord&);
};

/// The best this processor has, or what the settings ask for (as far as it exists).
const ContactKernels& contactKernels(Instructions wanted);

}  // namespace engine
