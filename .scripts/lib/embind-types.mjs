// Writes TypeScript declarations of the functions that embind binds, from the module's registrations: the module is started with imports
// that only record their arguments. (Emscripten does the same since 3.1.42, by --emit-tsd.) C++ does not register parameter names.
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
].map((kind) => `${kind}Array`)

/** Reads the pairs of short and full names that match `pattern` in minified glue. */
const matchPairs = (glue, pattern) =>
  Object.fromEntries([...glue.matchAll(pattern)].map(([, key, value]) => [key, value]))

/** Starts the module, and returns its registrations. */
function readRegistrations(glue, module) {
  const importNames = matchPairs(glue.match(/asmLibraryArg=\{(.*?)\}/s)[1], /"([^"]+)":(\w+)/g)
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
  const setName = (type, spelled) => types.set(type, spelled)
  const register = {
    void: (type) => setName(type, 'void'),
    bool: (type) => setName(type, 'boolean'),
    integer: (type) => setName(type, 'number'),
    float: (type) => setName(type, 'number'),
    std_string: (type) => setName(type, 'string'),
    emval: (type, at) => setName(type, readText(at).replace('emscripten::val', 'unknown')),
    array: (type, item, kind) => arrays.set(type, { item, kind }),
    memory_view: (type, kind) => setName(type, typedArrays[kind]),
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
      const spelled = readText(others[7])
      for (const each of [type, pointer, constPointer]) setName(each, spelled)
      classes.set(type, { name: spelled, constructors: [], methods: [] })
    },
    class_constructor: (type, count, at) =>
      classes.get(type).constructors.push(readList(count, at)),
    class_function: (type, at, count, types) =>
      classes.get(type).methods.push([readText(at), readList(count, types)]),
    function: (at, count, types) => functions.push([readText(at), readList(count, types)]),
  }
  const imports = {}
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    const [, kind] = /_embind_register_(\w+)/.exec(importNames[name]) ?? []
    ;(imports[from] ??= {})[name] = register[kind] ?? (() => 0)
  }
  const { exports } = new WebAssembly.Instance(module, imports)
  memory = Object.values(exports).find((each) => each instanceof WebAssembly.Memory)
  exports[exportNames(glue).___wasm_call_ctors]()
  return registered
}

const exportNames = (glue) =>
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
    if (array) return typedArrays[array.kind] ?? `${writeType(array.item)}[]`
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
  const plainExports = Object.entries(exportNames(glue))
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
