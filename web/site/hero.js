/** Draws the first page's warped ball in plain WebGL 2. Without WebGL 2 the picture below it stays visible. */
import shaderCode from 'virtual:hero-text'
import { buildBall } from './ball.js'
import { finishFrame, sleep } from './pace.js'

const vertex = `#version 300 es
precision highp float;
in vec3 aPosition;
uniform float uMillis, strength, aspect;
uniform vec3 pointer;
out vec3 vNormal;
out float vHeight;
${shaderCode.declarations}
void main() {
  ${shaderCode.code}
  vNormal = warpedNormal;
  vHeight = length(warpedPosition) - 1.0;
  vec3 viewPosition = warpedPosition - vec3(0.0, 0.0, 4.2);
  gl_Position = vec4(viewPosition.x * 3.2 / aspect, viewPosition.y * 3.2, -viewPosition.z - 2.0, -viewPosition.z);
}`

const fragment = `#version 300 es
precision highp float;
in vec3 vNormal;
in float vHeight;
out vec4 color;
void main() {
  vec3 n = normalize(vNormal);
  vec3 low = vec3(0.25, 0.16, 0.45), high = vec3(1.0, 0.54, 0.36), top = vec3(1.0, 0.83, 0.52);
  vec3 base = mix(mix(low, high, smoothstep(-0.06, 0.07, vHeight)), top, smoothstep(0.08, 0.34, vHeight));
  vec3 key = normalize(vec3(0.5, 0.75, 0.65)), fill = normalize(vec3(-0.85, -0.1, 0.25));
  float shine = pow(max(dot(n, normalize(key + vec3(0.0, 0.0, 1.0))), 0.0), 42.0);
  vec3 light = vec3(0.2, 0.19, 0.26) + vec3(1.0, 0.95, 0.88) * max(dot(n, key), 0.0)
    + vec3(0.18, 0.3, 0.75) * max(dot(n, fill), 0.0);
  float rim = pow(1.0 - max(n.z, 0.0), 3.0);
  color = vec4(base * light + shine * 0.5 + rim * vec3(0.12, 0.2, 0.42), 1.0);
}`

/** Compiles and links the program without blocking the page, if the driver can compile in parallel. */
async function linkProgram(gl) {
  const parallel = gl.getExtension('KHR_parallel_shader_compile')
  const program = gl.createProgram()
  for (const [kind, source] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ]) {
    const shader = gl.createShader(kind)
    gl.shaderSource(shader, source)
    gl.compileShader(shader)
    gl.attachShader(program, shader)
  }
  gl.bindAttribLocation(program, 0, 'aPosition')
  gl.linkProgram(program)
  const isComplete = () =>
    !parallel ||
    gl.isContextLost() ||
    gl.getProgramParameter(program, parallel.COMPLETION_STATUS_KHR)
  while (!isComplete()) await sleep(10)
  return gl.getProgramParameter(program, gl.LINK_STATUS) ? program : undefined
}

/** Returns the point of the ball under the pointer, or the nearest point of its outline. */
function pointOnBall(x, y) {
  const length = Math.hypot(x, y)
  if (length >= 1) return [x / length, y / length, 0]
  return [x, y, Math.sqrt(1 - length * length)]
}

export async function startHero(place) {
  const canvas = document.createElement('canvas')
  canvas.setAttribute('aria-hidden', 'true')
  const gl = canvas.getContext('webgl2', { antialias: true, alpha: true })
  if (!gl) return
  // Each of these steps can take long, so let the browser respond between them.
  await sleep(0)
  const program = await linkProgram(gl)
  if (!program) return
  await sleep(0)
  const { points, triangles, coarse: coarseIndexCount } = buildBall(102)
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer())
  gl.bufferData(gl.ARRAY_BUFFER, points, gl.STATIC_DRAW)
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer())
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW)
  gl.enableVertexAttribArray(0)
  gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0)
  gl.useProgram(program)
  gl.enable(gl.DEPTH_TEST)
  const locate = (name) => gl.getUniformLocation(program, name)
  const uniform = {
    millis: locate('uMillis'),
    strength: locate('strength'),
    aspect: locate('aspect'),
    pointer: locate('pointer'),
  }

  const target = { pointer: [0.35, 0.4, 0.85], strength: 0.22 }
  const current = { pointer: [...target.pointer], strength: target.strength }
  // Start with the coarse ball: without a GPU, its frames take a quarter of the time of the fine ball's frames.
  let isFine = false
  let last = performance.now()
  function draw(time) {
    const { clientWidth, clientHeight } = place
    const density = Math.min(devicePixelRatio, 2)
    const [width, height] = [clientWidth, clientHeight].map((size) => Math.round(size * density))
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height })
    // Exponential smoothing by elapsed time, so that the speed does not depend on the frame rate.
    const elapsed = performance.now() - last
    last += elapsed
    const towards = (from, to, slowness) => to + (from - to) * Math.exp(-elapsed / slowness)
    current.pointer = current.pointer.map((from, i) => towards(from, target.pointer[i], 130))
    current.strength = towards(current.strength, target.strength, 200)
    gl.viewport(0, 0, width, height)
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.uniform1f(uniform.millis, time)
    gl.uniform1f(uniform.strength, current.strength)
    gl.uniform1f(uniform.aspect, width / height)
    gl.uniform3fv(uniform.pointer, current.pointer)
    if (isFine)
      gl.drawElements(
        gl.TRIANGLES,
        triangles.length - coarseIndexCount,
        gl.UNSIGNED_SHORT,
        coarseIndexCount * triangles.BYTES_PER_ELEMENT,
      )
    else gl.drawElements(gl.TRIANGLES, coarseIndexCount, gl.UNSIGNED_SHORT, 0)
  }

  place.append(canvas)
  // With reduced motion, draw a single picture.
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
    isFine = true
    draw(2000)
    new ResizeObserver(() => draw(2000)).observe(place)
    return
  }

  addEventListener('pointermove', ({ clientX, clientY }) => {
    const { left, top, width, height } = place.getBoundingClientRect()
    // The ball's radius in pixels, about 0.38 of the height.
    const unit = height * 0.38
    target.pointer = pointOnBall(
      (clientX - left - width / 2) / unit,
      (top + height / 2 - clientY) / unit,
    )
    target.strength = 0.36
  })
  let isSeen = false
  let isRunning = false
  let slowFrames = 0
  let mayBeFine = true
  async function run() {
    if (isRunning) return
    isRunning = true
    while (isSeen) {
      draw(await new Promise(requestAnimationFrame))
      const isFast = await finishFrame(gl)
      slowFrames = isFast ? 0 : slowFrames + 1
      // After ten slow frames in a row, return to the coarse ball for good.
      if (isFine && slowFrames === 10) mayBeFine = isFine = false
      else if (isFast) isFine = mayBeFine
    }
    isRunning = false
  }
  new IntersectionObserver(([{ isIntersecting }]) => {
    isSeen = isIntersecting
    void run()
  }).observe(place)
}
