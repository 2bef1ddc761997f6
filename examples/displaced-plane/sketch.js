// The article's displaced plane: gen writes the height and its two slopes for a
// shader of the sketch's own.
let waves

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()

  const heights = warpjet.gen((ad) => {
    const [x, y, time] = [ad.param('x'), ad.param('y'), ad.param('time')]
    const radius = x.mult(x).add(y.mult(y), 0.002).sqrt()
    const fade = radius.mult(8).add(1)
    const ripples = radius.mult(26).sub(time.mult(3)).sin().div(fade)
    const swell = x.mult(5).add(time).sin().mult(y.mult(4).cos())

    const surface = ripples.mult(0.06).add(swell.mult(0.05))
    surface.output('height')
    surface.outputDeriv('slopeX', x)
    surface.outputDeriv('slopeY', y)
  })

  waves = createShader(
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
      vec4 position = vec4(x, y, height, 1.0);
      gl_Position = uProjectionMatrix * uModelViewMatrix * position;
    }`,
    `#version 300 es
    precision highp float;
    in vec3 normal;
    in float level;
    out vec4 color;
    void main() {
      vec3 n = normalize(normal), toLight = normalize(vec3(0.4, -0.7, 0.5));
      vec3 halfway = normalize(toLight + vec3(0.0, 0.0, 1.0));
      float light = 0.3 + 0.8 * max(dot(n, toLight), 0.0);
      float shine = pow(max(dot(n, halfway), 0.0), 60.0);
      vec3 deep = vec3(0.09, 0.3, 0.5), shallow = vec3(0.35, 0.85, 0.75);
      vec3 water = mix(deep, shallow, 0.5 + 6.0 * level);
      color = vec4(water * light + shine, 1.0);
    }`,
  )
}

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
