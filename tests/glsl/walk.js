// Shader text in double, for tests alone: a walk over the tree that an independent parser makes of the whole language. It shares
// nothing with the front end. Values carry their types, so that nothing is known before it is run.
import { createRequire } from 'node:module'
import { builtIns, ofKind } from './built-ins.js'

const require = createRequire(import.meta.url)
const { parser } = require('@shaderfrog/glsl-parser')
const { preprocess } = require('@shaderfrog/glsl-parser/preprocessor')

const fail = (sentence) => {
  throw new SyntaxError(`the walk: ${sentence}`)
}

/** What numbers a type has: { kind, columns, rows }, or nothing of structures and arrays. */
function layoutOf(type) {
  const [, letter, size] = /^([iub]?)vec(\d)$/.exec(type) ?? []
  if (size) {
    const kind = { '': 'float', i: 'int', u: 'uint', b: 'bool' }[letter]
    return { kind, columns: 1, rows: Number(size) }
  }
  const [, columns, rows = columns] = /^mat(\d)(?:x(\d))?$/.exec(type) ?? []
  if (columns) return { kind: 'float', columns: Number(columns), rows: Number(rows) }
  return /^(?:float|u?int|bool)$/.test(type) ? { kind: type, columns: 1, rows: 1 } : undefined
}
const matrixType = (columns, rows) => (columns === rows ? `mat${rows}` : `mat${columns}x${rows}`)

const wrap = { int: (x) => x | 0, uint: (x) => x >>> 0, float: (x) => x }
const convert = {
  float: Number,
  int: (x) => Math.trunc(Number(x)) | 0,
  uint: (x) => Math.trunc(Number(x)) >>> 0,
  bool: Boolean,
}
const operations = {
  '+': (x, y) => x + y,
  '-': (x, y) => x - y,
  '*': (x, y, kind) => (kind === 'float' ? x * y : Math.imul(x, y)),
  '/': (x, y, kind) => (kind === 'float' ? x / y : Math.trunc(x / y)),
  '%': (x, y) => x % y,
  '&': (x, y) => x & y,
  '|': (x, y) => x | y,
  '^': (x, y) => x ^ y,
  '<<': (x, y) => x << y,
  '>>': (x, y, kind) => (kind === 'uint' ? x >>> y : x >> y),
}
const comparisons = {
  '<': (x, y) => x < y,
  '>': (x, y) => x > y,
  '<=': (x, y) => x <= y,
  '>=': (x, y) => x >= y,
}

/** Numbers of a variable or of their own: those of `of` at the places `at`. */
const part = (type, of, at) => ({ type, of, at })
const numbersOf = ({ of, at }) => at.map((place) => of[place])

/** Those that read the arguments vary; all others are known to a shader's compiler, and count in float32. */
const varying = new WeakSet()
const vary = (...values) => values.some(({ of }) => varying.has(of))
function fresh(type, numbers, isVarying) {
  const of = isVarying || layoutOf(type)?.kind !== 'float' ? numbers : numbers.map(Math.fround)
  if (isVarying) varying.add(of)
  return part(type, of, [...of.keys()])
}
function write({ of, at }, numbers, isVarying) {
  at.forEach((place, i) => (of[place] = numbers[i]))
  if (isVarying) varying.add(of)
  else if (at.length === of.length) varying.delete(of)
}

class Return {
  constructor(value) {
    this.value = value
  }
}
const [Break, Continue] = [Symbol('break'), Symbol('continue')]

class Walk {
  constructor(program) {
    this.program = program
    this.functions = []
    this.structures = {}
    this.restart()
  }

  /** Globals start anew in each call from outside, as they do for each vertex. */
  restart() {
    this.scopes = [new Map()]
    this.functions.length = 0
    for (const node of this.program) {
      if (node.type === 'function') this.functions.push(node)
      else this.statement(node)
    }
  }

  call(name, numbers) {
    this.restart()
    const f = this.functions.find(({ prototype }) => prototype.header.name.identifier === name)
    const operands = f.prototype.parameters.map((each, i) =>
      fresh(this.typeOf(each), numbers[i], true),
    )
    return numbersOf(this.enter(f, operands))
  }

  // types

  sizeOf(type) {
    const [, element, count] = /^(.*)\[(\d+)\]$/.exec(type) ?? []
    if (element) return this.sizeOf(element) * Number(count)
    const layout = layoutOf(type)
    if (layout) return layout.columns * layout.rows
    return this.structures[type].reduce((sum, field) => sum + this.sizeOf(field.type), 0)
  }

  /** Of what has a specifier, and perhaps a length after its name. */
  typeOf({ specifier, quantifier }) {
    const word = specifier.specifier ?? specifier
    const named = word.type === 'struct' ? this.structure(word) : (word.token ?? word.identifier)
    return [specifier.quantifier, quantifier].reduce(
      (type, lengths) => this.lengthened(type, lengths),
      named,
    )
  }
  lengthened(type, lengths) {
    const text = ({ expression }) => (expression ? numbersOf(this.value(expression))[0] : '')
    return (lengths ?? []).reduce((name, each) => `${name}[${text(each)}]`, type)
  }

  structure({ typeName, declarations }) {
    const fields = declarations.flatMap(({ declaration }) =>
      declaration.declarations.map(({ identifier, quantifier }) => ({
        name: identifier.identifier,
        type: this.lengthened(this.typeOf(declaration.specified_type), quantifier),
      })),
    )
    this.structures[typeName.identifier] = fields
    return typeName.identifier
  }

  // names

  declare(name, type, numbers, isVarying = false) {
    const start = numbers ?? Array(this.sizeOf(type)).fill(0)
    this.scopes.at(-1).set(name, fresh(type, [...start], isVarying))
  }

  find(name) {
    for (let i = this.scopes.length - 1; i >= 0; i--)
      if (this.scopes[i].has(name)) return this.scopes[i].get(name)
    return fail(`${name} is not declared`)
  }

  within(work) {
    this.scopes.push(new Map())
    const result = work()
    this.scopes.pop()
    return result
  }

  // statements: each gives how it ends, or nothing where the next one follows

  statement(node) {
    return (this[node.type] ?? fail(`no ${node.type} is known`)).call(this, node)
  }
  sequence(nodes) {
    for (const node of nodes) {
      const end = this.statement(node)
      if (end) return end
    }
    return undefined
  }
  compound_statement({ statements }) {
    return this.within(() => this.sequence(statements))
  }
  declaration_statement({ declaration }) {
    return this.statement(declaration)
  }
  precision() {}
  preprocessor() {}
  declarator_list({ specified_type, declarations }) {
    const base = this.typeOf(specified_type)
    for (const { identifier, quantifier, initializer } of declarations) {
      const value = initializer && this.value(initializer)
      const type = value?.type ?? this.lengthened(base, quantifier)
      this.declare(identifier.identifier, type, value && numbersOf(value), value && vary(value))
    }
  }
  expression_statement({ expression }) {
    if (expression) this.value(expression)
  }
  if_statement({ condition, body, else: otherwise }) {
    const chosen = this.test(condition) ? body : [otherwise].flat().at(-1)
    return chosen ? this.within(() => this.statement(chosen)) : undefined
  }
  for_statement({ init, condition, operation, body }) {
    return this.within(() => {
      if (init) init.type === 'declarator_list' ? this.statement(init) : this.value(init)
      return this.loop(condition, body, operation)
    })
  }
  while_statement({ condition, body }) {
    return this.loop(condition, body)
  }
  do_statement({ expression, body }) {
    return this.loop(expression, body, undefined, true)
  }
  loop(condition, body, step, isLate = false) {
    for (let isFirst = true; (isFirst && isLate) || this.test(condition); isFirst = false) {
      const end = this.within(() => this.statement(body))
      if (end === Break) return undefined
      if (end instanceof Return) return end
      if (step) this.value(step)
    }
    return undefined
  }
  switch_statement({ expression, cases }) {
    const [by] = numbersOf(this.value(expression))
    const isMeant = ({ type, test }) =>
      type === 'switch_case' && numbersOf(this.value(test))[0] === by
    const found = cases.findIndex(isMeant)
    const first = found >= 0 ? found : cases.findIndex(({ type }) => type === 'default_case')
    if (first < 0) return undefined
    const end = this.within(() =>
      this.sequence(cases.slice(first).flatMap(({ statements }) => statements)),
    )
    return end === Break ? undefined : end
  }
  break_statement() {
    return Break
  }
  continue_statement() {
    return Continue
  }
  return_statement({ expression }) {
    return new Return(expression && this.copy(this.value(expression)))
  }

  // expressions

  copy(value) {
    return fresh(value.type, numbersOf(value), vary(value))
  }
  test(node) {
    return numbersOf(this.value(node))[0]
  }
  value(node) {
    return (this[`value_${node.type}`] ?? fail(`no ${node.type} is known`)).call(this, node)
  }
  value_group({ expression }) {
    return this.value(expression)
  }
  value_identifier({ identifier }) {
    return this.find(identifier)
  }
  value_float_constant({ token }) {
    return fresh('float', [parseFloat(token)])
  }
  value_int_constant({ token }) {
    const isUnsigned = /u$/i.test(token)
    const digits = token.replace(/u$/i, '')
    const number = Number(/^0\d/.test(digits) ? `0o${digits}` : digits)
    return isUnsigned ? fresh('uint', [number]) : fresh('int', [number | 0])
  }
  value_uint_constant(node) {
    return this.value_int_constant(node)
  }
  value_bool_constant({ token }) {
    return fresh('bool', [token === 'true'])
  }
  value_ternary({ expression, left, right }) {
    return this.copy(this.value(this.test(expression) ? left : right))
  }
  value_unary({ operator, expression }) {
    const op = operator.literal
    if (op === '++' || op === '--') return this.step(this.value(expression), op)
    const of = this.value(expression)
    const { kind } = layoutOf(of.type)
    const f = {
      '-': (x) => wrap[kind](-x),
      '+': (x) => x,
      '!': (x) => !x,
      '~': (x) => wrap[kind](~x),
    }
    return fresh(of.type, numbersOf(of).map(f[op]), vary(of))
  }
  step(place, op) {
    const { kind } = layoutOf(place.type)
    const by = op === '++' ? 1 : -1
    write(
      place,
      numbersOf(place).map((x) => wrap[kind](x + by)),
      vary(place),
    )
    return place
  }
  value_postfix({ expression, postfix }) {
    let value = this.value(expression)
    for (let next = postfix; next; next = next.type === 'postfix' ? next.postfix : undefined) {
      const one = next.type === 'postfix' ? next.expression : next
      if (one.type === 'field_selection') value = this.select(value, one.selection.identifier)
      else if (one.type === 'quantifier') value = this.element(value, this.value(one.expression))
      else {
        const before = this.copy(value)
        this.step(value, one.literal)
        return before
      }
    }
    return value
  }
  select({ type, of, at }, name) {
    const fields = this.structures[type]
    if (!fields) {
      const places = [...name].map((letter) =>
        Math.max(...['xyzw', 'rgba', 'stpq'].map((letters) => letters.indexOf(letter))),
      )
      const { kind } = layoutOf(type)
      const chosen = places.length === 1 ? kind : ofKind(kind, `vec${places.length}`)
      return part(
        chosen,
        of,
        places.map((place) => at[place]),
      )
    }
    let offset = 0
    for (const field of fields) {
      const size = this.sizeOf(field.type)
      if (field.name === name) return part(field.type, of, at.slice(offset, offset + size))
      offset += size
    }
    return fail(`${type} has no ${name}`)
  }
  element({ type, of, at }, index) {
    const [, inner] = /^(.*)\[\d+\]$/.exec(type) ?? []
    const layout = layoutOf(type)
    const element = inner ?? (layout.columns > 1 ? `vec${layout.rows}` : layout.kind)
    const size = this.sizeOf(element)
    const [i] = numbersOf(index)
    return part(element, of, at.slice(i * size, (i + 1) * size))
  }
  value_assignment({ left, operator, right }) {
    const place = this.value(left)
    const op = operator.literal.slice(0, -1)
    const given = this.value(right)
    const value = op ? this.operate(op, place, given) : given
    write(place, numbersOf(value), vary(value))
    return place
  }
  value_binary({ operator, left, right }) {
    const op = operator.literal
    if (op === ',') return (this.value(left), this.value(right))
    if (op === '&&') return fresh('bool', [this.test(left) && this.test(right)])
    if (op === '||') return fresh('bool', [this.test(left) || this.test(right)])
    const first = this.copy(this.value(left))
    return this.operate(op, first, this.value(right))
  }
  operate(op, left, right) {
    const [x, y] = [numbersOf(left), numbersOf(right)]
    if (op === '^^') return fresh('bool', [x[0] !== y[0]])
    if (op === '==' || op === '!=')
      return fresh('bool', [x.every((number, i) => number === y[i]) === (op === '==')])
    if (comparisons[op]) return fresh('bool', [comparisons[op](x[0], y[0])])
    const [a, b] = [layoutOf(left.type), layoutOf(right.type)]
    if (op === '*' && Math.max(a.columns, b.columns) > 1 && x.length > 1 && y.length > 1)
      return multiplied(a, x, b, y, vary(left, right))
    const f = operations[op]
    const type = x.length >= y.length ? left.type : right.type
    const at = (list, i) => list[list.length === 1 ? 0 : i]
    const size = Math.max(x.length, y.length)
    return fresh(
      type,
      Array.from({ length: size }, (_, i) => wrap[a.kind](f(at(x, i), at(y, i), a.kind))),
      vary(left, right),
    )
  }

  value_function_call({ identifier, args }) {
    const given = args.filter(({ type, token }) => type !== 'literal' && token !== 'void')
    if (identifier.type === 'postfix') return fresh('int', [this.lengthOf(identifier)])
    const word =
      identifier.specifier?.identifier ?? identifier.identifier ?? identifier.specifier.token
    const own = this.functions.filter(({ prototype }) => prototype.header.name.identifier === word)
    const operands = given.map((node) => this.value(node))
    const types = operands.map(({ type }) => type)
    const fits = ({ prototype }) =>
      `${(prototype.parameters ?? []).filter(isNamed).map((each) => this.typeOf(each))}` ===
      `${types}`
    const f = own.find(fits)
    if (f) return this.enter(f, operands)
    if (builtIns[word] || word === 'transpose' || word === 'modf')
      return this.builtIn(word, operands)
    return this.construct(this.typeOf({ specifier: identifier }), operands)
  }
  lengthOf({ expression }) {
    const name = expression.identifier?.identifier ?? expression.identifier
    return Number(/\[(\d+)\]$/.exec(this.find(name).type)[1])
  }
  enter({ prototype, body }, operands) {
    const parameters = (prototype.parameters ?? []).filter(isNamed)
    const outer = this.scopes
    this.scopes = [outer[0], new Map()]
    parameters.forEach((each, i) =>
      this.declare(
        each.identifier.identifier,
        this.typeOf(each),
        numbersOf(operands[i]),
        vary(operands[i]),
      ),
    )
    const held = this.scopes
    const end = this.sequence(body.statements)
    this.scopes = held
    parameters.forEach((each, i) => {
      if ((each.qualifier ?? []).some(({ token }) => /out/.test(token))) {
        const value = this.find(each.identifier.identifier)
        write(operands[i], numbersOf(value), vary(value))
      }
    })
    this.scopes = outer
    return end?.value
  }
  builtIn(name, operands) {
    const lists = operands.map(numbersOf)
    const types = operands.map(({ type }) => type)
    const isVarying = vary(...operands)
    if (name === 'transpose') {
      const { columns, rows } = layoutOf(types[0])
      const turned = Array.from(
        lists[0],
        (_, i) => lists[0][(i % columns) * rows + Math.floor(i / columns)],
      )
      return fresh(matrixType(rows, columns), turned, isVarying)
    }
    if (name === 'modf') {
      write(operands[1], lists[0].map(Math.trunc), isVarying)
      return fresh(
        types[0],
        lists[0].map((x) => x - Math.trunc(x)),
        isVarying,
      )
    }
    const { type, run } = builtIns[name]
    const widest =
      types[
        lists.findIndex(({ length }) => length === Math.max(...lists.map((list) => list.length)))
      ]
    return fresh(type ? type(...types) : widest, run(...lists), isVarying)
  }
  construct(named, operands) {
    const all = operands.flatMap(numbersOf)
    const type = named.endsWith('[]') ? named.replace('[]', `[${operands.length}]`) : named
    const layout = layoutOf(type)
    const isVarying = vary(...operands)
    if (!layout) return fresh(type, all, isVarying)
    const { kind, columns, rows } = layout
    const size = columns * rows
    const from = layoutOf(operands[0].type)
    const isAlone = operands.length === 1
    const diagonal = (i, one, other) => (Math.floor(i / rows) === i % rows ? one : other)
    const number = (i) => {
      if (isAlone && columns > 1 && all.length === 1) return diagonal(i, all[0], 0)
      if (isAlone && columns > 1 && from.columns > 1) {
        const [column, row] = [Math.floor(i / rows), i % rows]
        if (column < from.columns && row < from.rows) return all[column * from.rows + row]
        return diagonal(i, 1, 0)
      }
      return all[isAlone && all.length === 1 ? 0 : i]
    }
    return fresh(
      type,
      Array.from({ length: size }, (_, i) => convert[kind](number(i))),
      isVarying,
    )
  }
}

/** `f(void)` has none. */
const isNamed = ({ identifier }) => identifier

/** A vector before a matrix is a row, one after it a column. */
function multiplied(a, x, b, y, isVarying) {
  const [rows, inner] = a.columns > 1 ? [a.rows, a.columns] : [1, a.rows]
  const columns = b.columns > 1 ? b.columns : 1
  const at = (row, k) => (a.columns > 1 ? x[k * rows + row] : x[k])
  const numbers = Array.from({ length: columns * rows }, (_, i) => {
    const [column, row] = [Math.floor(i / rows), i % rows]
    let sum = 0
    for (let k = 0; k < inner; k++) sum += at(row, k) * y[column * inner + k]
    return sum
  })
  const size = Math.max(columns, rows)
  return fresh(
    columns > 1 && rows > 1 ? matrixType(columns, rows) : `vec${size}`,
    numbers,
    isVarying,
  )
}

/** A function of a text, of lists of numbers: `walk(text, 'f')([1, 2, 3])` calls `f` with a vec3. */
export function walk(text, name) {
  const tree = parser.parse(preprocess(text, { preserve: { version: () => true } }), {
    quiet: true,
  })
  const walk = new Walk(tree.program)
  return (...numbers) => walk.call(name, numbers)
}
