// How embind converts a std::string: by the browser's own encoder and decoder. Emscripten 3.1.6 scans the bytes twice in JavaScript, at 3 to
// 4 ns a byte, loses the character after a lone surrogate, and does not check the memory that it allocates.
mergeInto(LibraryManager.library, {
  _embind_register_std_string__deps: [
    '$readLatin1String',
    '$registerType',
    '$simpleReadValueFromPointer',
    '$throwBindingError',
  ],
  _embind_register_std_string: function (rawType, name) {
    var encoder = new TextEncoder()
    var decoder = new TextDecoder('utf-8', { ignoreBOM: true })
    registerType(rawType, {
      name: readLatin1String(name),
      fromWireType: function (pointer) {
        pointer >>>= 0
        var text = decoder.decode(
          HEAPU8.subarray(pointer + 4, pointer + 4 + HEAPU32[pointer >>> 2]),
        )
        _free(pointer)
        return text
      },
      toWireType: function (destructors, value) {
        if (typeof value != 'string') throwBindingError('expected a string, got ' + typeof value)
        var bytes = encoder.encode(value)
        var pointer = _malloc(4 + bytes.length) >>> 0
        if (!pointer) throw new WebAssembly.RuntimeError('no memory for a text')
        HEAPU32[pointer >>> 2] = bytes.length
        HEAPU8.set(bytes, pointer + 4)
        if (destructors !== null) destructors.push(_free, pointer)
        return pointer
      },
      argPackAdvance: 8,
      readValueFromPointer: simpleReadValueFromPointer,
      destructorFunction: function (pointer) {
        _free(pointer)
      },
    })
  },
})
