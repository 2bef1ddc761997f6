// What embind lacks: vectors that cross as JavaScript arrays, and string_view parameters.
//
// A vector of numbers crosses as a typed array, another one as an Array; both are copies, so that
// nobody has to delete them. (Embind's register_vector gives objects with size(), get(i) and
// delete().)
#pragma once

#include <emscripten/bind.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace emscripten::internal {

template <typename T>
struct BindingType<std::vector<T>> {
  using WireType = BindingType<val>::WireType;

  static WireType toWireType(const std::vector<T>& values) {
    if constexpr (std::is_arithmetic_v<T>) {
      const val view(typed_memory_view(values.size(), values.data()));
      return BindingType<val>::toWireType(view.call<val>("slice"));
    } else {
      const val array = val::array();
      for (const T& value : values) array.call<void>("push", value);
      return BindingType<val>::toWireType(array);
    }
  }

  static std::vector<T> fromWireType(WireType wire) {
    const val array = BindingType<val>::fromWireType(wire);
    if constexpr (std::is_arithmetic_v<T>) {
      return convertJSArrayToNumberVector<T>(array);
    } else {
      return vecFromJSArray<T>(array);
    }
  }
};

template <typename T>
struct IsVector : std::false_type {};
template <typename T>
struct IsVector<std::vector<T>> : std::true_type {};

// References have the identity of what they refer to.
template <typename T>
struct TypeID<T, std::enable_if_t<IsVector<typename Canonicalized<T>::type>::value>> {
  static constexpr TYPEID get() { return LightTypeID<typename Canonicalized<T>::type>::get(); }
};

// A parameter only: the characters are released after the call.
template <>
struct BindingType<std::string_view> {
  using WireType = BindingType<std::string>::WireType;
  static std::string_view fromWireType(WireType wire) { return {wire->data, wire->length}; }
};
template <>
struct TypeID<std::string_view> {
  static constexpr TYPEID get() { return LightTypeID<std::string>::get(); }
};

}  // namespace emscripten::internal

namespace warpjet {

// Registers std::vector<T> under its name in TypeScript, such as "Uint32Array" or "Variable[]".
template <typename T>
void registerArray(const char* name) {
  using namespace emscripten::internal;
  _embind_register_emval(TypeID<std::vector<T>>::get(), name);
}

}  // namespace warpjet
