/// run.json: a run's inputs and what it has written, so that it can be resumed.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/encode/chapters.h"

namespace demos {

struct FrameRecord {
    bool written = false;
    std::uint64_t state = 0;  // engine's state hash
    std::uint64_t png = 0;    // TextHash of the file
    std::uint64_t data = 0;   // of the files of the data passes, in their order; 0: there are none
};

struct RunRecord {
    std::uint64_t fingerprint = 0;  // of all that determines the pictures
    std::string version, renderer, scene, pattern, quality, command;
    std::string pixels;  // the class of processors that draws these bits
    std::string ffmpeg;  // its version; empty if no video was written
    std::string theme;
    std::vector<std::string> show, settings;  // overlays; KEY=VALUE of the command line
    int width = 0, height = 0, samples = 0, fps = 0, hz = 0;
    std::vector<std::string> passes;  // data passes, by name
    std::string shard;       // "003-of-016": the record of a part; empty: of a whole run
    std::uint64_t film = 0;  // TextHash of a part's film; 0: PNG frames
    std::vector<render::Chapter> chapters;  // of the whole film, in the record of a part
    int poster = 0;                         // its frame that is the poster
    std::string captions;                   // its caption track (WebVTT); empty: none
    bool finished = false;
    std::vector<FrameRecord> frames;
    std::string incident;    // of the simulation (Player::incident); empty: none
    int incidentFrame = 0;   // the first recorded frame after it

    /// Takes up what is known after a frame, or from another record of the same run.
    void addIncident(const std::string& line, int frame);
    /// The incident if it happened before this frame was drawn, else "".
    std::string incidentUntil(int frame) const;
};

std::string jsonOf(const RunRecord& record);
/// Nothing when the text is not a record.
std::optional<RunRecord> recordFromJson(const std::string& text);

}  // namespace demos
