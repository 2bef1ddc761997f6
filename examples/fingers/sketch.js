// Figure 7c of Pagurek's paper of 2024: wiggling fingers. The warp is in world
// space: the hand turns, but the wave keeps its direction.
let hand, wiggle

async function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  hand = await loadModel('hand.obj')

  wiggle = createWarp(
    ({ glsl, position, millis }) => {
      // From 0 at the knuckles to 1 at the finger tips.
      const up = position.y().div(-200).clamp(0, 1)
      const wave = position.x().mult(0.03).add(millis.div(250)).sin()
      return glsl.vec3(0, 0, up.mult(up).mult(wave).mult(70))
    },
    { space: 'world' },
  )
}

function draw() {
  background('#151823')
  orbitControl()
  ambientLight(100)
  directionalLight(255, 240, 221, -0.5, 0.8, -0.9)
  directionalLight(68, 99, 214, 0.8, -0.3, 0.2)

  rotateX(-0.2)
  rotateY(sin(millis() / 2000))
  scale(2)
  fill('#ff8a5b')
  specularMaterial(60)
  shininess(20)
  wiggle()
  model(hand)
}
