// impulse completion and impulse man: the commands and options of --help, in the words of each
// shell.
#include <regex>
#include <set>
#include <sstream>

#include "tests/demos/program.h"

namespace demos::test {
namespace {

using Names = std::set<std::string>;

std::string outputOf(const std::vector<std::string>& arguments) {
    const Ended ended = run(fs::temp_directory_path(), arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(ended.err.empty()) << ended.err;
    return ended.out;
}

/// All matches of the pattern's first group.
Names found(const std::string& text, const std::string& pattern) {
    Names names;
    const std::regex expression(pattern);
    for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i)
        names.insert((*i)[1]);
    return names;
}

/// The text after `begin`, up to `end`.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t at = text.find(begin);
    if (at == std::string::npos) return {};
    const std::size_t from = at + begin.size();
    return text.substr(from, text.find(end, from) - from);
}

const Names& commands() {
    static const Names names = found(
        outputOf({"--help"}).substr(outputOf({"--help"}).find("Subcommands:")), "\n  ([a-z]+) ");
    return names;
}

/// The names of a command's options as its --help has them: "  -o,--output FILE".
Names helpedOptions(const std::string& command) {
    std::istringstream help(outputOf({command, "--help"}));
    Names names;
    for (std::string line; std::getline(help, line);)
        if (line.starts_with("  -"))
            names.merge(found(line.substr(2, line.find(' ', 2) - 2), R"((?:^|,)(--?[a-z-]+))"));
    return names;
}

struct Script {
    const char* name;
    std::vector<std::string> arguments;
    Names (*options)(const std::string& text, const std::string& command);
};
void PrintTo(const Script& script, std::ostream* out) { *out << script.name; }

Names bashOptions(const std::string& text, const std::string& command) {
    return found(between(text, "        " + command + ") words=\"", "\" ;;\n"), "(--?[a-z-]+)");
}

Names zshOptions(const std::string& text, const std::string& command) {
    return found(between(text, "        " + command + ") options=(", " ) ;;\n"), " '(--?[a-z-]+):");
}

Names fishOptions(const std::string& text, const std::string& command) {
    std::istringstream lines(text);
    Names names;
    for (std::string line; std::getline(lines, line);) {
        const std::string words =
            between(line, "'__fish_seen_subcommand_from " + command + "'", " -d ");
        if (words.empty()) continue;
        for (const std::string& name : found(words, " -l ([a-z-]+)")) names.insert("--" + name);
        for (const std::string& name : found(words, " -s ([a-z])")) names.insert("-" + name);
    }
    return names;
}

Names manualOptions(const std::string& text, const std::string& command) {
    Names names;
    const std::string part = between(text, "\n.SS " + command + "\n", "\n.SS ");
    for (std::string name : found(part, R"(\\fB((?:\\-|[a-z])+)\\fR)"))
        names.insert(std::regex_replace(name, std::regex(R"(\\-)"), "-"));
    return names;
}

class Scripts : public testing::TestWithParam<Script> {};

TEST_P(Scripts, HaveEveryCommandWithTheOptionsOfItsHelp) {
    const std::string text = outputOf(GetParam().arguments);
    EXPECT_GE(commands().size(), 20u);
    for (const std::string& command : commands())
        EXPECT_EQ(GetParam().options(text, command), helpedOptions(command)) << command;
}

INSTANTIATE_TEST_SUITE_P(Table, Scripts,
                         testing::Values(Script{"bash", {"completion", "bash"}, bashOptions},
                                         Script{"zsh", {"completion", "zsh"}, zshOptions},
                                         Script{"fish", {"completion", "fish"}, fishOptions},
                                         Script{"man", {"man"}, manualOptions}),
                         [](const testing::TestParamInfo<Script>& row) {
                             return std::string(row.param.name);
                         });

bool isInstalled(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// What this shell command says of a file with the text.
std::string complaintsOf(const std::string& command, const std::string& text) {
    const TemporaryFolder folder;
    write(folder / "text", text);
    const std::string line =
        "cd '" + folder.path().string() + "' && " + command + " text >out 2>&1";
    const int code = std::system(line.c_str());
    const std::string said = contentOf(folder / "out");
    return code == 0 || !said.empty() ? said : "it failed";
}

TEST(Completion, IsCorrectForTheShellsThatAreInstalled) {
    for (const std::string shell : {"bash", "zsh", "fish"})
        EXPECT_TRUE(!isInstalled(shell) ||
                    complaintsOf(shell + " -n", outputOf({"completion", shell})).empty())
            << shell;
}

TEST(Completion, OffersCommandsOptionsAndScenesInBash) {
    if (!isInstalled("bash")) GTEST_SKIP() << "no bash";
    const auto offered = [](const std::string& words, int at) {
        return complaintsOf("bash", outputOf({"completion", "bash"}) + "COMP_WORDS=(" + words +
                                        ")\nCOMP_CWORD=" + std::to_string(at) +
                                        "\n_impulse\necho ${COMPREPLY[@]}\n");
    };
    EXPECT_EQ(offered("impulse comp", 1), "compare completion\n");
    EXPECT_EQ(offered("impulse sim --hash", 2), "--hash --hash-every\n");
    EXPECT_EQ(offered("impulse render pendu", 2), "pendulum pendulum-wave\n");
}

TEST(Manual, IsCorrectRoff) {
    if (!isInstalled("groff")) GTEST_SKIP() << "no groff";
    EXPECT_EQ(complaintsOf("groff -man -ww -z", outputOf({"man"})), "");
}

TEST(Manual, ShowsOptionsAsTheyAreTyped) {
    if (!isInstalled("groff")) GTEST_SKIP() << "no groff";
    const std::string page = complaintsOf("groff -man -Tascii -P-cbou", outputOf({"man"}));
    for (const char* part : {"NAME\n", "--hash-every N\n", "impulse sim stack\n"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace demos::test
