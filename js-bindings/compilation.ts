// One compilation: the session in the wasm, and what a sketch asked for so far. All node numbers
// pass through here, and it is closed when the callback is over, whatever happened.
import { type Core, type Emitted, type Session, getCore, graphFull, notFinite } from './core.js'
import { WarpError, describe, shorten } from './errors.js'
import { Expression, placeName, sizeName } from './expression.js'
import { callerOutside } from './source-lines.js'

const largestFloat32 = 3.4028234663852886e38

export const targets = ['glsl300', 'glsl100'] as const

/** A shading language. */
export type Target = (typeof targets)[number]

export interface Output {
  name: string
  value: Expression
  sum?: { input: number; output: number }
}

export class Compilation {
  readonly core: Core = getCore()
  readonly outputs: Output[] = []
  private readonly names = new Set<string>()
  private session: Session | 0
  private readonly inputComponents = new Set<number>()
  private readonly inputLabels: string[] = []
  private readonly inputs = new Map<string, Expression>()
  private readonly comments: Map<number, string> | undefined

  constructor(target: unknown, debug = false) {
    if (!targets.includes(target as Target))
      throw new WarpError(
        `The option "target" must be one of ${targets.join(', ')}, but is ${describe(target)}.`,
      )
    this.session = this.core.open(target as Target)
    this.comments = debug ? new Map() : undefined
  }

  close() {
    if (this.session) this.core._closeSession(this.session)
    this.session = 0
  }

  private open(method: string): Session {
    if (!this.session)
      throw new WarpError(
        `${method}: the function that made this expression is over; use expressions only inside it.`,
      )
    return this.session
  }

  /** A node of the operation number `operation`; `method` names it in messages. */
  node(operation: number, a: number, b: number, c: number, method: string): number {
    const id = this.core._apply(this.open(method), operation, a, b, c)
    if (id < 0) this.refuse(id, method)
    if (this.comments && !this.comments.has(id)) this.comments.set(id, callerOutside())
    return id
  }

  private refuse(id: number, method: string): never {
    if (id === notFinite)
      throw new WarpError(
        `${method}: the result of these constants is not a finite number that a shader can hold.`,
      )
    throw new WarpError(
      `${method}: this warp has more than four million operations; does a loop never end?`,
    )
  }

  constant(value: number, method: string, place: string | number): number {
    const session = this.open(method)
    if (!(Math.abs(value) <= largestFloat32))
      throw new WarpError(
        `${method}: ${placeName(place)} is ${value}, but a shader can only hold numbers between -3.4e38 and 3.4e38.`,
      )
    if (value !== 0 && Math.fround(value) === 0)
      throw new WarpError(
        `${method}: ${placeName(place)} is ${value}, too close to zero for a shader to hold; use 0 instead.`,
      )
    const id = this.core._constant(session, value)
    if (id === graphFull) this.refuse(id, method)
    return id
  }

  /** A variable of the host, by the expression that reads it there. */
  input(label: unknown, size: number, method: string): Expression {
    const session = this.open(method)
    if (typeof label !== 'string')
      throw new WarpError(
        `${method}: the name of a shader variable was expected, but ${describe(label)} came.`,
      )
    const problem = this.core.inputProblem(session, label)
    if (problem)
      throw new WarpError(`${method}: "${shorten(label)}" cannot be read in a shader: ${problem}.`)
    const known = this.inputs.get(label) ?? (size === 1 ? this.componentOf(label) : undefined)
    if (known?.ids.length === size) return known
    if (known)
      throw new WarpError(
        `${method}: "${label}" was read as ${sizeName(known.ids.length)} before, and now as ${sizeName(size)}.`,
      )
    const input = this.core.input(session, label, size)
    this.inputLabels[input] = label
    const ids = Array.from({ length: size }, (_, i) => this.core._component(session, input, i))
    for (const id of ids) {
      if (id < 0) this.refuse(id, method)
      this.inputComponents.add(id)
    }
    const expression = new Expression(this, ids)
    this.inputs.set(label, expression)
    return expression
  }

  /** `position.x` of an input `position`, so that derivatives know that they are the same. */
  private componentOf(label: string): Expression | undefined {
    const [, vector, letter] = /^(.*)\.([xyzw])$/.exec(label) ?? []
    const id = this.inputs.get(vector ?? '')?.ids['xyzw'.indexOf(letter ?? '')]
    return id === undefined ? undefined : new Expression(this, [id])
  }

  /** The partial derivative of each component by a scalar input, or one component of a vector. */
  derivative(value: Expression, input: Expression, method: string): Expression {
    const session = this.open(method)
    if (input.ids.length !== 1)
      throw new WarpError(
        `${method}: a derivative is taken by a single number; choose a component of the vector, such as position.x().`,
      )
    this.requireInput(input, method)
    const ids = value.ids.map((id) => this.core._derivative(session, id, input.ids[0]!))
    for (const id of ids) if (id < 0) this.refuse(id, method)
    return new Expression(this, ids)
  }

  private requireInput(expression: Expression, method: string) {
    if (!expression.ids.every((id) => this.inputComponents.has(id)))
      throw new WarpError(
        `${method}: a derivative is taken by an input such as millis or position.x(), not by something computed.`,
      )
  }

  warpedPosition(position: Expression, offset: Expression): Expression {
    const ids = this.core.warpedPosition(this.open('warp'), position.ids, offset.ids)
    return new Expression(this, ids)
  }

  warpedNormal(position: Expression, normal: Expression, offset: Expression, method: string) {
    const session = this.open(method)
    this.requireInput(position, method)
    if (new Set(position.ids).size !== 3)
      throw new WarpError(`${method}: the position must have three different components.`)
    const ids = this.core.warpedNormal(session, position.ids, normal.ids, offset.ids)
    return new Expression(this, ids)
  }

  /** Asks for a result under a name. */
  output(name: unknown, value: Expression, method: string, sum?: Output['sum']) {
    const session = this.open(method)
    if (typeof name !== 'string')
      throw new WarpError(
        `${method}: the name of a result must be a text, but is ${describe(name)}.`,
      )
    const problem = this.core.outputProblem(session, name)
    if (problem)
      throw new WarpError(`${method}: "${shorten(name)}" cannot name a result: ${problem}.`)
    if (this.names.has(name))
      throw new WarpError(`${method}: there are two results named "${name}"; rename one.`)
    this.names.add(name)
    this.outputs.push({ name, value, sum })
  }

  /** A result that is also the sum of an input and the earlier output number `output`. */
  outputAsSum(name: unknown, value: Expression, label: string, output: number, method: string) {
    this.output(name, value, method, { input: this.inputLabels.indexOf(label), output })
  }

  emit(maxDepth = 8): Emitted & { code: string; labels: string[] } {
    const outputs = this.outputs.map(({ name, value, sum }) => ({ name, ids: value.ids, sum }))
    const comments = [...(this.comments ?? [])].sort(([a], [b]) => a - b)
    const emitted = this.core.emit(
      this.open('emit'),
      outputs,
      Math.min(maxDepth, 2 ** 30),
      comments,
    )
    if (emitted.code === undefined) this.refuse(emitted.problem!, 'A result or its derivative')
    const labels = emitted.inputs.map((input) => this.inputLabels[input]!)
    this.refuseShadowing(labels)
    return { ...emitted, code: emitted.code, labels }
  }

  /** A result named like a variable that the text reads would hide it. */
  private refuseShadowing(labels: string[]) {
    for (const label of labels) {
      const hidden = label.match(/(?<![.\w])[A-Za-z_]\w*/g)?.find((word) => this.names.has(word))
      if (hidden !== undefined)
        throw new WarpError(
          `The result "${hidden}" has the name of a variable that is read for it ("${shorten(label)}"); rename the result.`,
        )
    }
  }
}
