/// The figures of compare and sweep: pictures of the runs at one moment, a separate chart, and the
/// captions.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "demos/figure/caption.h"
#include "demos/figure/panel_figure.h"
#include "demos/film/progress.h"

namespace demos {

struct RunsFigureSettings {
    std::vector<Variant> runs;      // all of them
    std::vector<Variant> pictured;  // empty = no pictures
    int columns = 0;                // of the pictures; 0 = as many as there is room for
    bool chart = false;             // below the pictures
    std::string title;              // without a full stop
    std::string picture;            // the pictures' file without --output
};

/// Throws Stop (usage) for options of a figure if there is none. `pictured`: there are pictures if
/// there is a width; otherwise `remedy` says how to get them.
void checkFigureOptions(const RunsOptions& options, bool pictured, const char* remedy);

class RunsFigure {
public:
    /// Throws Stop and render::Error for what cannot be made or written.
    RunsFigure(RunsFigureSettings settings, const RunsOptions& options);

    /// `below`: charts under the pictures; `alone`: those of --plot.
    void write(const std::vector<Chart>& below, const std::vector<Chart>& alone,
               const Talk& talk) const;

private:
    void writePictures(const std::vector<Chart>& charts, const Talk& talk) const;
    void writeChart(const std::vector<Chart>& charts, const Talk& talk) const;
    std::string runsText() const;
    void addShared(Caption& caption) const;
    void addRuns(const std::vector<Variant>& runs, const DrawnPanels* drawn,
                 Caption& caption) const;

    RunsFigureSettings settings_;
    RunsOptions options_, chartOptions_;
    std::optional<PanelFigure> panels_;
    std::string target_;  // of the pictures; empty = none
};

}  // namespace demos
