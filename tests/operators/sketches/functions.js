// Sketches with the functions of p5, of Math and of p5.strands.
export const sketches = {
  'map() with clamping': {
    setup: `wave = createWarp(({ position }) => [0, 0, map(position.y, -0.5, 0.5, -0.3, 0.3, true)])`,
    twin: ({ glsl, position: { y } }) => glsl.vec3(0, 0, y.mult(0.6).clamp(-0.3, 0.3)),
  },
  'map, lerp, constrain and norm': {
    setup: `wave = createWarp(({ position: { x, y, z } }) => [
      map(y, -1, 1, 0, 0.4), lerp(0, 0.3, z), constrain(x, -0.2, 0.2) + norm(x, 0, 10),
    ])`,
    twin: ({ glsl, position: { x, y, z } }) =>
      glsl.vec3(y.add(1).mult(0.2), z.mult(0.3), x.clamp(-0.2, 0.2).add(x.div(10))),
  },
  'angleMode(DEGREES)': {
    setup: `angleMode(DEGREES)
    wave = createWarp(({ position: { x, y } }) => [sin(y * 360) * 0.2, atan2(y, x) / 1000, 0])`,
    twin: ({ glsl, position: { x, y } }) =>
      glsl.vec3(
        y
          .mult(2 * Math.PI)
          .sin()
          .mult(0.2),
        y.atan(x).mult(180 / Math.PI / 1000),
        0,
      ),
  },
  'max and min of arrays': {
    setup: `wave = createWarp(({ position: { x, y, z } }) => [max([x, y, z]) * 0.3, min([x, y, 0.1]) * 0.3, 0])`,
    twin: ({ glsl, position: { x, y, z } }) =>
      glsl.vec3(x.max(y).max(z).mult(0.3), x.min(y).min(0.1).mult(0.3), 0),
  },
  'steps made with round and floor': {
    setup: `wave = createWarp(({ position: { x, y } }) => [round(y * 4) / 20, floor(x * 3) / 20, round(2.5) / 20])`,
    twin: ({ glsl, position: { x, y } }) =>
      glsl.vec3(y.mult(4).add(0.5).floor().div(20), x.mult(3).floor().div(20), 0.15),
  },
  noise: {
    setup: `wave = createWarp(({ position: { x, y, z } }) => [0, 0, noise(x * 2, y * 2, z * 2)])`,
    twin: ({ glsl, position }) =>
      glsl.vec3(0, 0, position.mult(2).fbm({ octaves: 4 }).mult(0.5).add(0.5)),
    warning:
      /^noise: p5's noise\(\) works on numbers; for expressions it becomes warpjet's glsl.fbm/,
  },
  'dist and mag': {
    setup: `wave = createWarp(({ position: { x, y, z } }) => [0, 0, dist(x, y, 0.2, 0.1) * 0.5 - mag(x, z) * 0.2])`,
    twin: ({ glsl, position: { x, y, z } }) =>
      glsl.vec3(
        0,
        0,
        glsl
          .vec2(x.sub(0.2), y.sub(0.1))
          .length()
          .mult(0.5)
          .sub(glsl.vec2(x, z).length().mult(0.2)),
      ),
  },
  createVector: {
    setup: `wave = createWarp(({ position }) => {
      const v = createVector(sin(position.y * 5), 0, cos(position.x * 5))
      const w = createVector(0.1, 0.2, 0)
      return v.mult(0.2) + w
    })`,
    twin: ({ glsl, position: { x, y } }) =>
      glsl.vec3(y.mult(5).sin().mult(0.2).add(0.1), 0.2, x.mult(5).cos().mult(0.2)),
  },
  'a createVector vector that is changed in place': {
    setup: `wave = createWarp(({ position }) => {
      const v = createVector(sin(position.y * 5), 0, 0)
      v.mult(0.2)
      return v
    })`,
    warning: /^v\.mult\(0\.2\) has no effect: .* v = v\.mult\(2\)/,
  },
  'a p5 vector whose components are assigned': {
    setup: `wave = createWarp(({ position }) => {
      const v = createVector(0.1, 0.2, 0.3)
      v.x = sin(position.y * 5) * 0.2
      return v
    })`,
    twin: ({ glsl, position: { y } }) => glsl.vec3(y.mult(5).sin().mult(0.2), 0.2, 0.3),
  },
  'new p5.Vector with expressions': {
    setup: `wave = createWarp(({ position, normal }) => {
      const v = p5.Vector.sub(position, createVector(0.3, 0, 0))
      return p5.Vector.mult(v, -0.4)
    })`,
    twin: ({ glsl, position }) => position.sub(glsl.vec3(0.3, 0, 0)).mult(-0.4),
  },
  'the function names of p5.strands': {
    setup: `wave = createWarp(({ position, normal }) => {
      const edge = smoothstep(-0.5, 0.5, position.y) * step(0, position.x)
      return mix(vec3(0, 0, 0), normalize(position) * clamp(length(position.xz), 0, 0.5), edge)
        + cross(position, vec3(0, 0.2, 0)) * dot(normalize(position), vec3(0, 1, 0))
    })`,
    twin: ({ glsl, position }) => {
      const edge = glsl.smoothstep(-0.5, 0.5, position.y).mult(glsl.step(0, position.x))
      return position
        .normalize()
        .mult(position.xz.length().clamp(0, 0.5))
        .mult(edge)
        .add(glsl.cross(position, glsl.vec3(0, 0.2, 0)).mult(position.normalize().y))
    },
  },
  'an unknown p5 function': {
    setup: `wave = createWarp(({ position }) => [randomGaussian(position.x, 1) * 0.1, 0, 0])`,
    error: /p5's randomGaussian works on numbers, not on expressions of a warp/,
  },
  'the functions of Math': {
    setup: `wave = createWarp(({ position: { x, y } }) => [
      Math.sin(y * Math.PI) * 0.2, Math.pow(Math.abs(x), 1.5) * 0.2, Math.atan2(y, x + 2) * 0.2,
    ])`,
    twin: ({ glsl, position: { x, y } }) =>
      glsl.vec3(
        y.mult(Math.PI).sin().mult(0.2),
        x.abs().pow(1.5).mult(0.2),
        y.atan(x.add(2)).mult(0.2),
      ),
  },
}
