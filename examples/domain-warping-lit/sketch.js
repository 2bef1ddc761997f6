// A domain warp as a relief: its height is fbm(p + 4r), and its exact gradient, through all
// three levels, gives the normal for p5's lights. The mouse moves one light.
// After Inigo Quilez, Domain warping, 2002.
let relief

function surface(glsl) {
  const { vec2, vec3, smoothstep } = glsl
  const [uv, size] = [glsl.vec2Param('inputs.texCoord'), vec2(2, 1.5)]
  const [p, time] = [uv.mult(size), glsl.param('time')]
  const f = (point, x, y) =>
    glsl
      .fbm(point.add(vec2(x, y)), { octaves: 3 })
      .mult(0.5)
      .add(0.5)
  const q = vec2(f(p, 0, time.mult(0.04)), f(p, 5.2, 1.3))
  const moved = p.add(q.mult(4))
  const r = vec2(f(moved, time.mult(0.06).add(1.7), 9.2), f(moved, 8.3, 2.8))
  const value = f(p.add(r.mult(4)), 0, 0)
  const bronze = vec3(0.2, 0.06, 0.06).mix(vec3(0.95, 0.5, 0.22), smoothstep(0.3, 0.7, value))
  const shade = bronze.mix(vec3(0.1, 0.3, 0.36), smoothstep(0.5, 0.75, r.y()))
  return { value, shade, slope: glsl.gradient(value, uv).div(size) }
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
  const { code, declarations } = warpjet.compile(surface, { target })
  relief = baseMaterialShader().modify({
    uniforms: { [time]: () => millis() / 1000 },
    fragmentDeclarations: declarations,
    'Inputs getPixelInputs': `${begin}
      ${code}
      inputs.normal = normalize(vec3(-0.4 * slope, 1.0));
      inputs.color = vec4(shade, 1.0);
      return inputs;
    }`,
  })
}

function draw() {
  background('#151823')
  ambientLight(60)
  directionalLight(color('#7c8ce0'), 1, 0.4, -0.8)
  pointLight(color('#ffe6c0'), mouseX - width / 2, mouseY - height / 2, 200)
  specularMaterial(100)
  shininess(60)
  shader(relief)
  plane(width - 32, height - 32)
}
