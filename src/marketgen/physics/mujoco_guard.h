// MuJoCo ends the process on an error; under the guard it becomes a value.
#pragma once
#include <mujoco/mujoco.h>

#include <functional>
#include <memory>
#include <string>

#include "base/result.h"

namespace marketgen::physics {

// Runs `body` and returns physics.failed, with MuJoCo's message, if MuJoCo reports an error
// meanwhile. `body` is then left by longjmp: while it calls MuJoCo it must hold no object with a
// destructor. Thread-safe; guards may nest. mj_compile, mj_loadXML and mj_parseXMLString need no
// guard: they return null.
//
// From the first call on, MuJoCo's warnings go to our debug log instead of a MUJOCO_LOG.TXT.
Result<void> guarded(const std::string& where, const std::function<void()>& body);

// Sends MuJoCo's messages to our log; guarded() does it by itself.
void route_mujoco_messages();

using MujocoSpec = std::unique_ptr<mjSpec, decltype(&mj_deleteSpec)>;
using MujocoModel = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;
using MujocoData = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

// Compiles, and makes the model's data. Errors: physics.failed.
Result<MujocoModel> compile(mjSpec& spec, const std::string& where);
Result<MujocoData> make_data(const mjModel& model, const std::string& where);

}  // namespace marketgen::physics
