// demos/export/README.md agrees with the files that the program writes.
#include <gtest/gtest.h>

#include "demos/export/npz.h"
#include "demos/export/pose_table.h"
#include "tests/docs/texts.h"

namespace {

using namespace docs;

const fs::path kExportFolder = demosFolder("export");
const std::string kExportText = readmeOf(kExportFolder);

TEST(ExportReadme, ItsCommandsExist) {
    const std::set<std::string> lines = matches(kExportText, R"(\nimpulse ([a-z]+[^\n]*))");
    EXPECT_EQ(lines.size(), 3u);
    const std::string help = outputOf("export --help");
    for (const std::string& line : lines)
        for (const std::string& option : matches(line, R"( (--?[a-z-]+))"))
            EXPECT_NE(help.find(option), std::string::npos) << line;
}

TEST(ExportReadme, NamesEveryEndingAndNoOther) {
    const std::string line = outputOf("export stack -o a.usd");
    EXPECT_EQ(firstCells(kExportText.substr(0, kExportText.find("\n## "))),
              matches(line.substr(line.find("known are")), R"((\.[a-z]+))"));
}

TEST(ExportReadme, NamesEveryColumnAndNoOther) {
    EXPECT_EQ(firstCells(sectionOf(kExportText, ".csv")), matches(demos::kPoseColumns, "([a-z]+)"));
}

TEST(ExportReadme, NamesEveryArrayAndNoOther) {
    const std::vector<std::uint8_t> bytes = demos::npzOf({});
    const std::set<std::string> written =
        matches(std::string(bytes.begin(), bytes.end()), R"(([a-z_]+)\.npy)");
    EXPECT_EQ(firstCells(sectionOf(kExportText, ".npz")), written);
    EXPECT_EQ(written.size(), 15u);
}

TEST(ExportReadme, NamesEveryFileAndNoOther) {
    std::set<std::string> files;
    for (const fs::directory_entry& file : fs::directory_iterator(kExportFolder))
        if (file.path().extension() == ".h") files.insert(file.path().stem().string());
    EXPECT_EQ(firstCells(sectionOf(kExportText, "Files")), files);
}

}  // namespace
