/// The operations on a batch of eight contacts. One source is compiled for several instruction sets
/// (contact_kernels.cpp); all give the same bits.
#pragma once
#include "engine/settings.h"
#include "engine/wide/contact_batch.h"
#include "engine/wide/contact_inputs.h"

namespace engine {

/// The parameters of a sub-step, in single precision.
struct WideStep {
    float h = 0.0f;             // s
    float slop = 0.0f;          // m
    float baumgarte = 0.0f;     // 1 or 0: see Settings
    float nudgeFactor = 0.0f;
    float mostNudge = 0.0f;     // m
    float bounceSpeed = 0.0f;   // m/s
    float bounceByBias = 0.0f;  // 1: restitution is in b, not in solver/impacts.h
    float keep = 1.0f;          // 0: sweeps start from 0
};

/// By lane: largest |velocity correction along a row| (m/s), sum of |change of lambda| (N s).
struct alignas(64) WideSums {
    float velocity[8] = {}, impulse[8] = {};
};

struct ContactKernels {
    const char* name;
    /// Writes the frames, arms, gaps, masses and last impulses of the contacts.
    void (*fill)(const ContactInputs&, ContactBatch&, ContactRecord&);
    /// Computes K, its inverse and the friction masses from arms, normals and masses.
    void (*prepare)(ContactBatch&, const ContactRecord&, ContactSlip&);
    /// C = C0 + J (translation, rotation since then); true if some overlap is deeper than the slop.
    bool (*separate)(const ContactBatch&, ContactRecord&, const WideVelocity* motions,
                     const WideStep&);
    /// Sets b of every row from the velocities before solving; resets the bounces to 0.
    void (*setBiases)(ContactBatch&, const ContactRecord&, const WideVelocity*, const WideStep&);
    /// v += M^-1 J^T lambda
    void (*warmStart)(ContactBatch&, WideVelocity*, const WideStep&);
    /// Sweeps the batches in order: the normals of a manifold together, then its friction.
    void (*sweep)(ContactBatch*, ContactSlip*, int count, WideVelocity*, WideSums&);
    /// Adds translations and rotations that remove the share beta of every overlap; true if there
    /// was one.
    bool (*nudge)(const ContactBatch&, const ContactRecord&, WideVelocity* ways, const WideStep&);
    /// Adds the sub-step's impulses to the totals.
    void (*book)(const ContactBatch&, ContactRecord&);
    /// Writes the energy (J) that the impulses of each of the eight have brought: solver/fresh_start.h.
    void (*measure)(const ContactBatch&, const WideVelocity* changes, float* energy);
};

/// The best kernels for this processor, or the baseline if it is wanted.
const ContactKernels& contactKernels(Instructions wanted);

}  // namespace engine
