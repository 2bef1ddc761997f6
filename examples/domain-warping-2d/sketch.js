// Domain warping: noise at a point that is displaced by noise, once and twice.
// From left to right: f(p), f(p + fbm(p)), f(p + fbm(p + fbm(p))), with the same noise.
// After Inigo Quilez, Domain warping, 2002.
let panels

// Returns the noise, from 0 to 1, at p displaced `level` times.
function warpedNoise({ vec2, fbm }, p, level) {
  const f = (point, x, y) =>
    fbm(point.add(vec2(x, y)))
      .mult(0.5)
      .add(0.5)
  if (level === 0) return f(p, 0, 0)
  const q = vec2(f(p, 0, 0), f(p, 5.2, 1.3))
  const moved = p.add(q.mult(4))
  if (level === 1) return f(moved, 0, 0)
  const r = vec2(f(moved, 1.7, 9.2), f(moved, 8.3, 2.8))
  return f(p.add(r.mult(4)), 0, 0)
}

function pictureOf(glsl, level) {
  const uv = glsl.vec2Param('inputs.texCoord')
  const p = uv.mult(glsl.vec2(1.6, 3.6)).add(glsl.param('time').mult(0.03))
  const value = warpedNoise(glsl, p, level)
  const dark = glsl.vec3(0.05, 0.04, 0.1)
  const warm = glsl.vec3(0.85, 0.3, 0.16)
  const light = glsl.vec3(1, 0.9, 0.72)
  const shade = dark.mix(warm, glsl.smoothstep(0.3, 0.55, value))
  return { value, shade: shade.mix(light, glsl.smoothstep(0.48, 0.72, value)) }
}

function setup() {
  createCanvas(640, 480, WEBGL)
  pixelDensity(1)
  noStroke()
  // Hooks are written in GLSL, and in WGSL on WEBGPU.
  const [target, time, begin] =
    webglVersion === WEBGL2
      ? ['glsl300', 'float time', '(Inputs inputs) {']
      : ['wgsl', 'time: f32', '(given: Inputs) { var inputs = given; let time = hooks.time;']
  panels = [0, 1, 2].map((level) => {
    const { code, declarations } = warpjet.compile((glsl) => pictureOf(glsl, level), { target })
    return baseMaterialShader().modify({
      uniforms: { [time]: () => millis() / 1000 },
      fragmentDeclarations: declarations,
      'Inputs getPixelInputs': `${begin}
        ${code}
        inputs.color = vec4(shade, 1.0);
        return inputs;
      }`,
    })
  })
}

function draw() {
  background('#151823')
  panels.forEach((panel, i) => {
    push()
    translate(212 * (i - 1), 0)
    shader(panel)
    plane(200, 450)
    pop()
  })
}
