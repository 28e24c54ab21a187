#pragma once

#include <memory>
#include <string>

namespace plumb {

/// A shared library opened while the program runs. It stays open to the end: drivers leave handlers behind
/// that are called as threads end.
class SharedLibrary {
 public:
  /// Throws OutputError that says what the loader says.
  explicit SharedLibrary(const std::string& name);

  /// Sets a pointer to the function of that name. Throws OutputError when there is none.
  template <typename Function>
  void load(Function& function, const char* name) const {
    function = reinterpret_cast<Function>(symbol(name));
  }

  static bool is_there(const std::string& name) noexcept;

 private:
  void* symbol(const char* name) const;

  std::string name_;
  void* handle_;
};

}  // namespace plumb
