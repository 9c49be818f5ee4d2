// impulse --licenses: the notices of all that is compiled in.
#include <gtest/gtest.h>

#include "tests/demos/program.h"

namespace demos::test {
namespace {

TEST(Licenses, NamesWhatIsBuiltInWithItsNotice) {
    const Ended result = run(fs::temp_directory_path(), {"--licenses"});
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.out.find("No licence has been chosen for impulse itself"), std::string::npos);
    for (const char* part :
         {"Inter", "DejaVu", "glad", "stb_truetype", "Eigen", "CLI11", "{fmt}", "toml++", "KaTeX",
          "TeX Gyre", "Copyright: 2013-2020 Khan Academy", "2013-2022 David Herberth",
          "by Bitstream, Inc."})
        EXPECT_NE(result.out.find(part), std::string::npos) << part;
}

TEST(Licenses, TheOptionIsInHelpManualAndCompletion) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"--help"}, {"man"}, {"completion", "bash"}})
        EXPECT_NE(run(fs::temp_directory_path(), words).out.find("licenses"), std::string::npos) << words.front();
}

}  // namespace
}  // namespace demos::test
