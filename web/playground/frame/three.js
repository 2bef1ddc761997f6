// In the frame of a sketch with three.js, before the sketch: keeps the text of each warp, which stands within its shaders.
{
  const warps = (window.playground.warps = [])
  const block =
    /\{\n(?:#ifdef USE_TANGENT\n)?(?:(?!\n\{\n)[\s\S])*?transformed = warpjetMoved;|\{\nmat4 warpjetToWorld[\s\S]*?transformed = \( inverse/
  const { shaderSource } = WebGL2RenderingContext.prototype
  WebGL2RenderingContext.prototype.shaderSource = function (shader, text) {
    const [code] = block.exec(text.slice(text.indexOf('void main'))) ?? []
    const isKnown = warps.some(({ made }) => made.code === code)
    if (code && !isKnown) warps.push({ maker: 'warp', made: { code }, only: 'glsl300' })
    return shaderSource.call(this, shader, text)
  }
}
