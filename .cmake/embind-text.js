// Converts std::string for embind with the browser's TextEncoder and TextDecoder. Short ASCII strings use a loop, which takes a third of the
// time. Emscripten's own conversion, in 3.1.6, scans the bytes twice in JavaScript, at 3 to 4 ns per byte, loses the character after a lone
// surrogate, and doesn't check that its allocation succeeds.
mergeInto(LibraryManager.library, {
  $shortText: 64,
  _embind_register_std_string__deps: [
    '$readLatin1String',
    '$registerType',
    '$shortText',
    '$simpleReadValueFromPointer',
    '$throwBindingError',
  ],
  _embind_register_std_string: function (rawType, name) {
    var encoder = new TextEncoder()
    var decoder = new TextDecoder('utf-8', { ignoreBOM: true })
    function allocate(length) {
      var pointer = _malloc(4 + length) >>> 0
      if (!pointer) throw new WebAssembly.RuntimeError('out of memory for a string')
      HEAPU32[pointer >>> 2] = length
      return pointer
    }
    // Writes ASCII. Returns false, and stops, at the first other character.
    function writeAscii(text, start) {
      for (var i = 0; i < text.length; ++i) {
        var code = text.charCodeAt(i)
        if (code > 127) return false
        HEAPU8[start + i] = code
      }
      return true
    }
    function write(text) {
      if (text.length <= shortText) {
        var asciiPointer = allocate(text.length)
        if (writeAscii(text, asciiPointer + 4)) return asciiPointer
        _free(asciiPointer)
      }
      var bytes = encoder.encode(text)
      var pointer = allocate(bytes.length)
      HEAPU8.set(bytes, pointer + 4)
      return pointer
    }
    function read(from, to) {
      if (to - from > shortText) return decoder.decode(HEAPU8.subarray(from, to))
      var text = ''
      for (var i = from; i < to; ++i) {
        if (HEAPU8[i] > 127) return decoder.decode(HEAPU8.subarray(from, to))
        text += String.fromCharCode(HEAPU8[i])
      }
      return text
    }
    registerType(rawType, {
      name: readLatin1String(name),
      fromWireType: function (pointer) {
        pointer >>>= 0
        var text = read(pointer + 4, pointer + 4 + HEAPU32[pointer >>> 2])
        _free(pointer)
        return text
      },
      toWireType: function (destructors, value) {
        if (typeof value != 'string') throwBindingError('expected a string, got ' + typeof value)
        var pointer = write(value)
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
