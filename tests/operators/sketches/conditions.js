// Sketches with conditions, loops and logic.
export const sketches = {
  'if and else': {
    setup: `wave = createWarp(({ position }) => {
      let lift = 0
      if (position.y > 0.2) lift = 0.3
      else if (position.y < -0.2) lift = position.y * 0.5
      return [lift, 0, 0]
    })`,
    twin: ({ glsl, position: { y } }) =>
      glsl.vec3(y.gt(0.2).ifElse(0.3, y.lt(-0.2).ifElse(y.mult(0.5), 0)), 0, 0),
  },
  'a ternary, and logic': {
    setup: `wave = createWarp(({ position: { x, y } }) => [x > 0 && y > 0 ? 0.3 : x * 0.2, !(y < 0) || x > 0.5 ? 0.2 : 0, 0])`,
    twin: ({ glsl, position: { x, y } }) =>
      glsl.vec3(
        x.gt(0).and(y.gt(0)).ifElse(0.3, x.mult(0.2)),
        y.ge(0).or(x.gt(0.5)).ifElse(0.2, 0),
        0,
      ),
  },
  'one number || another': {
    setup: `wave = createWarp(({ position: { x, y }, uniforms }) => {
      let amount = uniforms.amount || 0.3
      let other = max(y, 0)
      other ||= 0.1
      return [amount * y, other * 0.5, (x > 0) && 0.2]
    }, { uniforms: { amount: 0 } })`,
    twin: ({ glsl, position: { x, y } }) => {
      const other = y.max(0)
      return glsl.vec3(
        y.mult(0.3),
        other.gt(0).ifElse(other, 0.1).mult(0.5),
        x.gt(0).ifElse(0.2, 0),
      )
    },
  },
  'a boolean variable': {
    setup: `wave = createWarp(({ position }) => {
      let isTop = false
      if (position.y > 0) isTop = true
      return isTop ? [0.2, 0, 0] : position * -0.3
    })`,
    twin: ({ glsl, position }) =>
      position.y.gt(0).ifElse(glsl.vec3(0.2, 0, 0), position.mult(-0.3)),
  },
  'an early return': {
    setup: `wave = createWarp(({ position }) => {
      if (position.y < 0) return [0, 0, 0]
      return [position.y * 0.5, 0, 0]
    })`,
    twin: ({ glsl, position: { y } }) => glsl.vec3(y.max(0).mult(0.5), 0, 0),
  },
  'a loop': {
    setup: `wave = createWarp(({ position, millis }) => {
      let sum = 0
      for (let i = 1; i <= 4; i++) {
        if (i % 2 === 0) continue
        sum += sin(position.x * i * 3 + millis / 1000) / i
      }
      return [0, sum * 0.2, 0]
    })`,
    twin: ({ glsl, position: { x }, millis }) => {
      const waveOf = (i) =>
        x
          .mult(3 * i)
          .add(millis.div(1000))
          .sin()
          .div(i)
      return glsl.vec3(0, waveOf(1).add(waveOf(3)).mult(0.2), 0)
    },
  },
  'a loop whose end depends on the vertex': {
    setup: `wave = createWarp(({ position }) => {
      let n = 0
      while (position.x > n) n++
      return position * n
    })`,
    error: /A loop cannot depend on a condition that differs by vertex/,
  },
  'a switch that depends on the vertex': {
    setup: `wave = createWarp(({ position }) => {
      switch (floor(position.x)) {
        case 0: return position * 0.2
        default: return position * 0.1
      }
    })`,
    error: /A switch cannot depend on a condition that differs by vertex/,
  },
  'a mode of the sketch': {
    top: `const mode = 'twist'`,
    setup: `wave = createWarp(({ glsl, position }) => {
      switch (mode) {
        case 'twist': return glsl.rotateZ(position.y * 0.8) * position - position
        default: return position * 0.1
      }
    })`,
    twin: ({ glsl, position }) => glsl.rotateZ(position.y.mult(0.8)).mult(position).sub(position),
  },
  'components of a vector': {
    setup: `wave = createWarp(({ position }) => {
      let [x, y, z] = position
      x *= 0.5
      return [x - position.x, sin(z * 4) * 0.1, 0]
    })`,
    twin: ({ glsl, position: { x, z } }) => glsl.vec3(x.mult(-0.5), z.mult(4).sin().mult(0.1), 0),
  },
  'the bits of a number': {
    setup: `wave = createWarp(({ position: { x, y } }) => [(y * 5 | 0) / 20, ~~(x * 4) / 20, 0])`,
    twin: ({ glsl, position: { x, y } }) =>
      glsl.vec3(y.mult(5).trunc().div(20), x.mult(4).trunc().div(20), 0),
  },
  defaults: {
    setup: `wave = createWarp(({ position }) => {
      const bump = ({ at = 0, amount = 0.1 * 2 } = {}) => amount * sin((position.x - at) * 5)
      return [0, bump({ at: 0.3 }), bump()]
    })`,
    twin: ({ glsl, position: { x } }) =>
      glsl.vec3(0, x.sub(0.3).mult(5).sin().mult(0.2), x.mult(5).sin().mult(0.2)),
  },
}
