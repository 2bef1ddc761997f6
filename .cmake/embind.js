// What embind calls in JavaScript, only as far as bindings.cpp needs it: functions from and to numbers, truth values
// and texts. Emscripten's own has classes, overloads, and a check of each type and argument, which TypeScript does
// here: 2.5 KB more.
mergeInto(LibraryManager.library, {
  // By the address of the type: std::string, and its kin.
  $textTypes: {},

  // A length, then so many bytes of UTF-8.
  $givenText__deps: ['malloc'],
  $givenText: function (text) {
    var bytes = new TextEncoder().encode(text)
    var address = _malloc(4 + bytes.length)
    HEAPU32[address >> 2] = bytes.length
    HEAPU8.set(bytes, address + 4)
    return address
  },

  $takenText__deps: ['free'],
  $takenText: function (address) {
    var start = address + 4
    var text = new TextDecoder().decode(HEAPU8.subarray(start, start + HEAPU32[address >> 2]))
    _free(address)
    return text
  },

  // The type of the result comes first. Types may be registered after the functions, so they are looked at in a call.
  _embind_register_function__deps: [
    'free',
    '$givenText',
    '$takenText',
    '$textTypes',
    '$getWasmTableEntry',
  ],
  _embind_register_function: function (name, count, types, signature, invoker, context) {
    types = HEAPU32.slice(types >> 2, (types >> 2) + count)
    Module[UTF8ToString(name)] = function (...given) {
      var texts = []
      var values = given.map((value, i) => {
        if (!textTypes[types[i + 1]]) return value
        texts.push((value = givenText(value)))
        return value
      })
      var result = getWasmTableEntry(invoker)(context, ...values)
      texts.forEach(_free)
      return textTypes[types[0]] ? takenText(result) : result
    }
  },

  _embind_register_std_string__deps: ['$textTypes'],
  _embind_register_std_string: function (type) {
    textTypes[type] = true
  },

  // WebAssembly's own conversions do.
  _embind_register_void__deps: [],
  _embind_register_void: function () {},
  _embind_register_bool__deps: [],
  _embind_register_bool: function () {},
  _embind_register_integer__deps: [],
  _embind_register_integer: function () {},
  _embind_register_float__deps: [],
  _embind_register_float: function () {},

  // Types that never cross the border.
  _embind_register_std_wstring__deps: [],
  _embind_register_std_wstring: function () {},
  _embind_register_memory_view__deps: [],
  _embind_register_memory_view: function () {},
  _embind_register_emval__deps: [],
  _embind_register_emval: function () {},
})
