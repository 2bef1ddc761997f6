// Runs in the playground's frame after p5's libraries and before the sketch: records each warp that the sketch makes, and draws normals
// as colours if the page asks for that.
{
  const { playground } = window
  const { compileWarp } = window.warpjet

  for (const methods of [p5.prototype, p5.Graphics.prototype]) {
    const { createWarp } = methods
    methods.createWarp = function (offset, options, ...rest) {
      const withSliders = playground.withSliders(options, { readsOnce: true })
      const warp = createWarp.call(this, offset, withView(withSliders), ...rest)
      const { surfaceVariation = true, space = 'local' } = options ?? {}
      playground.record(
        'createWarp',
        () =>
          playground.withLines(
            compileWarp(toPlainOffset(offset, options), {
              uniforms: withSliders?.uniforms,
              surfaceVariation,
              debug: true,
            }),
          ),
        {
          surfaceVariation,
          space,
          radius: space === 'local' ? 1 : 150,
          declared: Object.keys(withSliders?.uniforms ?? {}),
          shapes,
        },
      )
      return warp
    }
  }

  // The shape that was last drawn with a shader of the sketch, with its model matrix.
  let lastShape
  const { Renderer3D, RendererGL } = p5
  const [renderers, method] = Renderer3D
    ? [Renderer3D.prototype, '_drawGeometry']
    : [RendererGL.prototype, 'drawBuffers']
  const draw = renderers[method]
  renderers[method] = function (geometryOrId, ...rest) {
    const { userFillShader, uModelMatrix } = this.states ?? this
    const geometry = this.retainedMode?.geometry[geometryOrId]?.model ?? geometryOrId
    if (userFillShader && geometry?.faces?.length)
      lastShape = { geometry, matrix: [...(uModelMatrix.mat4 ?? uModelMatrix)] }
    return draw.call(this, geometryOrId, ...rest)
  }

  /** Returns the shape as arrays for mesh.js. */
  function shapes() {
    if (!lastShape) return []
    const { vertices, vertexNormals, uvs, faces } = lastShape.geometry
    const flat = (list) => Float32Array.from(list.flatMap(({ x, y, z }) => [x, y, z]))
    const arrays = {
      positions: flat(vertices),
      normals: flat(vertexNormals),
      uvs: uvs.length === 2 * vertices.length ? Float32Array.from(uvs) : undefined,
      indices: Uint32Array.from(faces.flat()),
    }
    return [{ ...arrays, matrix: lastShape.matrix, isUpsideDown: true }]
  }

  /** Converts an offset function to one that `compileWarp` accepts, which supports neither operators nor `returns: 'position'`. */
  function toPlainOffset(offsetFunction, { scope, returns } = {}) {
    const operators = window[Symbol.for('warpjet.operators')]
    const offset = operators?.(offsetFunction, scope) ?? offsetFunction
    if (returns !== 'position') return offset
    return (inputs) => inputs.glsl.sub(offset(inputs), inputs.position)
  }
  const withView = (options) =>
    playground.view === 'normals' ? { ...options, type: 'normal' } : options

  // The page may lack the script for GLSL; reading `differentiate` without it throws.
  const { compile, gen } = window.warpjet
  const hasGLSL = Object.hasOwn(window.warpjet, 'differentiate')
  const differentiate = hasGLSL && window.warpjet.differentiate
  Object.assign(window.warpjet, playground.recordAll({ compile, compileWarp, gen, differentiate }))
}
