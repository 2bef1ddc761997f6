// Passes a std::vector to JavaScript (js-bindings/wasm/embind.hpp) as a copy in memory: the length and, from byte 8 on, the items in wire
// format. A vector of numbers becomes a typed array, any other vector an Array. Neither needs to be deleted.
mergeInto(LibraryManager.library, {
  _embind_register_array__deps: ['$simpleReadValueFromPointer', '$whenDependentTypesAreResolved'],
  // `kind` is the index of a typed array in the list below, or -1 for items of other types.
  _embind_register_array: function (arrayType, itemType, kind) {
    var Numbers = [
      Int8Array,
      Uint8Array,
      Int16Array,
      Uint16Array,
      Int32Array,
      Uint32Array,
      Float32Array,
      Float64Array,
    ][kind]
    var bytes = Numbers ? Numbers.BYTES_PER_ELEMENT : 4
    whenDependentTypesAreResolved([arrayType], [itemType], function (types) {
      var item = types[0]
      return [
        {
          name: item.name + '[]',
          fromWireType: function (pointer) {
            pointer >>>= 0
            var length = HEAPU32[pointer >>> 2]
            var array
            if (Numbers) {
              array = new Numbers(buffer, pointer + 8, length).slice()
            } else {
              array = new Array(length)
              for (var i = 0; i < length; ++i)
                array[i] = item['fromWireType'](HEAPU32[(pointer >>> 2) + 2 + i])
            }
            _free(pointer)
            return array
          },
          toWireType: function (destructors, array) {
            var length = array.length
            var pointer = _malloc(8 + bytes * length) >>> 0
            if (!pointer) throw new WebAssembly.RuntimeError('no memory for an array')
            HEAPU32[pointer >>> 2] = length
            if (Numbers) new Numbers(buffer, pointer + 8, length).set(array)
            else
              for (var i = 0; i < length; ++i) {
                var wire = item['toWireType'](destructors, array[i])
                HEAPU32[(pointer >>> 2) + 2 + i] = wire
              }
            if (destructors !== null) destructors.push(_free, pointer)
            return pointer
          },
          argPackAdvance: 8,
          readValueFromPointer: simpleReadValueFromPointer,
          destructorFunction: function (pointer) {
            _free(pointer)
          },
        },
      ]
    })
  },
})
