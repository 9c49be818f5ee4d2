/// The reader's parts, one per group of tables. Each fills in its share of the description and
/// reports errors.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "demos/scene/description.h"
#include "demos/scene/keys.h"
#include "demos/scene/repeat.h"

namespace demos {

struct MaterialDescription {
    engine::Material material;
    std::optional<unsigned> color;
    render::Material look{};
};
using Materials = std::map<std::string, MaterialDescription>;
using BodyNumbers = std::map<std::string, int>;  // index in scene.bodies by name

// read_values.cpp
void readValues(Keys& top, Expressions& expressions, Complaints& complaints);

// read_settings.cpp
void readWorld(Keys& top, SceneDescription& scene);
void readSolver(Keys& top, SceneDescription& scene);

// read_bodies.cpp
Materials readMaterials(Keys& top, Complaints& complaints);
BodyNumbers readBodies(const std::vector<Instance>& instances, const Materials& materials,
                       SceneDescription& scene, Complaints& complaints);

// read_motion.cpp
void readKinematic(Keys keys, const Instance& instance, BodyDescription& body);

// read_groups.cpp
void numberGroups(SceneDescription& scene, Complaints& complaints);

// read_shape.cpp; `density`: kg/m^3, of the body
struct ShapeFiles;
std::optional<engine::Shape> readShape(Keys& body, double density, ShapeFiles& files);

// read_joints.cpp
void readJoints(const std::vector<Instance>& instances, const BodyNumbers& numbers,
                SceneDescription& scene, Complaints& complaints);

// read_forces.cpp
void readForces(const std::vector<Instance>& instances, const BodyNumbers& numbers,
                SceneDescription& scene, Complaints& complaints);

// read_camera.cpp
void readCamera(Keys& top, const BodyNumbers& numbers, SceneDescription& scene);

// read_film.cpp
void readLook(Keys& top, SceneDescription& scene);
void readSections(Keys& top, SceneDescription& scene);

/// The tables that a slide may show: measures, expectations.
const std::vector<std::string>& tableNames();

// read_snapshot.cpp
void readSnapshot(Keys& top, SceneDescription& scene);

// read_expectations.cpp
void readExpectations(Keys& top, SceneDescription& scene);

/// Whether the name is `[A-Za-z0-9_.{}+-]{1,64}`; reports an error if not.
bool checkName(const std::string& name, Place place, const char* what, Complaints& complaints);

/// The names of all bodies and of all joints, for suggestions.
std::vector<std::string> bodyNames(const SceneDescription& scene);
std::vector<std::string> jointNames(const SceneDescription& scene);

}  // namespace demos
