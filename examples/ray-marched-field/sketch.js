// A distance field, ray-marched in a fragment shader. Light needs the field's gradient.
// Left: the gradient from four more evaluations, the common way. Right: the gradient from
// one evaluation of a function that warpjet generates from the source. This function
// returns value and gradient.
const { compile, differentiate } = warpjet

const field = `
  uniform float time;

  float blend(float a, float b, float k) {
    float h = clamp(0.5 + 0.5 * (b - a) / k, 0.0, 1.0);
    return mix(b, a, h) - k * h * (1.0 - h);
  }

  float map(vec3 p) {
    float d = length(p) - 0.55;
    for (int i = 0; i < 5; i++) {
      float a = 1.2566 * float(i) + 0.6 * time;
      vec3 c = 0.72 * vec3(cos(a), sin(2.0 * a + time) * 0.6, sin(a));
      d = blend(d, length(p - c) - 0.22, 0.22);
    }
    return d + 0.02 * sin(14.0 * p.x) * sin(14.0 * p.y) * sin(14.0 * p.z);
  }
`

let sampled, exact, times

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  times = createP().style('color', '#ccd')
  const { target, fourTimes, once, marcher } = webglVersion === WEBGL2 ? inGLSL : inWGSL
  sampled = marcher(fourTimes)
  exact = marcher(`${differentiate(field, { function: 'map', by: 'p', target })} ${once}`)
}

const inGLSL = {
  target: 'glsl300',
  fourTimes: `vec3 slope(vec3 p) {
    vec2 e = vec2(0.001, -0.001);
    return e.xyy * map(p + e.xyy) + e.yyx * map(p + e.yyx) +
      e.yxy * map(p + e.yxy) + e.xxx * map(p + e.xxx);
  }`,
  once: 'vec3 slope(vec3 p) { return mapGradient(p).yzw; }',
  marcher: (slope) =>
    createShader(
      `#version 300 es
      in vec3 aPosition;
      in vec2 aTexCoord;
      out vec2 at;
      uniform mat4 uModelViewMatrix, uProjectionMatrix;
      void main() {
        at = aTexCoord * 2.0 - 1.0;
        gl_Position = uProjectionMatrix * uModelViewMatrix * vec4(aPosition, 1.0);
      }`,
      `#version 300 es
      precision highp float;
      in vec2 at;
      out vec4 color;
      ${field}
      ${slope}
      void main() {
        vec3 eye = vec3(0.0, 0.0, 2.6), way = normalize(vec3(at.x, -at.y * 1.4, -1.9));
        float far = 0.0;
        for (int i = 0; i < 48; i++) far += 0.85 * map(eye + far * way);
        vec3 n = normalize(slope(eye + far * way));
        float light = max(dot(n, normalize(vec3(0.6, 0.8, 0.7))), 0.0);
        float rim = pow(1.0 - max(-dot(n, way), 0.0), 3.0);
        vec3 lit = vec3(0.1, 0.12, 0.2) + vec3(0.9, 0.55, 0.4) * light + 0.3 * rim;
        color = vec4(far < 4.0 ? lit : vec3(0.082, 0.094, 0.137), 1.0);
      }`,
    ),
}

// On WEBGPU, a hook of p5 does the same. warpjet translates the field into WGSL.
const inWGSL = {
  target: 'wgsl',
  fourTimes: `fn slope(p: vec3f) -> vec3f {
    let e = vec2(0.001, -0.001);
    return e.xyy * map(p + e.xyy) + e.yyx * map(p + e.yyx) +
      e.yxy * map(p + e.yxy) + e.xxx * map(p + e.xxx);
  }`,
  once: 'fn slope(p: vec3f) -> vec3f { return mapGradient(p).yzw; }',
  marcher(slope) {
    const distance = (glsl) => ({ d: glsl.source(field)(glsl.vec3Param('p')) })
    const { code } = compile(distance, { target: 'wgsl' })
    return baseMaterialShader().modify({
      uniforms: { 'time: f32': () => 0 },
      fragmentDeclarations: `var<private> time: f32;
      fn map(p: vec3f) -> f32 { ${code} return d; }
      ${slope}`,
      'Inputs getPixelInputs': `(given: Inputs) {
        var inputs = given;
        time = hooks.time;
        let at = 2.0 * inputs.texCoord - 1.0;
        let eye = vec3(0.0, 0.0, 2.6);
        let way = normalize(vec3(at.x, -1.4 * at.y, -1.9));
        var far = 0.0;
        for (var i = 0; i < 48; i++) { far += 0.85 * map(eye + far * way); }
        let n = normalize(slope(eye + far * way));
        let light = max(dot(n, normalize(vec3(0.6, 0.8, 0.7))), 0.0);
        let rim = pow(1.0 - max(-dot(n, way), 0.0), 3.0);
        let lit = vec3(0.1, 0.12, 0.2) + vec3(0.9, 0.55, 0.4) * light + 0.3 * rim;
        inputs.color = vec4(select(vec3(0.082, 0.094, 0.137), lit, far < 4.0), 1.0);
        return inputs;
      }`,
    })
  },
}

function draw() {
  background('#151823')
  const ms = [panel(-160, sampled), panel(160, exact)].map(average)
  if (isTimed() && frameCount % 30 === 0)
    times.html(`four evaluations ${ms[0].toFixed(1)} ms, one function ${ms[1].toFixed(1)} ms`)
}

const means = []
const average = (time, i) => (means[i] = lerp(means[i] ?? time, time, 0.1))

// Only WEBGL can be timed: there, reading a pixel waits for the GPU.
const isTimed = () => 'readPixels' in drawingContext

function panel(x, march) {
  const pixel = new Uint8Array(4)
  const wait = () => isTimed() && drawingContext.readPixels(0, 0, 1, 1, 6408, 5121, pixel)
  wait()
  const start = performance.now()
  push()
  translate(x, 0)
  shader(march)
  march.setUniform('time', millis() / 1000)
  plane(310, 440)
  pop()
  wait()
  return performance.now() - start
}
