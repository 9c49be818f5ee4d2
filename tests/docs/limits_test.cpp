// "What files may contain" in demos/README.md has the limits of the readers' code.
#include <gtest/gtest.h>

#include "demos/formulas/caption_text.h"
#include "demos/formulas/formula.h"
#include "demos/formulas/formula_layout.h"
#include "demos/mjcf/xml_tree.h"
#include "demos/regression/baseline.h"
#include "demos/scene/expression.h"
#include "demos/scene/include.h"
#include "demos/scene/mesh_file.h"
#include "demos/scene/repeat.h"
#include "demos/scene/toml_limits.h"
#include "demos/slides/check_words.h"
#include "demos/slides/read_deck.h"
#include "demos/text/json_limits.h"
#include "engine/collision/contacts.h"
#include "render/encode/png.h"
#include "tests/docs/texts.h"

namespace demos {
namespace {

using namespace docs;

const std::string kLimits = sectionOf(readmeOf(demosFolder("")), "What files may contain");

std::string mebibytes(std::uintmax_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

/// A row's cells between its name and the last; "none" if there is no such row.
std::string cellsOf(const std::string& reader) {
    const std::string begin = "\n| " + reader + " | ";
    const std::size_t at = kLimits.find(begin);
    if (at == std::string::npos) return "none";
    const std::string row = kLimits.substr(at + begin.size());
    return row.substr(0, row.rfind(" | ", row.find('\n')));
}

std::string text(auto number) { return std::to_string(number); }

TEST(Limits, OfTomlAndItsTexts) {
    EXPECT_EQ(kDeepestInclude, 8u);
    EXPECT_EQ(cellsOf("scene"), mebibytes(kMostSceneBytes) + " in all its files | " +
                                    text(kDeepestNesting) + " | " + text(kMostTomlValues) +
                                    " values, " + text(kMostSceneFiles) + " files, " +
                                    text(kDeepestInclude) + " includes deep");
    EXPECT_EQ(cellsOf("deck"), mebibytes(kMostSceneBytes) + " | " + text(kDeepestNesting) + " | " +
                                   text(kMostTomlValues) + " values, " + text(kMostSlides) +
                                   " slides, " + text(kMostDollars) + " $ around formulas");
    EXPECT_EQ(cellsOf("words"), text(kMostWords >> 10) + " KiB | - | -");
    EXPECT_EQ(cellsOf("formula"), text(kLongestFormula) + " | - | in captions " + text(render::kMostFormulas) + ", with relations, of " +
                  text(kMostFormulaLetters) + " letters each; " + text(kMostCaptionFormulas) + " in a scene");
    EXPECT_EQ(cellsOf("expression"), text(kLongestExpression) + " | - | " + text(kMostEvaluated) +
                                         " evaluated in a scene");
}

TEST(Limits, OfModelsAndMeshes) {
    EXPECT_EQ(cellsOf("MJCF"), mebibytes(mjcf::kMostModelBytes) + " a file, " +
                                   mebibytes(mjcf::kMostModelBytesInAll) + " in all | " +
                                   text(mjcf::kDeepestElement) + " | " + text(mjcf::kMostElements) +
                                   " elements of " + text(mjcf::kMostAttributes) + " attributes, " +
                                   text(mjcf::kMostModelFiles) + " files");
    EXPECT_EQ(cellsOf("STL"), mebibytes(mjcf::kMostModelBytes) + " | - | -");
    EXPECT_EQ(cellsOf("OBJ"), mebibytes(kMostMeshBytes) + " | - | " + text(kMostTriangles) +
                                  " triangles, " + text(kMostMeshCorners) + " corners");
    EXPECT_EQ(cellsOf("glTF, .glb"), mebibytes(kMostMeshBytes) + ", " + mebibytes(kMostMeshBytes) +
                                         " of buffers | " + text(kMostJsonDepth) + " | " +
                                         text(kGltfJson.values) + " values, " +
                                         text(kMostTriangles) + " triangles");
}

TEST(Limits, OfFilesThatTheProgramWrites) {
    EXPECT_EQ(cellsOf("PNG"), mebibytes(kMostPictureBytes) + " | - | " +
                                  text(render::kLargestSide) + " pixels a side");
    const std::pair<const char*, JsonLimits> files[] = {
        {"run.json", kRunJson},           {"report.json", kReportJson},
        {"baseline.json", kBaselineJson}, {"gallery.json", kGalleryJson},
        {"sections.json", kSectionsJson}, {"passed.json", kPassedJson}};
    for (const auto& [name, limits] : files)
        EXPECT_EQ(cellsOf(name), mebibytes(limits.bytes) + " | " + text(kMostJsonDepth) + " | " +
                                     text(limits.values) + " values")
            << name;
    EXPECT_EQ(cellsOf("`bench --against`"), mebibytes(kBenchJson.bytes) + " | " +
                                                text(kMostJsonDepth) + " | " +
                                                text(kBenchJson.values) + " values a line");
}

TEST(Limits, OfAScene) {
    for (const std::string& limit :
         {text(kMostUnrolledValues) + " values", mebibytes(kMostShapeBytes) + " of files",
          text(kMostParts) + " solids", text(kMostBodies) + " bodies",
          text(kMostJoints) + " joints", text(kMostForces) + " forces",
          text(kMostExpectations) + " expectations", text(engine::kMostContacts) + " contacts",
          text(engine::kMostContactsOfPair) + " between two", text(engine::kMostPiecePairs) + " pairs",
          text(kMostTrianglesInAll) + " triangles", "one of " + text(kMostAttracting)})
        EXPECT_NE(kLimits.find(limit), std::string::npos) << limit << kLimits;
}

}  // namespace
}  // namespace demos
