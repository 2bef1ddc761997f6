#include "mesh/gltf/accessor.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include "mesh/messages.hpp"

namespace warpjet {

namespace {

// Without this limit, a small file could declare an array of zeros that fills the memory.
constexpr std::size_t maxZeros = std::size_t{1} << 22;

const tinygltf::Accessor& accessorAt(const Gltf& gltf, int accessor) {
  const auto& accessors = gltf.model.accessors;
  return accessors[checkIndex("accessor", accessor, accessors.size())];
}

[[noreturn]] void fail(int accessor, const std::string& what) {
  throw FileProblem("accessor " + std::to_string(accessor) + ' ' + what +
                    "; export the model again.");
}

// Elements at a distance of `stride` bytes, each within the file.
struct Elements {
  const std::uint8_t* first;
  std::size_t stride, count;

  template <typename T>
  T at(std::size_t element, std::size_t component = 0) const {
    T value;
    std::memcpy(&value, first + element * stride + component * sizeof(T), sizeof(T));
    return value;
  }
};

// Returns elements of `size` bytes in a view. A stride of 0 means that they are contiguous.
Elements elementsIn(const Gltf& gltf, int accessor, int bufferView, std::uint64_t offset,
                    std::uint64_t count, std::size_t size, std::size_t stride) {
  const Bytes bytes = bytesOfView(gltf, bufferView);
  if (stride == 0) stride = size;
  // At most 2^32 + 2^32 * 252: no overflow.
  const std::uint64_t end = count == 0 ? offset : offset + (count - 1) * stride + size;
  if (end > bytes.size())
    fail(accessor, "reads up to byte " + groupDigits(end) + " of bufferView " +
                       std::to_string(bufferView) + ", which has only " +
                       groupDigits(bytes.size()));
  return {bytes.data() + offset, stride, static_cast<std::size_t>(count)};
}

// Returns the elements in the accessor's own view, of `size` bytes each. Only vectors may have a
// stride.
Elements ownElements(const Gltf& gltf, int accessor, std::size_t size) {
  const tinygltf::Accessor& info = accessorAt(gltf, accessor);
  const auto& views = gltf.model.bufferViews;
  const auto& view = views[checkIndex("bufferView", info.bufferView, views.size())];
  const std::size_t stride = info.type == TINYGLTF_TYPE_SCALAR ? 0 : view.byteStride;
  return elementsIn(gltf, accessor, info.bufferView, info.byteOffset, info.count, size, stride);
}

// Returns the size of an element, or less if it isn't a vector: such elements are checked or
// rejected where they are read.
std::size_t sizeOf(const tinygltf::Accessor& info) {
  // tinygltf's constants for vector types are their lengths.
  const int width = info.type <= TINYGLTF_TYPE_VEC4 ? info.type : 1;
  const int bytes =
      tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(info.componentType));
  return static_cast<std::size_t>(std::max(width * bytes, 1));
}

// Calls `function` with a zero of a component's C++ type.
template <typename Function>
void withType(int accessor, int componentType, Function function) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return function(std::int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return function(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return function(std::int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return function(std::uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return function(std::uint32_t{});
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return function(float{});
    default:
      fail(accessor, "has the unknown component type " + std::to_string(componentType));
  }
}

// Converts a component as in glTF 2.0, section 3.6.2.2: for example, normalized signed bytes become
// max(c / 127, -1).
template <typename T>
float toFloat(T value, bool isNormalized) {
  if constexpr (std::is_same_v<T, float>) return value;
  if (!isNormalized) return static_cast<float>(value);
  const float quotient =
      static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max());
  return std::max(quotient, -1.0f);
}

// Calls `replace` with the index and the new value of each replaced element.
template <typename T, typename Replace>
void forSparse(const Gltf& gltf, int accessor, std::size_t components, Replace replace) {
  const tinygltf::Accessor& info = accessorAt(gltf, accessor);
  if (!info.sparse.isSparse) return;
  const auto count = static_cast<std::uint64_t>(info.sparse.count);
  if (count > info.count)
    fail(accessor,
         "replaces " + groupDigits(count) + " of its " + groupDigits(info.count) + " elements");
  const Elements values = elementsIn(gltf, accessor, info.sparse.values.bufferView,
                                     static_cast<std::uint64_t>(info.sparse.values.byteOffset),
                                     count, components * sizeof(T), 0);
  const auto replaceAll = [&]<typename Index>(Index) {
    const Elements indices = elementsIn(gltf, accessor, info.sparse.indices.bufferView,
                                        static_cast<std::uint64_t>(info.sparse.indices.byteOffset),
                                        count, sizeof(Index), 0);
    for (std::size_t i = 0; i < indices.count; ++i) {
      const Index index = indices.at<Index>(i);
      if constexpr (std::is_unsigned_v<Index>) {
        if (index >= info.count)
          fail(accessor, "replaces its element " + groupDigits(index) + ", but has only " +
                             groupDigits(info.count));
        replace(static_cast<std::size_t>(index), values, i);
      } else {
        fail(accessor, "has sparse indices that are not unsigned integers");
      }
    }
  };
  withType(accessor, info.sparse.indices.componentType, replaceAll);
}

template <typename T>
void appendAs(const Gltf& gltf, int accessor, std::size_t components, std::size_t width,
              std::vector<float>& numbers) {
  const tinygltf::Accessor& info = accessorAt(gltf, accessor);
  const std::size_t start = numbers.size();
  const auto write = [&](std::size_t to, const Elements& from, std::size_t element) {
    for (std::size_t i = 0; i < components; ++i)
      numbers[start + to * width + i] = toFloat(from.at<T>(element, i), info.normalized);
  };
  if (info.bufferView < 0) {
    numbers.resize(start + countOf(gltf, accessor) * width);
    for (std::size_t i = start; i < numbers.size(); ++i)
      numbers[i] = (i - start) % width < components ? 0.0f : 1.0f;
  } else {
    const Elements elements = ownElements(gltf, accessor, components * sizeof(T));
    numbers.resize(start + elements.count * width, 1.0f);
    for (std::size_t i = 0; i < elements.count; ++i) write(i, elements, i);
  }
  forSparse<T>(gltf, accessor, components, write);
}

}  // namespace

std::size_t countOf(const Gltf& gltf, int accessor) {
  const tinygltf::Accessor& info = accessorAt(gltf, accessor);
  if (info.bufferView < 0 && info.count > maxZeros)
    fail(accessor, "declares " + groupDigits(info.count) + " elements without any bytes; at most " +
                       groupDigits(maxZeros) + " are read");
  if (info.bufferView >= 0) ownElements(gltf, accessor, sizeOf(info));
  return info.count;
}

void appendFloats(const Gltf& gltf, int accessor, int minWidth, int width,
                  std::vector<float>& numbers) {
  const tinygltf::Accessor& info = accessorAt(gltf, accessor);
  // tinygltf's constants for vector types are their lengths.
  if (info.type < minWidth || info.type > width)
    fail(accessor, "must hold vectors of " + std::to_string(width) + " numbers for its use");
  withType(accessor, info.componentType, [&]<typename T>(T) {
    if constexpr (std::is_same_v<T, std::uint32_t>)
      fail(accessor, "has integers of 32 bits, which only indices may have");
    else
      appendAs<T>(gltf, accessor, static_cast<std::size_t>(info.type),
                  static_cast<std::size_t>(width), numbers);
  });
}

void appendMatrices(const Gltf& gltf, int accessor, std::vector<float>& numbers) {
  const tinygltf::Accessor& info = accessorAt(gltf, accessor);
  if (info.type != TINYGLTF_TYPE_MAT4 || info.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT)
    fail(accessor, "must hold 4 by 4 matrices of floats for its use");
  appendAs<float>(gltf, accessor, 16, 16, numbers);
}

std::vector<std::uint32_t> indicesOf(const Gltf& gltf, int accessor) {
  const tinygltf::Accessor& info = accessorAt(gltf, accessor);
  std::vector<std::uint32_t> indices;
  if (info.type != TINYGLTF_TYPE_SCALAR) fail(accessor, "must hold single numbers, being indices");
  withType(accessor, info.componentType, [&]<typename T>(T) {
    if constexpr (std::is_unsigned_v<T>) {
      indices.resize(countOf(gltf, accessor));
      if (info.bufferView >= 0) {
        const Elements elements = ownElements(gltf, accessor, sizeof(T));
        for (std::size_t i = 0; i < elements.count; ++i) indices[i] = elements.at<T>(i);
      }
      forSparse<T>(gltf, accessor, 1,
                   [&](std::size_t to, const Elements& from, std::size_t element) {
                     indices[to] = from.at<T>(element);
                   });
    } else {
      fail(accessor, "must hold unsigned integers, being indices");
    }
  });
  return indices;
}

}  // namespace warpjet
