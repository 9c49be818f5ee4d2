/// What a film in parts would take, predicted from the times of some of its frames.
///
///   frame      max(simulate, (simulating simulate + draw) / workers), with a core for each worker
///   alone      start + begin + frames frame
///   in parts   start + begin + frames (simulate + (frame - simulate) / shards), that of the last part
///
/// Every part simulates the film from its beginning to the part's end, in one process or in each worker.
#pragma once

namespace demos {

struct PartForecast {
    int frames = 1, shards = 1;
    int workers = 1;        // drawing processes of each machine
    int simulating = 1;     // of them: all workers, or one for all (simulator.h)
    double start = 0.0;     // s, before the drawing processes start
    double begin = 0.0;     // s, of each of them before its first frame
    double simulate = 0.0;  // s, processor time to simulate a frame
    double draw = 0.0;      // s, to draw, compress and write it

    /// s, of one machine for a frame.
    double frame() const;
    /// Of the processor time of a frame, 0..1.
    double simulationShare() const;
    /// s, of one machine for the whole film.
    double alone() const;
    /// s, of the last part: with a machine for each of the parts, that of all.
    double inParts() const;
    double speedUp() const { return alone() / inParts(); }
    /// Processor time of all parts together, as a multiple of one run's.
    double processorRatio() const;
    /// The most parts with which a machine is worth at least half of one alone: speed-up / parts is
    /// 0.5 or more.
    int partsThatPay() const;
};

}  // namespace demos
