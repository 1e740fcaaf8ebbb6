#include "physics/mujoco_guard.h"

#include <csetjmp>
#include <cstring>
#include <mutex>

#include "base/interrupt.h"
#include "base/progress.h"

namespace marketgen::physics {
namespace {

thread_local std::jmp_buf* recovery = nullptr;  // of the innermost guard on this thread
thread_local char failure[sizeof(mjLogMessage::subject)];

void on_message(const mjLogMessage* message) {
  if (message->level != mjLOG_ERROR) return log_debug(std::string("MuJoCo: ") + message->subject);
  if (recovery == nullptr) fatal(message->subject);
  std::memcpy(failure, message->subject, sizeof failure);
  std::longjmp(*recovery, 1);  // NOLINT(modernize-avoid-setjmp-longjmp): MuJoCo's documented way
}

// True when `body` came to its end. No object with a destructor lives in this frame.
bool finishes(const std::function<void()>& body) {
  std::jmp_buf* const outer = recovery;
  std::jmp_buf here;
  recovery = &here;
  bool finished = false;
  if (setjmp(here) == 0) {  // NOLINT(modernize-avoid-setjmp-longjmp)
    body();
    finished = true;
  }
  recovery = outer;
  return finished;
}

}  // namespace

void route_mujoco_messages() {
  static std::once_flag once;
  std::call_once(once, [] { mju_setLogHandler(on_message); });
}

Result<void> guarded(const std::string& where, const std::function<void()>& body) {
  interrupt_point();  // every loop over steps passes here
  route_mujoco_messages();
  if (finishes(body)) return {};
  return Error{"physics.failed", where, failure};
}

Result<MujocoModel> compile(mjSpec& spec, const std::string& where) {
  route_mujoco_messages();
  MujocoModel model(mj_compile(&spec, nullptr), mj_deleteModel);
  if (model == nullptr) return Error{"physics.failed", where, mjs_getError(&spec)};
  return model;
}

Result<MujocoData> make_data(const mjModel& model, const std::string& where) {
  mjData* data = nullptr;
  MARKETGEN_CHECK(guarded(where, [&] { data = mj_makeData(&model); }));
  if (data == nullptr)
    return Error{"physics.failed", where, "MuJoCo could not allocate the model's data"};
  return MujocoData(data, mj_deleteData);
}

}  // namespace marketgen::physics
