// Milliseconds of processor time per frame of MuJoCo's renderer, with our default features: several
// samples, a shadow, haze, a patterned ground. `film_peer_mujoco [PICTURE.ppm]`. No other OpenGL
// library may be linked: MuJoCo takes the functions of the first one it finds.
#include <GL/osmesa.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/benchmark/film_peer.h"

using namespace film_peer;

namespace {

/// The same bodies as a MuJoCo model. Its z is up; a rotated world body turns that to y.
std::string mjcf() {
    std::string text =
        "<mujoco><visual><global offwidth='1280' offheight='720' fovy='40'/>"
        "<quality offsamples='4' shadowsize='2048'/><map haze='0.3' znear='0.02'/></visual><asset>"
        "<texture name='sky' type='skybox' builtin='gradient' rgb1='.8 .85 .9' rgb2='.6 .65 .7' "
        "width='256' height='256'/><texture name='grid' type='2d' builtin='checker' "
        "rgb1='.7 .7 .7' rgb2='.6 .6 .6' width='256' height='256'/><material name='grid' "
        "texture='grid' texrepeat='40 40'/></asset><worldbody>"
        "<light directional='true' pos='4 -4 8' dir='-.45 .5 -.75' castshadow='true'/>"
        "<geom type='plane' size='40 40 1' material='grid'/>";
    char line[400];
    for (const render::Solid& s : bodies()) {
        const render::Quat q = s.rotation;
        const bool box = s.shape == render::SolidShape::box;
        std::snprintf(line, sizeof line,
                      "<geom type='%s' size='%g %g %g' pos='%g %g %g' quat='%g %g %g %g' "
                      "rgba='%g %g %g 1'/>",
                      box ? "box" : "sphere", s.halfSize.x(), s.halfSize.z(), s.halfSize.y(),
                      s.position.x(), -s.position.z(), s.position.y(), q.w(), q.x(), -q.z(), q.y(),
                      s.color.r, s.color.g, s.color.b);
        text += line;
    }
    return text + "</worldbody></mujoco>";
}

/// MuJoCo's camera is defined by its angles around the point that it looks at.
mjvCamera mujocoCamera() {
    mjvCamera camera;
    mjv_defaultCamera(&camera);
    const render::Vec3 sight = kLookAt - kFrom;
    camera.lookat[0] = kLookAt.x(), camera.lookat[1] = -kLookAt.z(), camera.lookat[2] = kLookAt.y();
    camera.distance = sight.norm();
    camera.azimuth = std::atan2(-sight.z(), sight.x()) * 180.0 / 3.14159265358979;
    camera.elevation = std::asin(sight.y() / sight.norm()) * 180.0 / 3.14159265358979;
    return camera;
}

int fail(const char* what) {
    std::fprintf(stderr, "film_peer_mujoco: %s\n", what);
    return 1;
}

/// Writes a .ppm, whose first row is the top one; MuJoCo's first row is the bottom one.
void writePicture(const char* name, const std::vector<unsigned char>& rgb) {
    std::ofstream file(name, std::ios::binary);
    file << "P6 " << kWidth << " " << kHeight << " 255\n";
    for (int y = kHeight - 1; y >= 0; --y)
        file.write(reinterpret_cast<const char*>(&rgb[3 * static_cast<std::size_t>(y * kWidth)]),
                   3 * kWidth);
}

}  // namespace

int main(int argc, char** argv) {
    setenv("LP_NUM_THREADS", "0", 1);
    mjVFS files;
    mj_defaultVFS(&files);
    const std::string text = mjcf();
    mj_makeEmptyFileVFS(&files, "wall.xml", static_cast<int>(text.size()));
    std::copy(text.begin(), text.end(), static_cast<char*>(files.filedata[0]));
    char error[500] = "";
    mjModel* model = mj_loadXML("wall.xml", &files, error, sizeof error);
    if (!model) return fail(error);
    mjData* data = mj_makeData(model);
    mj_forward(model, data);
    const OSMesaContext context = OSMesaCreateContextExt(GL_RGBA, 24, 8, 8, nullptr);
    std::vector<unsigned char> buffer(4 * 800 * 800);
    if (!context || !OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 800, 800))
        return fail("no OSMesa context");
    mjvScene scene;
    mjrContext gl;
    mjvOption option;
    mjv_defaultScene(&scene);
    mjv_makeScene(model, &scene, 1000);
    mjv_defaultOption(&option);
    mjr_defaultContext(&gl);
    mjr_makeContext(model, &gl, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &gl);
    mjvCamera camera = mujocoCamera();
    const mjrRect all = {0, 0, kWidth, kHeight};
    std::vector<unsigned char> rgb(3 * kWidth * kHeight);
    const double ms = timeFrames([&] {
        mjv_updateScene(model, data, &option, nullptr, &camera, mjCAT_ALL, &scene);
        mjr_render(all, &scene, &gl);
        mjr_readPixels(rgb.data(), nullptr, all, &gl);
    });
    if (argc > 1) writePicture(argv[1], rgb);
    std::printf("%.2f\n", ms);
}
