// A reference for the time of generation: a plain JavaScript graph (interned objects in a Map, forward derivatives with respect to three
// inputs, one statement per node) of the stacked sines in the paper's performance test. It packs no vectors, folds little and schedules
// nothing, so its time shows only how fast the machine is at such work. The benchmark measures it in turn with warpjet.
// sineWarp and plainGraph take the number of sines per component: 200 ≈ 3,006 builder nodes.
let state
const random = (low, high) => {
  state = (state * 1664525 + 1013904223) >>> 0
  return low + ((high - low) * state) / 4294967296
}

/** The offset function of the same warp, for compileWarp. */
export const sineWarp = (count) => {
  state = 7
  return ({ glsl, position, millis }) => {
    const axes = [position.x(), position.y(), position.z()]
    return glsl.vec3(
      ...[0, 1, 2].map(() => {
        let sum = glsl.val(0)
        for (let i = 0; i < count; i++)
          sum = sum.add(
            axes[Math.floor(random(0, 3))]
              .mult(random(1e-4, 1e-3))
              .add(millis.mult(random(1e-4, 1e-2)))
              .sin()
              .mult(random(1, 500)),
          )
        return sum.div(count)
      }),
    )
  }
}

/** Builds the graph, differentiates it and writes its source; returns the length of the source. */
export function plainGraph(count) {
  state = 7
  const nodes = []
  const interned = new Map()
  const node = (op, a = -1, b = -1, value = 0) => {
    const key = `${op},${a},${b},${value}`
    let id = interned.get(key)
    if (id === undefined) interned.set(key, (id = nodes.push({ op, a, b, value }) - 1))
    return id
  }
  const constant = (value) => node('constant', -1, -1, value)
  const isZero = (id) => nodes[id].op === 'constant' && nodes[id].value === 0
  const multiply = (a, b) => (isZero(a) ? a : isZero(b) ? b : node('*', a, b))
  const add = (a, b) => (isZero(a) ? b : isZero(b) ? a : node('+', a, b))
  const inputs = ['x', 'y', 'z', 't'].map((name) => node('input', -1, -1, name))
  const outputs = [0, 1, 2].map(() => {
    let sum = constant(0)
    for (let i = 0; i < count; i++) {
      const axis = multiply(inputs[Math.floor(random(0, 3))], constant(random(1e-4, 1e-3)))
      const angle = add(axis, multiply(inputs[3], constant(random(1e-4, 1e-2))))
      sum = add(sum, multiply(node('sin', angle), constant(random(1, 500))))
    }
    return multiply(sum, constant(1 / count))
  })
  const roots = [...outputs]
  for (const input of inputs.slice(0, 3)) {
    const size = nodes.length
    const derivative = new Int32Array(size)
    for (let i = 0; i < size; i++) {
      const { op, a, b } = nodes[i]
      if (op === 'constant') derivative[i] = constant(0)
      else if (op === 'input') derivative[i] = constant(i === input ? 1 : 0)
      else if (op === '+') derivative[i] = add(derivative[a], derivative[b])
      else if (op === '*')
        derivative[i] = add(multiply(derivative[a], b), multiply(a, derivative[b]))
      else derivative[i] = multiply(node('cos', a), derivative[a])
    }
    for (const output of outputs) roots.push(derivative[output])
  }
  const isUsed = new Uint8Array(nodes.length)
  const pending = [...roots]
  while (pending.length) {
    const id = pending.pop()
    if (id < 0 || isUsed[id]) continue
    isUsed[id] = 1
    pending.push(nodes[id].a, nodes[id].b)
  }
  let source = ''
  nodes.forEach(({ op, a, b, value }, id) => {
    if (!isUsed[id]) return
    if (op === 'constant' || op === 'input') source += `float t${id} = ${value};\n`
    else if (op === '+' || op === '*') source += `float t${id} = t${a} ${op} t${b};\n`
    else source += `float t${id} = ${op}(t${a});\n`
  })
  return source.length
}
