/// What a scene is made of, as keys and values that a baseline keeps: an edited scene is reported
/// by the values that differ.
#pragma once
#include <string>
#include <vector>

#include "demos/regression/baseline.h"
#include "demos/regression/verdict.h"

namespace demos {

/// The scene file's values with those of --set; other files (meshes, models) by hash and name.
/// `name`: as given on the command line.
Settings inputsOf(const SceneDescription& scene, const std::string& name,
                  const std::vector<std::string>& overrides);

/// The values that differ, sorted by key: "body.crate.at[0]" where one number of a list does, and
/// only "body.crate" where the whole table is new or gone. At most 100, and how many more.
std::vector<SettingChange> changedInputs(const Settings& baseline, const Settings& actual);

/// The settings that differ, in the order of `actual`, then those that only `baseline` has, then
/// the inputs. An older baseline keeps no inputs.
std::vector<SettingChange> changesBetween(const Baseline& baseline, const Baseline& actual);

/// For baseline.json.
std::string deflatedInputs(const Settings& inputs);
/// Throws std::invalid_argument.
Settings inflatedInputs(const std::string& packed);

}  // namespace demos
