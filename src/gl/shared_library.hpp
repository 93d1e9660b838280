#pragma once
// A shared library opened at run time, so that no driver is a link dependency.
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>

namespace sr::gl {

class SharedLibrary {
public:
    /// Opens the first of `names` that the dynamic loader finds; absent if it finds none.
    static std::optional<SharedLibrary> open(std::initializer_list<const char*> names);

    const std::string& name() const { return name_; }

    /// A function by its symbol; null if the library has none of that name.
    template<class Function>
    Function* function(const char* symbol) const {
        return reinterpret_cast<Function*>(address(symbol));
    }

private:
    SharedLibrary(void* handle, std::string name);
    void* address(const char* symbol) const;

    std::shared_ptr<void> handle_;
    std::string name_;
};

} // namespace sr::gl
