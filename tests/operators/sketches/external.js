// A sketch in a separate file: its arrow functions and classes are not properties of the page, so its file must be read.
const frequency = 5
const swing = (x) => sin(x * frequency)

const makeWave = (height) => createWarp(({ position }) => [0, swing(position.x) * height, 0])

const amount = 0.3
class Blob {
  constructor(width) {
    this.free = createWarp(({ position }) => [swing(position.y) * amount, 0, 0])
    this.width = width
  }
  bound(width) {
    return createWarp(({ position }) => [swing(position.y) * width, 0, 0])
  }
}

window.outcomes = []
const attempt = (work) => {
  try {
    outcomes.push(typeof work())
  } catch (error) {
    outcomes.push(error.message)
  }
}

function setup() {
  createCanvas(60, 60, WEBGL)
  noLoop()
  attempt(() => makeWave(0.3))
  attempt(() => new Blob(0.3).free)
  attempt(() => new Blob(0.3).bound(0.2))
  window.done = true
}
