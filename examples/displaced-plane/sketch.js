// The displaced plane of Pagurek's article of 2021: gen writes the height and its two
// slopes for the sketch's own shader.
let waves

function surface(ad) {
  const [x, y, time] = [ad.param('x'), ad.param('y'), ad.param('time')]
  const radius = x.mult(x).add(y.mult(y), 0.002).sqrt()
  const fade = radius.mult(8).add(1)
  const ripples = radius.mult(26).sub(time.mult(3)).sin().div(fade)
  const swell = x.mult(5).add(time).sin().mult(y.mult(4).cos())

  const level = ripples.mult(0.06).add(swell.mult(0.05))
  level.output('height')
  level.outputDeriv('slopeX', x)
  level.outputDeriv('slopeY', y)
}

function water({ vec3, vec3Param, param }) {
  const n = vec3Param('normal').normalize()
  const toLight = vec3(0.4, -0.7, 0.5).normalize()
  const halfway = toLight.add(vec3(0, 0, 1)).normalize()
  const light = n.dot(toLight).max(0).mult(0.8).add(0.3)
  const shine = n.dot(halfway).max(0).pow(60)
  const [deep, shallow] = [vec3(0.09, 0.3, 0.5), vec3(0.35, 0.85, 0.75)]
  const color = deep.mix(shallow, param('level').mult(6).add(0.5))
  return { shade: color.mult(light).add(shine) }
}

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  const [target, shaders] = webglVersion === WEBGL2 ? ['glsl300', inGLSL] : ['wgsl', inWGSL]
  const heights = warpjet.gen(surface, { target })
  const { code } = warpjet.compile(water, { target })
  waves = createShader(...shaders(heights, code))
}

const inGLSL = (heights, waterCode) => [
  `#version 300 es
  in vec3 aPosition;
  uniform mat4 uModelViewMatrix, uProjectionMatrix;
  uniform mat3 uNormalMatrix;
  uniform float time;
  out vec3 normal;
  out float level;
  void main() {
    float x = aPosition.x, y = aPosition.y;
    ${heights}
    normal = uNormalMatrix * vec3(-slopeX, -slopeY, 1.0);
    level = height;
    gl_Position = uProjectionMatrix * uModelViewMatrix * vec4(x, y, height, 1.0);
  }`,
  `#version 300 es
  precision highp float;
  in vec3 normal;
  in float level;
  out vec4 color;
  void main() {
    ${waterCode}
    color = vec4(shade, 1.0);
  }`,
]

// Writes the same shaders in WGSL, for WEBGPU.
const inWGSL = (heights, waterCode) => [
  `struct Uniforms {
    uModelViewMatrix: mat4x4f,
    uProjectionMatrix: mat4x4f,
    uNormalMatrix: mat3x3f,
    time: f32,
  }
  @group(0) @binding(0) var<uniform> uniforms: Uniforms;
  struct Vertex {
    @location(0) aPosition: vec3f,
  }
  struct Moved {
    @builtin(position) place: vec4f,
    @location(0) normal: vec3f,
    @location(1) level: f32,
  }
  @vertex fn main(vertex: Vertex) -> Moved {
    let x = vertex.aPosition.x;
    let y = vertex.aPosition.y;
    let time = uniforms.time;
    ${heights}
    let place = uniforms.uModelViewMatrix * vec4(x, y, height, 1.0);
    let normal = uniforms.uNormalMatrix * vec3(-slopeX, -slopeY, 1.0);
    return Moved(uniforms.uProjectionMatrix * place, normal, height);
  }`,
  `@fragment fn main(@location(0) normal: vec3f, @location(1) level: f32) -> @location(0) vec4f {
    ${waterCode}
    return vec4(shade, 1.0);
  }`,
]

function draw() {
  background('#151823')
  orbitControl()
  rotateX(1.1)
  rotateZ(millis() / 9000)
  scale(410)
  shader(waves)
  waves.setUniform('time', millis() / 1000)
  plane(1, 1, 120, 120)
}
