// Extensions of embind: vectors that cross as JavaScript arrays, typed views of memory, and
// string_view parameters.
#pragma once

#include <emscripten/bind.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace warpjet {

// Numbers in memory, which JavaScript sees as a typed array that is valid until the memory grows.
template <typename T>
struct View {
  std::size_t size;
  const T* data;

  explicit View(const std::vector<T>& numbers) : size(numbers.size()), data(numbers.data()) {}
};

}  // namespace warpjet

extern "C" void _embind_register_array(emscripten::internal::TYPEID array,
                                       emscripten::internal::TYPEID item, int kind);

namespace emscripten::internal {

// Vectors cross as copies, which .cmake/embind-array.js makes and reads. (Embind's register_vector
// makes objects with size(), get(i) and delete().)
template <typename T>
struct BindingType<std::vector<T>> {
  using Item = typename BindingType<T>::WireType;
  struct Items {
    std::uint32_t length;
    alignas(8) Item items[1];
  };
  using WireType = Items*;

  static WireType toWireType(const std::vector<T>& values) {
    const auto wire =
        static_cast<WireType>(std::malloc(sizeof(Items) + values.size() * sizeof(Item)));
    wire->length = static_cast<std::uint32_t>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      wire->items[i] = BindingType<T>::toWireType(values[i]);
    return wire;
  }

  static std::vector<T> fromWireType(WireType wire) {
    std::vector<T> values;
    values.reserve(wire->length);
    for (std::uint32_t i = 0; i < wire->length; ++i)
      values.push_back(BindingType<T>::fromWireType(wire->items[i]));
    return values;
  }
};

template <typename T>
struct IsVector : std::false_type {};
template <typename T>
struct IsVector<std::vector<T>> : std::true_type {};

// A reference has the type ID of the vector that it refers to.
template <typename T>
struct TypeID<T, std::enable_if_t<IsVector<typename Canonicalized<T>::type>::value>> {
  static constexpr TYPEID get() { return LightTypeID<typename Canonicalized<T>::type>::get(); }
};

// Views are for results only.
template <typename T>
struct BindingType<warpjet::View<T>> {
  using WireType = BindingType<val>::WireType;
  static WireType toWireType(const warpjet::View<T>& view) {
    return BindingType<val>::toWireType(val(typed_memory_view(view.size, view.data)));
  }
};

// A string_view is for parameters only: the characters are released after the call.
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

// Returns the index of a typed array in the order of embind's memory views; -1 if T is not a
// number.
template <typename T>
constexpr int typedArrayOf() {
  if constexpr (std::is_floating_point_v<T>) {
    return sizeof(T) == 4 ? 6 : 7;
  } else if constexpr (std::is_integral_v<T>) {
    return (sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 2 : 4) + std::is_unsigned_v<T>;
  } else {
    return -1;
  }
}

// Registers View<T>.
template <typename T>
void registerView() {
  constexpr const char* names[] = {"Int8Array",  "Uint8Array",  "Int16Array",   "Uint16Array",
                                   "Int32Array", "Uint32Array", "Float32Array", "Float64Array"};
  using namespace emscripten::internal;
  _embind_register_emval(TypeID<View<T>>::get(), names[typedArrayOf<T>()]);
}

// Registers std::vector<T>.
template <typename T>
void registerArray() {
  using emscripten::internal::TypeID;
  _embind_register_array(TypeID<std::vector<T>>::get(), TypeID<T>::get(), typedArrayOf<T>());
}

}  // namespace warpjet
