// A shadow map, which p5 lacks. First the warped shape is drawn as seen from the light into a
// p5.Framebuffer that stores depths; then it is drawn with lights, but darker where something is nearer to the light.
// Needs p5 2: p5 1.11 has other cameras for framebuffers.
let nearest, eye, far, lit, farTower, litTower

function setup() {
  createCanvas(640, 480, WEBGL)
  camera(-645, -465, 495, 0, -60, 0)
  nearest = createFramebuffer({ width: 1024, height: 1024, density: 1, format: HALF_FLOAT })
  eye = nearest.createCamera()
  // On WEBGPU, only the farther half of this range of depths is visible.
  eye.ortho(-350, 350, -350, 350, -2000, 2000)
  eye.camera(360, -800, 480, 0, 0, 0, 0, 1, 0)
  far = baseColorShader().modify(() => {
    const world = sharedVec3()
    getWorldInputs((inputs) => {
      world = inputs.position
      return inputs
    })
    getFinalColor(() => [1000 + dot(world, [0.36, -0.8, 0.48]), 0, 0, 1])
  })
  lit = baseMaterialShader().modify(() => {
    const world = sharedVec3()
    const depths = uniformTexture(() => nearest)
    getWorldInputs((inputs) => {
      world = inputs.position
      return inputs
    })
    getFinalColor((color) => {
      const seenFromLight = [dot(world, [0.8, 0, -0.6]), dot(world, [0.48, 0.6, 0.64])]
      const nearness = 1000 + dot(world, [0.36, -0.8, 0.48])
      const shade = nearness < getTexture(depths, seenFromLight / 700 + 0.5).r - 12 ? 0.5 : 1
      return [color.rgb * shade, color.a]
    })
  })
  const sway = ({ glsl, position, millis }) => {
    const angle = position.y().mult(5).add(millis.div(700))
    return glsl.vec3(angle.sin(), 0, angle.cos()).mult(0.4)
  }
  farTower = createWarp(sway, { shader: far })
  litTower = createWarp(sway, { shader: lit })
}
function drawScene(ground, tower) {
  noStroke()
  shader(ground)
  fill('#f4f1de')
  warpBox(420, 12, 420, 1)
  tower()
  fill('#e76f51')
  translate(0, -100, 0)
  warpBox(80, 200, 80, 40)
}
function draw() {
  nearest.begin()
  clear()
  setCamera(eye)
  drawScene(far, farTower)
  nearest.end()
  background('#151823')
  orbitControl()
  ambientLight(110)
  directionalLight(255, 245, 225, -0.36, 0.8, -0.48)
  drawScene(lit, litTower)
}
