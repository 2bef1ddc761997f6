/** Draws the first page's ball with its warp in plain WebGL 2. The picture below it stays where that is missing. */
import text from 'virtual:hero-text'

const vertex = `#version 300 es
precision highp float;
in vec3 aPosition;
uniform float uMillis, strength, aspect;
uniform vec3 pointer;
out vec3 vNormal;
out float vHeight;
${text.declarations}
void main() {
  ${text.code}
  vNormal = warpedNormal;
  vHeight = length(warpedPosition) - 1.0;
  vec3 seen = warpedPosition - vec3(0.0, 0.0, 4.2);
  gl_Position = vec4(seen.x * 3.2 / aspect, seen.y * 3.2, -seen.z - 2.0, -seen.z);
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

/** Corners and triangles of a ball of radius 1: a cube's faces, which have no crowded poles, pushed out. */
function ball(detail) {
  const side = detail + 1
  const points = new Float32Array(6 * side * side * 3)
  const triangles = new Uint16Array(6 * detail * detail * 6)
  const steps = Float64Array.from({ length: side }, (_, k) =>
    Math.tan((k / detail - 0.5) * (Math.PI / 2)),
  )
  const quad = [0, side, 1, 1, side, side + 1]
  let point = 0
  let corner = 0
  for (let face = 0; face < 6; face++) {
    const towards = face < 3 ? 1 : -1
    const [first, second, third] = [0, 1, 2].map((axis) => (axis + 2 * face) % 3)
    for (let i = 0; i <= detail; i++)
      for (let j = 0; j <= detail; j++) {
        const [u, v] = [steps[i], steps[j]]
        const scale = 1 / Math.sqrt(1 + u * u + v * v)
        points[3 * point + first] = towards * scale
        points[3 * point + second] = u * towards * scale
        points[3 * point + third] = v * scale
        if (i < detail && j < detail) for (const step of quad) triangles[corner++] = point + step
        point++
      }
  }
  return { points, triangles }
}

function programOf(gl) {
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
  return gl.getProgramParameter(program, gl.LINK_STATUS) ? program : undefined
}

/** Where the pointer meets the ball, or the point of its outline that is nearest. */
function onBall(x, y) {
  const length = Math.hypot(x, y)
  if (length >= 1) return [x / length, y / length, 0]
  return [x, y, Math.sqrt(1 - length * length)]
}

export function startHero(place) {
  const canvas = document.createElement('canvas')
  canvas.setAttribute('aria-hidden', 'true')
  const gl = canvas.getContext('webgl2', { antialias: true, alpha: true })
  const program = gl && programOf(gl)
  if (!program) return
  const { points, triangles } = ball(88)
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer())
  gl.bufferData(gl.ARRAY_BUFFER, points, gl.STATIC_DRAW)
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer())
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW)
  gl.enableVertexAttribArray(0)
  gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0)
  gl.useProgram(program)
  gl.enable(gl.DEPTH_TEST)
  const at = (name) => gl.getUniformLocation(program, name)
  const uniform = {
    millis: at('uMillis'),
    strength: at('strength'),
    aspect: at('aspect'),
    pointer: at('pointer'),
  }

  const wanted = { at: [0.35, 0.4, 0.85], strength: 0.22 }
  const now = { at: [...wanted.at], strength: wanted.strength }
  function draw(time) {
    const { clientWidth, clientHeight } = place
    const density = Math.min(devicePixelRatio, 2)
    const [width, height] = [clientWidth, clientHeight].map((size) => Math.round(size * density))
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height })
    for (let i = 0; i < 3; i++) now.at[i] += (wanted.at[i] - now.at[i]) * 0.12
    now.strength += (wanted.strength - now.strength) * 0.08
    gl.viewport(0, 0, width, height)
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT)
    gl.uniform1f(uniform.millis, time)
    gl.uniform1f(uniform.strength, now.strength)
    gl.uniform1f(uniform.aspect, width / height)
    gl.uniform3fv(uniform.pointer, now.at)
    gl.drawElements(gl.TRIANGLES, triangles.length, gl.UNSIGNED_SHORT, 0)
  }

  place.append(canvas)
  // Whoever wants less motion gets the one picture.
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
    draw(2000)
    new ResizeObserver(() => draw(2000)).observe(place)
    return
  }

  addEventListener('pointermove', ({ clientX, clientY }) => {
    const { left, top, width, height } = place.getBoundingClientRect()
    // A ball of radius 1 takes about so much of the place's height.
    const unit = height * 0.38
    wanted.at = onBall((clientX - left - width / 2) / unit, (top + height / 2 - clientY) / unit)
    wanted.strength = 0.36
  })
  let isSeen = false
  const loop = (time) => {
    if (!isSeen) return
    draw(time)
    requestAnimationFrame(loop)
  }
  new IntersectionObserver(([{ isIntersecting }]) => {
    if (isIntersecting && !isSeen) requestAnimationFrame(loop)
    isSeen = isIntersecting
  }).observe(place)
}
