#include "demos/export/pose_table.h"

namespace demos {

void addPoseRow(double time, const std::string& body, const BodyMotion& motion, Table& table) {
    const Quat& q = motion.pose.rotation;
    table.cell(time).cell(body).cells(motion.pose.position);
    table.cell(q.w()).cell(q.x()).cell(q.y()).cell(q.z());
    table.cells(motion.velocity).cells(motion.spin);
    table.endRow();
}

Table poseTable(const std::string& target, const Recording& recording) {
    Table table(target, kPoseColumns);
    for (const RecordedFrame& frame : recording.frames)
        for (std::size_t i = 0; i < frame.bodies.size(); ++i)
            addPoseRow(frame.time, recording.bodies[i].name, frame.bodies[i], table);
    return table;
}

}  // namespace demos
