// What embind calls in JavaScript, only as far as bindings.cpp needs it: functions from and to numbers, truth values
// and texts. Emscripten's own has classes, overloads, and a check of each type and argument, which TypeScript does
// here; it and libembind, which registers every type of C++, are left out: 4 KB less.
mergeInto(LibraryManager.library, {
  // By the address that stands for the type.
  $textTypes: {},

  // A length, then so many bytes of UTF-8. `_allocate` and `_release` are bindings.cpp's.
  $givenText: function (text) {
    var bytes = new TextEncoder().encode(text)
    var address = _allocate(4 + bytes.length)
    HEAPU32[address >> 2] = bytes.length
    HEAPU8.set(bytes, address + 4)
    return address
  },

  $takenText: function (address) {
    var start = address + 4
    var text = new TextDecoder().decode(HEAPU8.subarray(start, start + HEAPU32[address >> 2]))
    _release(address)
    return text
  },

  _embind_register_std_string__deps: ['$textTypes'],
  _embind_register_std_string: function (type) {
    textTypes[type] = true
  },

  // The type of the result comes first. WebAssembly's own conversions do for all but texts.
  _embind_register_function__deps: ['$givenText', '$takenText', '$textTypes'],
  _embind_register_function: function (name, count, types, signature, invoker, context) {
    var call = wasmTable.get(invoker)
    var isText = Array.from(HEAPU32.subarray(types >> 2, (types >> 2) + count), (type) => textTypes[type])
    Module[UTF8ToString(name)] = function (...given) {
      var texts = []
      var values = given.map((value, i) => {
        if (!isText[i + 1]) return value
        texts.push((value = givenText(value)))
        return value
      })
      var result = call(context, ...values)
      texts.forEach(_release)
      return isText[0] ? takenText(result) : result
    }
  },
})
