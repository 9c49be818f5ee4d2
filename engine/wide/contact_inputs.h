/// What eight contacts and their bodies give to a batch: plain doubles, lane by lane, copied from where they lie.
#pragma once

namespace engine {

struct alignas(64) ContactInputs {
    double count[8];                    // of points; 0: an empty lane
    double anchorA[4][3][8], anchorB[4][3][8];  // m, body axes; 0 for a missing point
    double axesA[9][8], axesB[9][8];    // of the bodies, column by column
    double apart[3][8];                 // x_a - x_b, m
    double normal[3][8];
    double slideA[3][8], slideB[3][8];  // m
    double impulse[4][8];               // N s along n, of the last sub-step; 0 for a missing point
    double friction[4][3][8];           // N s on b
    double rollingMoment[3][8];         // N m s on b
    double massA[8], massB[8];          // 1/kg
    double turnA[6][8], turnB[6][8];    // I^-1, world axes: xx xy xz yy yz zz
    double mu[8], restitution[8], rolling[8];
};

}  // namespace engine
