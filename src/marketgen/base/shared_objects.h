// Objects that many share, made once each: opened stores, renderers, samplers; bodies of products,
// once in a process.
#pragma once
#include <any>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <typeindex>
#include <utility>

#include "base/result.h"

namespace marketgen {

// By their type and a key. Thread-safe: who asks for one that is being made waits for it.
class SharedObjects {
 public:
  // `make` gives a Result<std::shared_ptr<T>>. Its errors; the next one who asks makes it anew.
  template <class T, class Make>
  Result<std::shared_ptr<T>> get(const std::string& key, const Make& make) {
    Slot& slot = slot_of({typeid(std::shared_ptr<T>), key});
    const std::scoped_lock lock(slot.mutex);
    if (!slot.object.has_value()) {
      MARKETGEN_TRY(std::shared_ptr<T> made, make());
      slot.object = std::move(made);
    }
    return std::any_cast<std::shared_ptr<T>>(slot.object);
  }

 private:
  using Key = std::pair<std::type_index, std::string>;
  struct Slot {
    std::mutex mutex;  // of the making
    std::any object;
  };
  Slot& slot_of(const Key& key) {
    const std::scoped_lock lock(mutex_);
    return slots_[key];
  }

  std::mutex mutex_;  // of the map, whose places stay where they are
  std::map<Key, Slot> slots_;
};

}  // namespace marketgen
