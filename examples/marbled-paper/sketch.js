// Marbled paper: every pixel looks up the paint at a point that is displaced by noise,
// which is itself displaced by noise.
// The paint is a p5.Graphics, mirrored beyond its edges.
// After Inigo Quilez, Domain warping, 2002.
let paint, paper

function marble(glsl) {
  const [uv, time] = [glsl.vec2Param('inputs.texCoord'), glsl.param('time')]
  const drift = (point, x, y) =>
    glsl.vec2(
      point.add(glsl.vec2(x, time.mult(0.06))).fbm({ octaves: 3 }),
      point.add(glsl.vec2(time.mult(-0.05), y)).fbm({ octaves: 3, seed: 1 }),
    )
  const q = drift(uv.mult(2), 0, 5.2)
  const r = drift(uv.mult(2).add(q), 1.7, 9.2)
  // uSampler is the image that draw() passes to texture().
  const color = glsl.texture('uSampler', uv.add(r.mult(0.45)), {
    filter: 'bicubic',
    wrap: 'mirror',
  })
  // The paint is darker where the noise compresses it.
  return { color: color.mult(r.length().mult(-0.5).add(1.1)) }
}

function setup() {
  createCanvas(640, 480, WEBGL)
  pixelDensity(1)
  noStroke()
  paint = paintStripes()
  // Hooks are written in GLSL, and in WGSL on WEBGPU.
  const [target, time, begin] =
    webglVersion === WEBGL2
      ? ['glsl300', 'float time', '(Inputs inputs) {']
      : ['wgsl', 'time: f32', '(given: Inputs) { var inputs = given; let time = hooks.time;']
  const { code, declarations } = warpjet.compile(marble, { target })
  paper = baseMaterialShader().modify({
    uniforms: { [time]: () => millis() / 1000 },
    fragmentDeclarations: declarations,
    'Inputs getPixelInputs': `${begin}
      ${code}
      inputs.color = vec4(color.rgb, 1.0);
      return inputs;
    }`,
  })
}

function paintStripes() {
  const paint = createGraphics(320, 240)
  paint.pixelDensity(1)
  paint.background('#f3e9d7')
  paint.noStroke()
  const colors = ['#1d3557', '#e4572e', '#f3e9d7', '#2a9d8f', '#f3e9d7', '#e9b44c']
  for (let i = 0; i < 16; i++) {
    paint.fill(colors[i % colors.length])
    paint.rect(20 * i, 0, 13, 240)
  }
  paint.fill('#e4572e')
  paint.circle(160, 120, 90)
  paint.fill('#f3e9d7')
  paint.circle(160, 120, 60)
  return paint
}

function draw() {
  background('#151823')
  shader(paper)
  texture(paint)
  plane(600, 440)
}
