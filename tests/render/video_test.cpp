#include "render/encode/video.h"
#include "render/encode/ffmpeg.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "render/error.h"
#include "tests/render/film_bytes.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using render::VideoWriter;

/// A grey picture in which a white square moves one pixel per frame.
render::Image frame(int width, int height, int number) {
    render::Image image{width, height, {}};
    image.pixels.assign(std::size_t{4} * width * height, 90);
    for (int y = 10; y < 20; ++y) std::fill_n(image.at(number, y), 40, std::uint8_t{255});
    return image;
}

void addFrames(VideoWriter& film, int frames, int width = 64, int height = 48) {
    for (int i = 0; i < frames; ++i) film.add(frame(width, height, i));
}

/// The message of the Error that `work` throws; empty if it throws none.
template <class Work>
std::string errorOf(const Work& work) {
    try {
        work();
    } catch (const render::Error& error) {
        return error.what();
    }
    return "";
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Every test has its own folder; PATH is restored afterwards.
class Video : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directory(folder_ / "out");
        if (const char* path = std::getenv("PATH")) path_ = path;
    }
    void TearDown() override { ::setenv("PATH", path_.c_str(), 1); }
    fs::path out(const char* name) const { return folder_ / "out" / name; }
    std::ptrdiff_t filesLeft() const {
        return std::distance(fs::directory_iterator(folder_ / "out"), fs::directory_iterator());
    }
    /// Puts a script named ffmpeg first on the PATH that misbehaves in a known way.
    void replaceFfmpeg(const char* script) {
        std::ofstream(folder_ / "ffmpeg") << "#!/bin/sh\n" << script << "\n";
        ::chmod((folder_ / "ffmpeg").c_str(), 0755);
        ::setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
    }

    support::TemporaryFolder folder_;
    std::string path_;
};

/// What ffprobe says of a film's first stream.
std::string probed(const fs::path& path, const std::string& options) {
    const std::string command =
        "ffprobe -v error -select_streams v:0 " + options + " -of csv=p=0 'file:" + path.string() +
        "'";
    FILE* pipe = ::popen(command.c_str(), "r");
    char text[200] = "";
    if (!std::fgets(text, sizeof text, pipe)) text[0] = '\0';
    ::pclose(pipe);
    return text;
}

int countFrames(const fs::path& path) {
    const char* const options = "-count_frames -show_entries stream=nb_read_frames";
    return std::atoi(probed(path, options).c_str());
}

int countKeyFrames(const fs::path& path) {
    const char* const options =
        "-skip_frame nokey -count_frames -show_entries stream=nb_read_frames";
    return std::atoi(probed(path, options).c_str());
}

TEST_F(Video, KnowsItsEndings) {
    for (const char* name : {"a.mp4", "a.webm", "a.gif", "b/a.WEBP", "-a:.apng"}) {
        EXPECT_TRUE(render::isVideoName(name)) << name;
    }
    for (const char* name : {"a.png", "mp4", ".mp4", "a.mp4.png", "a.avi", ""}) {
        EXPECT_FALSE(render::isVideoName(name)) << name;
    }
}

TEST_F(Video, HoldsEveryFrameInEveryFormat) {
    NEED_FFMPEG();
    for (const char* name : {"a.mp4", "a.webm", "a.gif", "a.apng", "a.webp"}) {
        VideoWriter film(out(name), {64, 48, 25});
        addFrames(film, 10);
        EXPECT_EQ(film.frames(), 10);
        EXPECT_FALSE(fs::exists(out(name))) << "not before it is whole";
        film.close();
        EXPECT_GT(fs::file_size(out(name)), 100U);
        // ffprobe of 2022 cannot decode an animated WebP; close() has counted its frames
        if (fs::path(name).extension() == ".webp") continue;
        EXPECT_EQ(countFrames(out(name)), 10) << name;
    }
    EXPECT_EQ(filesLeft(), 5);
}

/// Also of a film that is encoded from stored frames, where ffmpeg converts the colours.
TEST_F(Video, SaysHowItsColoursAreMeant) {
    NEED_FFMPEG();
    const auto say = [&](const char* name, std::uint64_t largest) {
        render::Fit fit;
        fit.largestFile = largest;
        VideoWriter film(out(name), {64, 48, 25}, fit);
        addFrames(film, 3);
        film.close();
        return probed(out(name), "-show_entries stream=pix_fmt,color_range,color_space,"
                                 "color_transfer,color_primaries,chroma_location");
    };
    EXPECT_EQ(say("a.mp4", 0), "yuv420p,tv,bt709,bt709,bt709,center\n");
    EXPECT_EQ(say("fit.mp4", 1000000), "yuv420p,tv,bt709,bt709,bt709,center\n");
    EXPECT_TRUE(has(say("a.webm", 0), "yuv420p,tv,bt709,bt709,bt709"));
}

TEST_F(Video, IsTheSameFileEveryTime) {
    NEED_FFMPEG();
    std::string content[2];
    for (std::string& bytes : content) {
        VideoWriter film(out("same.mp4"), {64, 48, 25});
        addFrames(film, 10);
        film.close();
        std::ifstream in(out("same.mp4"), std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(in), {});
    }
    EXPECT_EQ(content[0], content[1]);
    EXPECT_EQ(filesLeft(), 1);
}

TEST_F(Video, HasAKeyFrameAsOftenAsItIsAskedFor) {
    NEED_FFMPEG();
    for (const int every : {0, 4}) {
        const fs::path path = out(every == 0 ? "few.mp4" : "many.mp4");
        VideoWriter film(path, {64, 48, 25, false, every});
        addFrames(film, 20);
        film.close();
        EXPECT_EQ(countKeyFrames(path), every == 0 ? 1 : 5);
    }
}

TEST_F(Video, NamesAreOnlyNames) {
    NEED_FFMPEG();
    for (const char* name : {"-x.mp4", "a:b.mp4", "a;touch pwned.mp4", "%d%n.mp4", "http:x.mp4"}) {
        VideoWriter film(out(name), {64, 48, 25});
        addFrames(film, 2);
        film.close();
        EXPECT_TRUE(fs::exists(out(name))) << name;
    }
    EXPECT_EQ(filesLeft(), 5);
}

TEST_F(Video, OddSidesAreRefusedBeforeTheFirstFrame) {
    EXPECT_EQ(errorOf([&] {
                  VideoWriter(out("a.mp4"), {641, 361, 25});
              }),
              "641x361 has an odd side; H.264 with 4:2:0 needs even sizes, use 642x362");
    EXPECT_TRUE(has(errorOf([&] { VideoWriter(out("a.webm"), {640, 361, 25}); }), "use 640x362"));
    EXPECT_EQ(filesLeft(), 0);
}

TEST_F(Video, OddSidesAreFineWhereTheFormatHasThem) {
    NEED_FFMPEG();
    VideoWriter film(out("odd.gif"), {65, 49, 25});
    addFrames(film, 3, 65, 49);
    film.close();
    EXPECT_EQ(countFrames(out("odd.gif")), 3);
}

TEST_F(Video, RefusesWhatNoFilmCanBe) {
    EXPECT_THROW(VideoWriter(out("a.avi"), {64, 48, 25}), render::Error);
    EXPECT_THROW(VideoWriter(out("a.gif"), {0, 48, 25}), render::Error);
    EXPECT_THROW(VideoWriter(out("a.gif"), {64, 16385, 25}), render::Error);
    EXPECT_THROW(VideoWriter(out("a.mp4"), {64, 48, 0}), render::Error);
    EXPECT_TRUE(has(errorOf([&] { VideoWriter(out("a.gif"), {64, 48, 60}); }), "1..50"));
    EXPECT_EQ(filesLeft(), 0);
}

TEST_F(Video, RefusesFramesOfAnotherSizeAndFilmsWithoutAny) {
    NEED_FFMPEG();
    VideoWriter film(out("a.mp4"), {64, 48, 25});
    EXPECT_THROW(film.add(frame(48, 64, 0)), render::Error);
    EXPECT_TRUE(has(errorOf([&] { film.close(); }), "no frames"));
    EXPECT_EQ(filesLeft(), 0);
    EXPECT_THROW(film.add(frame(64, 48, 0)), render::Error);
}

TEST_F(Video, AnUnfinishedFilmLeavesNothing) {
    NEED_FFMPEG();
    std::ofstream(out("kept.mp4")) << "precious";
    {
        VideoWriter film(out("kept.mp4"), {64, 48, 25});
        addFrames(film, 5);
        EXPECT_EQ(filesLeft(), 2);
    }
    EXPECT_EQ(filesLeft(), 1);
    EXPECT_EQ(fs::file_size(out("kept.mp4")), 8U);
}

TEST_F(Video, ABadFolderIsAnError) {
    EXPECT_TRUE(has(errorOf([&] {
                        VideoWriter(folder_ / "no/a.mp4", {64, 48, 25});
                    }),
                    "No such file or directory"));
}

TEST_F(Video, NeverWritesThroughASymlink) {
    std::ofstream(folder_ / "victim") << "precious";
    fs::create_symlink(folder_ / "victim", out("link.mp4"));
    EXPECT_TRUE(has(errorOf([&] { VideoWriter(out("link.mp4"), {64, 48, 25}); }), "symbolic link"));
    EXPECT_EQ(fs::file_size(folder_ / "victim"), 8U);
    EXPECT_EQ(filesLeft(), 1);
}

TEST_F(Video, AMissingFfmpegIsReportedWithTheRemedy) {
    ::setenv("PATH", "/nonexistent", 1);
    EXPECT_FALSE(render::haveFfmpeg());
    EXPECT_EQ(errorOf([&] {
                  VideoWriter(out("a.mp4"), {64, 48, 25});
              }),
              "ffmpeg was not found; install it (apt install ffmpeg); PNG frames need nothing "
              "else");
    EXPECT_EQ(filesLeft(), 0);
}

TEST_F(Video, AKilledFfmpegIsAnErrorAndNotASignal) {
    replaceFfmpeg("head -c 100 >/dev/null; kill -9 $$");
    EXPECT_TRUE(render::haveFfmpeg());
    VideoWriter film(out("a.mp4"), {640, 480, 25});
    const std::string error = errorOf([&] { addFrames(film, 100, 640, 480); });
    EXPECT_TRUE(has(error, "killed by signal 9")) << error;
    EXPECT_EQ(filesLeft(), 0);
}

TEST_F(Video, FfmpegsLastWordsAreQuotedWithoutEscapes) {
    replaceFfmpeg("cat >/dev/null; printf 'first\\n\\033[31mEncoder broke\\n' >&2; exit 3");
    VideoWriter film(out("a.mp4"), {64, 48, 25});
    addFrames(film, 3);
    const std::string error = errorOf([&] { film.close(); });
    EXPECT_TRUE(has(error, "stopped with status 3: ?[31mEncoder broke")) << error;
    EXPECT_FALSE(has(error, "first"));
    EXPECT_EQ(filesLeft(), 0);
}

TEST_F(Video, LostFramesAreAnErrorThoughFfmpegEndsWell) {
    replaceFfmpeg("cat >/dev/null; echo frame=2; echo progress=end");
    VideoWriter film(out("a.mp4"), {64, 48, 25});
    addFrames(film, 3);
    EXPECT_TRUE(has(errorOf([&] { film.close(); }), "wrote 2 of 3 frames"));
    EXPECT_EQ(filesLeft(), 0);
}

TEST_F(Video, AHangingFfmpegIsEnded) {
    replaceFfmpeg("exec sleep 30");
    {
        VideoWriter film(out("a.mp4"), {640, 480, 25}, 200ms);
        const std::string error = errorOf([&] { addFrames(film, 100, 640, 480); });
        EXPECT_TRUE(has(error, "did nothing")) << error;
    }
    VideoWriter film(out("a.mp4"), {16, 16, 25}, 200ms);
    film.add({16, 16, std::vector<std::uint8_t>(1024)});  // fits the socket: close() must notice
    EXPECT_TRUE(has(errorOf([&] { film.close(); }), "did nothing"));
    EXPECT_EQ(filesLeft(), 0);
}

/// In a child process: 2.4 MB of noise where a file may have 50 kB. 0: it fails as expected.
int filmTooMuch(const fs::path& path) {
    const rlimit limit = {50'000, 50'000};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 3;
    ::signal(SIGXFSZ, SIG_IGN);
    const std::string error = errorOf([&] {
        VideoWriter film(path, {320, 240, 25});
        std::uint32_t noise = 1;
        for (int i = 0; i < 8; ++i) {
            render::Image image = frame(320, 240, i);
            for (std::uint8_t& level : image.pixels) {
                level = static_cast<std::uint8_t>((noise = noise * 1664525 + 1013904223) >> 24);
            }
            film.add(image);
        }
        film.close();
    });
    std::fputs((error + "\n").c_str(), stderr);
    return has(error, "ffmpeg stopped") ? 0 : 1;
}

TEST_F(Video, AFullDiskLeavesNothing) {
    NEED_FFMPEG();
    for (const char* name : {"full.mp4", "full.webm", "full.gif", "full.webp", "full.apng"}) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) ::_exit(filmTooMuch(out(name)));
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFEXITED(status)) << name;
        EXPECT_EQ(WEXITSTATUS(status), 0) << name;
    }
    EXPECT_EQ(filesLeft(), 0);
}

}  // namespace
