// Shows the intermediate vectors q and r of a domain warp as colours: its value, fbm(p + 4r),
// mixes the first two colours, the length of q mixes in a third, and r.y a fourth. The noise
// for q and r drifts with time, so that the layers drift through each other.
// After Inigo Quilez, Domain warping, 2002.
let picture

function colours(glsl) {
  const { vec2, vec3, smoothstep } = glsl
  const p = glsl.vec2Param('inputs.texCoord').mult(vec2(2.8, 2.1))
  const time = glsl.param('time')
  const f = (point, x, y) =>
    glsl
      .fbm(point.add(vec2(x, y)))
      .mult(0.5)
      .add(0.5)
  const q = vec2(f(p, 0, time.mult(0.05)), f(p, 5.2, 1.3))
  const moved = p.add(q.mult(4))
  const r = vec2(f(moved, time.mult(0.09).add(1.7), 9.2), f(moved, 8.3, time.mult(-0.07).add(2.8)))
  const value = f(p.add(r.mult(4)), 0, 0)

  const night = vec3(0.05, 0.05, 0.13)
  const ember = vec3(0.83, 0.27, 0.13)
  const cream = vec3(1, 0.9, 0.72)
  const sea = vec3(0.06, 0.46, 0.5)
  const shade = night
    .mix(ember, smoothstep(0.25, 0.62, value))
    .mix(cream, smoothstep(0.68, 0.9, q.length()))
    .mix(sea, smoothstep(0.5, 0.68, r.y()))
  return { value, shade: shade.mult(smoothstep(0.1, 0.6, value).mult(1.15)) }
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
  const { code, declarations } = warpjet.compile(colours, { target })
  picture = baseMaterialShader().modify({
    uniforms: { [time]: () => millis() / 1000 },
    fragmentDeclarations: declarations,
    'Inputs getPixelInputs': `${begin}
      ${code}
      inputs.color = vec4(shade, 1.0);
      return inputs;
    }`,
  })
}

function draw() {
  background('#151823')
  shader(picture)
  plane(width - 32, height - 32)
}
