/// The shapes of a slide of a .pptx: texts, pictures, a film, tables (ECMA-376, part 1, 19.3.1).
#pragma once
#include <string>

#include "demos/slides/measured_slide.h"
#include "demos/slides/pptx_text.h"

namespace demos {

/// An edge or a fill: a colour of the theme and how much it covers, 0 to 1.
struct PptxFill {
    const char* color = "accent1";
    double opacity = 1.0;
};

/// Writes shapes and counts their identities.
class PptxShapes {
public:
    /// `placeholder`: title, ctrTitle, or "" for a text of its own.
    void addText(const std::string& name, const SlideBox& box, const std::string& paragraphs,
                 const std::string& placeholder = "");
    void addRectangle(const SlideBox& box, const PptxFill& fill);
    /// `picture`: its relationship; `says`: its description.
    void addPicture(const std::string& name, const SlideBox& box, const std::string& picture,
                    const std::string& says);
    /// `film`, `media`: relationships of the same file. Returns the shape's identity.
    int addFilm(const SlideBox& box, const std::string& poster, const std::string& film,
                const std::string& media, const std::string& says);
    void addTable(const MadeTable& table, const MeasuredTable& measured);
    const std::string& xml() const { return xml_; }

private:
    std::string named(const std::string& name, const std::string& says, const char* inside = "");
    int next_ = 2;  // 1 is the tree's
    std::string xml_;
};

/// Starts and pauses a film by a click on it. `loop`: it starts again at its end.
std::string pptxFilmTiming(int shape, bool loop);

}  // namespace demos
