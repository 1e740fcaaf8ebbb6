#include "base/call_interrupt.h"

namespace marketgen {
namespace {

thread_local const std::atomic<bool>* call_flag = nullptr;

}  // namespace

CallInterrupt::CallInterrupt(const std::atomic<bool>* flag) : before_(call_flag) {
  call_flag = flag;
}

CallInterrupt::~CallInterrupt() {
  call_flag = before_;
}

const std::atomic<bool>* CallInterrupt::of_this_thread() {
  return call_flag;
}

bool call_interrupted() {
  return call_flag != nullptr && call_flag->load(std::memory_order_relaxed);
}

}  // namespace marketgen
