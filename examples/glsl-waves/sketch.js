// The sea with Gerstner waves, as in many shaders: each wave moves the water in circles,
// so that crests are sharp and troughs are wide. The source computes how the water
// moves, without any normals.
const { glslOffset } = warpjet

const sea = `
  uniform float choppiness;
  const float PI = 3.14159265;

  struct Wave { vec2 way; float steepness, length; };

  vec3 gerstner(Wave w, vec2 p, float t) {
    float k = 2.0 * PI / w.length;
    float phase = k * (dot(normalize(w.way), p) - sqrt(9.8 / k) * t);
    float a = w.steepness * choppiness / k;
    return a * vec3(normalize(w.way) * cos(phase), sin(phase));
  }

  vec3 offset(vec3 position, float millis) {
    Wave waves[4] = Wave[4](
      Wave(vec2(1.0, 0.3), 0.28, 4.0), Wave(vec2(0.7, -0.8), 0.22, 2.3),
      Wave(vec2(0.2, 1.0), 0.2, 1.4), Wave(vec2(-0.6, 0.9), 0.15, 0.8));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; i++)
      sum += gerstner(waves[i], position.xy * 10.0, millis / 1500.0);
    return sum / 10.0;
  }`

let waves

function setup() {
  createCanvas(640, 480, WEBGL)
  noStroke()
  waves = createWarp(glslOffset(sea), { uniforms: { choppiness: 0.9 } })
}

function draw() {
  background('#151823')
  ambientLight(70)
  directionalLight(255, 246, 224, 0.5, 0.35, 0.3)
  directionalLight(91, 143, 216, -0.3, 0.8, -0.6)
  specularMaterial(200)
  shininess(25)

  translate(0, -20)
  rotateX(1.1)
  rotateZ(0.5)
  waves()
  fill('#2f9bbf')
  scale(1, 1, 380)
  plane(380, 380, 220, 220)
}
