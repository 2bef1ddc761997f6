// Writes TypeScript declarations of the functions that embind binds, from the module's own registrations: the module is started with imports
// that only record their arguments. (Emscripten does the same since 3.1.42, by --emit-tsd.) C++ does not register parameter names.
import { wasmSignatures } from './wasm-signatures.mjs'

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
const pairs = (glue, pattern) =>
  Object.fromEntries([...glue.matchAll(pattern)].map(([, key, value]) => [key, value]))

/** Starts the module, and returns its registrations. */
function registrations(glue, module) {
  const importNames = pairs(glue.match(/asmLibraryArg=\{(.*?)\}/s)[1], /"([^"]+)":(\w+)/g)
  const found = {
    types: new Map(),
    arrays: new Map(),
    enums: new Map(),
    objects: new Map(),
    classes: new Map(),
    functions: [],
    constants: [],
  }
  const { types, arrays, enums, objects, classes, functions, constants } = found
  let memory
  const text = (at) => {
    const bytes = new Uint8Array(memory.buffer)
    return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)))
  }
  const list = (count, at) => [...new Uint32Array(memory.buffer, at, count)]
  const name = (type, spelled) => types.set(type, spelled)
  const register = {
    void: (type) => name(type, 'void'),
    bool: (type) => name(type, 'boolean'),
    integer: (type) => name(type, 'number'),
    float: (type) => name(type, 'number'),
    std_string: (type) => name(type, 'string'),
    emval: (type, at) => name(type, text(at).replace('emscripten::val', 'unknown')),
    array: (type, item, kind) => arrays.set(type, { item, kind }),
    memory_view: (type, kind) => name(type, typedArrays[kind]),
    enum(type, at) {
      name(type, text(at))
      enums.set(type, { name: text(at), values: [] })
    },
    enum_value: (type, at) => enums.get(type).values.push(text(at)),
    value_object(type, at) {
      name(type, text(at))
      objects.set(type, { name: text(at), fields: [] })
    },
    value_object_field: (type, at, field) => objects.get(type).fields.push([text(at), field]),
    value_array(type, at) {
      name(type, text(at))
      objects.set(type, { name: text(at), elements: [] })
    },
    value_array_element: (type, element) => objects.get(type).elements.push(element),
    class(type, pointer, constPointer, ...others) {
      const spelled = text(others[7])
      for (const each of [type, pointer, constPointer]) name(each, spelled)
      classes.set(type, { name: spelled, constructors: [], methods: [] })
    },
    class_constructor: (type, count, at) => classes.get(type).constructors.push(list(count, at)),
    class_function: (type, at, count, types) =>
      classes.get(type).methods.push([text(at), list(count, types)]),
    function: (at, count, types) => functions.push([text(at), list(count, types)]),
    constant: (at, type) => constants.push([text(at), type]),
  }
  const imports = {}
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    const [, kind] = /_embind_register_(\w+)/.exec(importNames[name]) ?? []
    ;(imports[from] ??= {})[name] = register[kind] ?? (() => 0)
  }
  const { exports } = new WebAssembly.Instance(module, imports)
  memory = Object.values(exports).find((each) => each instanceof WebAssembly.Memory)
  exports[exportNames(glue).___wasm_call_ctors]()
  return found
}

const exportNames = (glue) => pairs(glue, /Module\["(\w+)"\]=(?:asm|Module\["asm"\])\["([^"]+)"\]/g)

/** Widens the type of a parameter: any array-like list is accepted, and none is modified. */
const asParameter = (type) => {
  if (typedArrays.includes(type)) return 'ArrayLike<number>'
  return type.endsWith('[]') ? `readonly ${type}` : type
}

const parameters = (types) =>
  types.map((type, i) => `${'abcdefghij'[i]}: ${asParameter(type)}`).join(', ')

/** Returns the declarations of the module. `glue` is Emscripten's JavaScript, `wasm` the bytes. */
export function embindTypes(glue, wasm) {
  const { types, arrays, enums, objects, classes, functions, constants } = registrations(
    glue,
    new WebAssembly.Module(wasm),
  )
  const spell = (type) => {
    const array = arrays.get(type)
    if (array) return typedArrays[array.kind] ?? `${spell(array.item)}[]`
    if (types.has(type)) return types.get(type)
    throw new Error(`A binding has a type that is not registered`)
  }
  const call = ([result, ...given]) => `(${parameters(given.map(spell))}): ${spell(result)}`
  const values = [...enums.values()].map(
    ({ name }) => `export interface ${name} { readonly value: number }`,
  )
  const records = [...objects.values()].map(({ name, fields, elements }) =>
    elements
      ? `export type ${name} = readonly [${elements.map(spell).join(', ')}]`
      : `export interface ${name} { ${fields.map(([field, type]) => `${field}: ${spell(type)}`).join('; ')} }`,
  )
  const handles = [...classes.values()].map(({ name, methods }) => {
    const own = methods.map(
      ([method, [result, , ...given]]) => `  ${method}${call([result, ...given])}\n`,
    )
    return `export interface ${name} {\n${own.join('')}  delete(): void\n}`
  })
  const signatures = wasmSignatures(wasm)
  const plain = Object.entries(exportNames(glue))
    .filter(([name, short]) => /^_[a-z]/.test(name) && signatures.has(short))
    .map(([name, short]) => {
      const { given, result } = signatures.get(short)
      return `  ${name}(${parameters(given)}): ${result}`
    })
  const bound = [
    ...[...enums.values()].map(
      ({ name, values }) =>
        `  ${name}: { ${values.map((value) => `${value}: ${name}`).join('; ')} }`,
    ),
    ...[...classes.values()].flatMap(({ name, constructors }) =>
      constructors.map(
        ([, ...given]) => `  ${name}: new (${parameters(given.map(spell))}) => ${name}`,
      ),
    ),
    ...functions.map(([name, signature]) => `  ${name}${call(signature)}`),
    ...constants.map(([name, type]) => `  readonly ${name}: ${spell(type)}`),
    ...plain,
  ]
  return [
    ...values,
    ...records,
    ...handles,
    `export interface Bound {\n${bound.join('\n')}\n}\n`,
  ].join('\n')
}
