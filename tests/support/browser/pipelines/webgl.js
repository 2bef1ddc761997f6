// For both versions of WebGL: makes programs, binds their inputs, and lets a vertex shader return more floats than it has outputs, in
// several passes. Runs in the page.
import { declareInputs, outputVectors, totalSize } from './text.js'

function compile(gl, type, source) {
  const shader = gl.createShader(type)
  gl.shaderSource(shader, source)
  gl.compileShader(shader)
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
    throw new Error(`${gl.getShaderInfoLog(shader)}\n${source}`)
  return shader
}

/** Links a program, or throws an error with the log and the source. `prepare` may set up transform feedback before linking. */
export function link(gl, vertexSource, fragmentSource, prepare = () => {}) {
  const program = gl.createProgram()
  const shaders = [
    compile(gl, gl.VERTEX_SHADER, vertexSource),
    compile(gl, gl.FRAGMENT_SHADER, fragmentSource),
  ]
  for (const shader of shaders) gl.attachShader(program, shader)
  prepare(program)
  gl.linkProgram(program)
  for (const shader of shaders) gl.deleteShader(shader)
  if (!gl.getProgramParameter(program, gl.LINK_STATUS))
    throw new Error(`${gl.getProgramInfoLog(program)}\n${vertexSource}`)
  return program
}

const floatAt = (i) => `input${i >> 2}.${'xyzw'[i & 3]}`

/**
 * Returns the parts of a vertex shader for a program. `width` is the number of vec4s that one pass returns. `attributes` are the names of
 * the inputs, four floats each. `body` reads them, runs the code, and assigns the vec4s of one pass to `result0`, `result1`, …; the caller
 * declares the uniform `pass`, the index of this pass. `passes` is the number of passes that return all outputs.
 */
export function vertexParts({ code, inputs, outputs }, width) {
  const vectors = outputVectors('glsl', outputs, 'vec4')
  const passes = Math.ceil(vectors.length / width)
  const choices = Array.from({ length: passes }, (_, pass) => {
    const assignments = vectors
      .slice(pass * width, (pass + 1) * width)
      .map((vector, i) => `result${i} = ${vector};`)
    return `if (pass == ${pass}) {\n${assignments.join('\n')}\n}`
  })
  return {
    attributes: Array.from({ length: Math.ceil(totalSize(inputs) / 4) }, (_, i) => `input${i}`),
    body: [declareInputs('glsl', inputs, floatAt), code, ...choices].join('\n'),
    passes,
  }
}

/**
 * Binds `points`, `size` floats each, to the attributes, four floats to each attribute in turn. Returns a function that unbinds them. An
 * attribute that stays enabled without its buffer would break the next draw.
 */
export function bindPoints(gl, program, attributes, points, size) {
  const buffer = gl.createBuffer()
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer)
  gl.bufferData(gl.ARRAY_BUFFER, points, gl.STREAM_DRAW)
  // An input that the code does not read has no location.
  const locations = attributes.map((name) => gl.getAttribLocation(program, name))
  const used = locations.filter((location) => location >= 0)
  locations.forEach((location, i) => {
    if (location < 0) return
    gl.enableVertexAttribArray(location)
    gl.vertexAttribPointer(location, Math.min(4, size - 4 * i), gl.FLOAT, false, 4 * size, 16 * i)
  })
  return () => {
    for (const location of used) gl.disableVertexAttribArray(location)
    gl.deleteBuffer(buffer)
  }
}

/** Declares the images and, for WebGL 1, which has no textureSize(), their sizes. */
export const declareImages = (images) =>
  Object.keys(images)
    .map((name) => `uniform sampler2D ${name};\nuniform vec2 ${name}Size;`)
    .join('\n')

/** Binds the images, with linear filtering, to the current program. Returns a function that deletes them. */
export function bindImages(gl, program, images) {
  const textures = Object.entries(images).map(([name, { width, height, data }], unit) => {
    const texture = gl.createTexture()
    gl.activeTexture(gl.TEXTURE0 + unit)
    gl.bindTexture(gl.TEXTURE_2D, texture)
    for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
      gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE)
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR)
    gl.texImage2D(
      gl.TEXTURE_2D,
      0,
      gl.RGBA,
      width,
      height,
      0,
      gl.RGBA,
      gl.UNSIGNED_BYTE,
      Uint8Array.from(data),
    )
    gl.uniform1i(gl.getUniformLocation(program, name), unit)
    gl.uniform2f(gl.getUniformLocation(program, `${name}Size`), width, height)
    return texture
  })
  // A texture that the caller binds from now on must not replace an image.
  gl.activeTexture(gl.TEXTURE0 + textures.length)
  return () => textures.forEach((texture) => gl.deleteTexture(texture))
}

/** Collects the floats of each point; `readComponent(point, vector, k)` returns component k of one of its vec4s. */
export function collectResults(count, size, readComponent) {
  const results = new Float32Array(count * size)
  for (let point = 0; point < count; point++)
    for (let k = 0; k < size; k++) results[point * size + k] = readComponent(point, k >> 2, k & 3)
  return results
}
