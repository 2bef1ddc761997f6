// Writes TypeScript declarations of the functions that embind binds, from the module's registrations: the module is started with imports
// that only record their arguments. (Emscripten has done the same since 3.1.42, with --emit-tsd.) embind does not
// register parameter names, so they are a, b, c, …
import { setFlagsFromString } from 'node:v8'

// V8 has this proposal only behind a flag: https://github.com/WebAssembly/js-types.
setFlagsFromString('--experimental-wasm-type-reflection')

/** Maps wasm's types → TypeScript's. JavaScript has none for vectors. */
const valueTypes = { i32: 'number', i64: 'bigint', f32: 'number', f64: 'number', v128: 'never' }

const typedArrays = [
  'Int8',
  'Uint8',
  'Int16',
  'Uint16',
  'Int32',
  'Uint32',
  'Float32',
  'Float64',
].map((element) => `${element}Array`)

/** Maps the first group of `pattern` → its second group, for each match in minified glue. */
const matchPairs = (glue, pattern) =>
  Object.fromEntries([...glue.matchAll(pattern)].map(([, key, value]) => [key, value]))

/** Starts the module, and returns its registrations. */
function readRegistrations(glue, module) {
  const fullNamesOfImports = matchPairs(
    glue.match(/asmLibraryArg=\{(.*?)\}/s)[1],
    /"([^"]+)":(\w+)/g,
  )
  const registered = {
    types: new Map(),
    arrays: new Map(),
    enums: new Map(),
    objects: new Map(),
    classes: new Map(),
    functions: [],
  }
  const { types, arrays, enums, objects, classes, functions } = registered
  let memory
  const readText = (at) => {
    const bytes = new Uint8Array(memory.buffer)
    return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)))
  }
  const readList = (count, at) => [...new Uint32Array(memory.buffer, at, count)]
  const setName = (type, typeName) => types.set(type, typeName)
  const register = {
    void: (type) => setName(type, 'void'),
    bool: (type) => setName(type, 'boolean'),
    integer: (type) => setName(type, 'number'),
    float: (type) => setName(type, 'number'),
    std_string: (type) => setName(type, 'string'),
    emval: (type, at) => setName(type, readText(at).replace('emscripten::val', 'unknown')),
    // Our own: see js-bindings/wasm/embind.hpp. `typedArray` is an index into `typedArrays`, or another number for other arrays.
    array: (type, item, typedArray) => arrays.set(type, { item, typedArray }),
    memory_view: (type, typedArray) => setName(type, typedArrays[typedArray]),
    enum(type, at) {
      setName(type, readText(at))
      enums.set(type, { name: readText(at), values: [] })
    },
    enum_value: (type, at) => enums.get(type).values.push(readText(at)),
    value_object(type, at) {
      setName(type, readText(at))
      objects.set(type, { name: readText(at), fields: [] })
    },
    value_object_field: (type, at, field) => objects.get(type).fields.push([readText(at), field]),
    value_array(type, at) {
      setName(type, readText(at))
      objects.set(type, { name: readText(at), elements: [] })
    },
    value_array_element: (type, element) => objects.get(type).elements.push(element),
    class(type, pointer, constPointer, ...others) {
      // The name follows the base class and the signatures and functions of the casts.
      const className = readText(others[7])
      for (const each of [type, pointer, constPointer]) setName(each, className)
      classes.set(type, { name: className, constructors: [], methods: [] })
    },
    class_constructor: (type, count, at) =>
      classes.get(type).constructors.push(readList(count, at)),
    class_function: (type, at, count, types) =>
      classes.get(type).methods.push([readText(at), readList(count, types)]),
    function: (at, count, types) => functions.push([readText(at), readList(count, types)]),
  }
  const imports = {}
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    const [, registration] = /_embind_register_(\w+)/.exec(fullNamesOfImports[name]) ?? []
    ;(imports[from] ??= {})[name] = register[registration] ?? (() => 0)
  }
  const { exports } = new WebAssembly.Instance(module, imports)
  memory = Object.values(exports).find((each) => each instanceof WebAssembly.Memory)
  exports[shortNamesOfExports(glue).___wasm_call_ctors]()
  return registered
}

const shortNamesOfExports = (glue) =>
  matchPairs(glue, /Module\["(\w+)"\]=(?:asm|Module\["asm"\])\["([^"]+)"\]/g)

/** Widens the type of a parameter: any array-like list is accepted, and none is modified. */
const asParameter = (type) => {
  if (typedArrays.includes(type)) return 'ArrayLike<number>'
  return type.endsWith('[]') ? `readonly ${type}` : type
}

const writeParameters = (types) =>
  types.map((type, i) => `${'abcdefghij'[i]}: ${asParameter(type)}`).join(', ')

/** Returns the declarations of the module. `glue` is Emscripten's JavaScript, `wasm` the bytes. */
export function embindTypes(glue, wasm) {
  const module = new WebAssembly.Module(wasm)
  const registered = readRegistrations(glue, module)
  const { types, arrays, enums, objects, classes, functions } = registered
  const writeType = (type) => {
    const array = arrays.get(type)
    if (array) return typedArrays[array.typedArray] ?? `${writeType(array.item)}[]`
    if (types.has(type)) return types.get(type)
    throw new Error(`A binding has a type that is not registered`)
  }
  const writeCall = ([result, ...operands]) =>
    `(${writeParameters(operands.map(writeType))}): ${writeType(result)}`
  const values = [...enums.values()].map(
    ({ name }) => `export interface ${name} { readonly value: number }`,
  )
  const records = [...objects.values()].map(({ name, fields, elements }) =>
    elements
      ? `export type ${name} = readonly [${elements.map(writeType).join(', ')}]`
      : `export interface ${name} { ${fields.map(([field, type]) => `${field}: ${writeType(type)}`).join('; ')} }`,
  )
  const handles = [...classes.values()].map(({ name, methods }) => {
    const members = methods.map(
      ([method, [result, , ...operands]]) => `  ${method}${writeCall([result, ...operands])}\n`,
    )
    return `export interface ${name} {\n${members.join('')}  delete(): void\n}`
  })
  const signatures = new Map(
    WebAssembly.Module.exports(module).map(({ name, type }) => [name, type]),
  )
  const plainExports = Object.entries(shortNamesOfExports(glue))
    .filter(([name]) => /^_[a-z]/.test(name))
    .map(([name, short]) => {
      const { parameters, results } = signatures.get(short)
      const types = parameters.map((type) => valueTypes[type])
      return `  ${name}(${writeParameters(types)}): ${valueTypes[results[0]] ?? 'void'}`
    })
  const bound = [
    ...[...enums.values()].map(
      ({ name, values }) =>
        `  ${name}: { ${values.map((value) => `${value}: ${name}`).join('; ')} }`,
    ),
    ...[...classes.values()].flatMap(({ name, constructors }) =>
      constructors.map(
        ([, ...operands]) =>
          `  ${name}: new (${writeParameters(operands.map(writeType))}) => ${name}`,
      ),
    ),
    ...functions.map(([name, signature]) => `  ${name}${writeCall(signature)}`),
    ...plainExports,
  ]
  return [
    ...values,
    ...records,
    ...handles,
    `export interface Bound {\n${bound.join('\n')}\n}\n`,
  ].join('\n')
}
