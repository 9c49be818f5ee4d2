/// Small models that should move alike in MuJoCo and in this engine, with tolerances.
#pragma once
#include <ostream>

namespace demos::test {

struct MujocoSample {
    const char* name;
    const char* text;  // the model, or the file of one of MuJoCo's own
    double seconds;
    double within;     // m, of every body's centre of mass
    const char* why;   // the reason for a tolerance beyond a millimetre
};

inline void PrintTo(const MujocoSample& sample, std::ostream* out) { *out << sample.name; }

inline const MujocoSample kMujocoSamples[] = {
    {"pendulum", R"(<mujoco><option timestep='0.0005'/><worldbody>
<body name='bob' pos='0 0 2'><joint axis='0 1 0'/><geom size='0.1' pos='1 0 0' mass='1'/></body>
</worldbody></mujoco>)", 1.0, 1e-3, ""},
    {"armature", R"(<mujoco><option timestep='0.0005'/><worldbody>
<body name='upper' pos='0 0 2'><joint axis='0 1 0' armature='0.3'/>
<geom type='capsule' size='0.03' fromto='0 0 0 0.5 0 0' density='800'/>
<body name='lower' pos='0.5 0 0'><joint axis='0 1 0' armature='0.05' damping='0.02'/>
<geom type='capsule' size='0.03' fromto='0 0 0 0.4 0 0' density='800'/></body></body>
</worldbody></mujoco>)", 1.0, 1e-3, ""},
    {"armature_of_a_slide", R"(<mujoco><option timestep='0.0005'/><worldbody>
<body name='arm' pos='0 0 2'><joint axis='0 0 1' damping='0.01'/>
<geom type='capsule' size='0.03' fromto='0 0 0 0.5 0 0' density='800'/>
<body name='slider' pos='0.2 0 0'><joint type='slide' axis='1 0 0' armature='1' springref='0.5'
stiffness='40'/><geom size='0.05' mass='0.5'/></body></body>
</worldbody></mujoco>)", 1.0, 1e-3, ""},
    {"box_slides", R"(<mujoco><option timestep='0.0005'/><worldbody>
<geom type='plane' size='9 9 1' condim='3' euler='0 10 0' friction='0.1'/>
<body name='box' pos='0.01736 0 0.09848' euler='0 10 0'><freejoint/><geom type='box' size='0.1 0.1 0.1' condim='1'
friction='0.12'/></body></worldbody></mujoco>)", 1.0, 5e-3, "MuJoCo regularises friction: a sticking body creeps, a sliding one gains speed"},
    {"box_without_friction", R"(<mujoco><option timestep='0.0005'/><worldbody>
<geom type='plane' size='9 9 1' condim='1' euler='0 10 0' friction='0.5'/>
<body name='box' pos='0.01736 0 0.09848' euler='0 10 0'><freejoint/><geom type='box' size='0.1 0.1 0.1' condim='1'/></body>
</worldbody></mujoco>)", 1.0, 1e-3, ""},
    {"box_holds", R"(<mujoco><option timestep='0.0005'/><worldbody>
<geom type='plane' size='9 9 1' condim='1' euler='0 10 0' friction='0.05'/>
<body name='box' pos='0.01736 0 0.09848' euler='0 10 0'><freejoint/><geom type='box' size='0.1 0.1 0.1' friction='0.8'/></body>
</worldbody></mujoco>)", 1.0, 2e-3, "MuJoCo regularises friction: a sticking body creeps"},
    {"box_of_priority", R"(<mujoco><option timestep='0.0005'/><worldbody>
<geom type='plane' size='9 9 1' euler='0 10 0' friction='0.9'/>
<body name='box' pos='0.01736 0 0.09848' euler='0 10 0'><freejoint/><geom type='box' size='0.1 0.1 0.1' friction='0.05'
priority='1'/></body></worldbody></mujoco>)", 1.0, 1e-3, ""},
    {"position_actuators", R"(<mujoco><compiler autolimits='true'/><option timestep='0.0005'/><worldbody>
<body name='upper' pos='0 0 2'><joint name='shoulder' axis='0 1 0' damping='1' armature='0.02'/>
<geom type='capsule' size='0.03' fromto='0 0 0 0.5 0 0' density='800'/>
<body name='lower' pos='0.5 0 0'><joint name='elbow' axis='0 1 0' damping='0.5' ref='20' stiffness='2'/>
<geom type='capsule' size='0.03' fromto='0 0 0 0.4 0 0' density='800'/></body></body>
</worldbody><actuator><position joint='shoulder' kp='30'/><position joint='elbow' kp='10' gear='2'
ctrlrange='-1 1'/></actuator><keyframe><key ctrl='-0.5 1.5'/></keyframe></mujoco>)", 1.0, 1e-3, ""},
    {"motors_and_velocities", R"(<mujoco><option timestep='0.0005'/><worldbody>
<body name='upper' pos='0 0 2'><joint name='shoulder' axis='0 1 0' damping='0.5'/>
<geom type='capsule' size='0.03' fromto='0 0 0 0.5 0 0' density='800'/>
<body name='lower' pos='0.5 0 0'><joint name='elbow' axis='0 1 0'/>
<geom type='capsule' size='0.03' fromto='0 0 0 0.4 0 0' density='800'/></body></body>
<body name='cart' pos='0 1 0'><joint name='way' type='slide' axis='1 0 0'/><geom size='0.1'/></body>
</worldbody><actuator><motor joint='shoulder' gear='-3' ctrllimited='true' ctrlrange='-1 1'/>
<velocity joint='elbow' kv='0.4'/><general joint='way' gainprm='2' biastype='affine'
biasprm='1 -6 -3' forcelimited='false'/></actuator>
<keyframe><key ctrl='2 -1.5 3'/></keyframe></mujoco>)", 1.0, 1e-3, ""},
    {"tendons", R"(<mujoco><option timestep='0.0005'/><worldbody>
<site name='hook' pos='0 0 2'/><site name='nail' pos='1 0 2'/>
<body name='bob' pos='0.4 0 1.5'><freejoint/><geom size='0.1' mass='1'/><site name='eye'/></body>
<body name='weight' pos='1 0.3 1.6'><freejoint/><geom size='0.1' mass='1'/><site name='ring' pos='0 0 0.1'/></body>
<body name='lever' pos='2 0 1'><joint name='pin' axis='0 1 0'/>
<geom type='capsule' size='0.03' fromto='0 0 0 0.4 0 0' density='800'/></body>
</worldbody><tendon><spatial limited='true' range='0 0.8'><site site='hook'/><site site='eye'/></spatial>
<spatial stiffness='60' damping='2' springlength='0.3'><site site='nail'/><site site='ring'/></spatial>
<fixed stiffness='20' damping='0.3' springlength='0.2'><joint joint='pin' coef='0.5'/></fixed></tendon>
</mujoco>)", 1.0, 5e-3, "MuJoCo's limits are soft: the cord yields by some millimetres"},
};

/// MuJoCo's own, by their files. Unsupported features are left out here.
inline const MujocoSample kMujocoModels[] = {
    {"humanoid_in_the_air", "humanoid/humanoid.xml", 0.2, 1e-3, ""},
    {"humanoid", "humanoid/humanoid.xml", 1.0, 0.1,
     "MuJoCo's contacts and limits are soft, and the hips are three hinges one after the other"},
    {"humanoid100", "humanoid100/humanoid100.xml", 0.3, 0.03,
     "MuJoCo's contacts are soft, and ellipsoids are hulls here"},
    {"mug", "mug/mug.xml", 1.0, 0.01, "MuJoCo's contacts are soft"},
    {"arm26", "tendon_arm/arm26.xml", 1.0, 0.3, "its muscles and the paths of their tendons are left out"},
    {"slider_crank", "slider_crank/slider_crank.xml", 1.0, 0.15, "its slider cranks are left out"},
    {"active_adhesion", "adhesion/active_adhesion.xml", 1.0, 0.12,
     "adhesion, gears and a ring of balls are left out"},
};

}  // namespace demos::test
