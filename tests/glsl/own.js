// Our own functions for features that packages seldom use; the last function of each source is the tested one.
export const ownFunctions = {
  'early returns': `float own(float x) {
    if (x < -0.5) return x * x;
    if (x < 0.3) { float y = sin(x); return y; }
    return cos(x) * 2.0;
  }`,
  'break and continue': `float own(vec3 p) {
    float sum = 0.0;
    for (int i = 0; i < 8; i++) {
      if (i == 3) continue;
      sum += sin(p.x * float(i)) / float(i + 1);
      if (sum > 1.2) break;
      sum += 0.1 * p.y;
    }
    return sum;
  }`,
  'return in a loop': `float own(vec2 p) {
    float x = p.x;
    for (int i = 0; i < 6; ++i) {
      x = x * x * 0.5 + p.y;
      if (x > 1.5) return x + float(i);
    }
    return -x;
  }`,
  'while with a known count': `float own(float x) {
    int n = 5; float s = 1.0;
    while (n > 0) { s = s * x + 1.0; n--; }
    return s;
  }`,
  'do while': `float own(float x) {
    float s = 0.0; int i = 0;
    do { s += pow(0.5, float(i)) * sin(x * exp2(float(i))); i += 1; } while (i < 4);
    return s;
  }`,
  'nested loops': `float own(vec2 p) {
    float s = 0.0;
    for (int i = -1; i <= 1; i++)
      for (int j = -1; j <= 1; j++) {
        if (i == j) continue;
        s += exp(-dot(p - vec2(i, j), p - vec2(i, j)));
      }
    return s;
  }`,
  'a loop with a float counter': `float own(float x) {
    float s = 0.0;
    for (float t = 0.0; t < 1.0; t += 0.1) s += sin(x * t);
    return s;
  }`,
  'assigned swizzles': `vec3 own(vec3 p) {
    vec4 v = vec4(p, 1.0);
    v.zx = v.xy * 2.0;
    v.wy += vec2(0.5, -0.5) * v.yz;
    v.xyz *= v.w;
    v[1] = v[0] + v.y;
    return v.rgb;
  }`,
  'columns of matrices': `vec3 own(vec3 p) {
    mat3 m = mat3(1.0);
    m[0] = p;
    m[1].yz = vec2(0.5, p.x);
    m[2][0] = sin(p.y);
    return transpose(m) * p + p * m + (m * m)[2];
  }`,
  'a matrix and its inverse': `vec3 own(vec3 p) {
    float c = cos(p.x), s = sin(p.x);
    mat2 r = mat2(c, s, -s, c);
    return vec3(inverse(r) * p.yz, determinant(r + mat2(p.y, 0.0, 0.0, 1.0)));
  }`,
  'other sizes of matrices': `vec2 own(vec3 p) {
    mat3x2 m = mat3x2(p.xy, p.yz, p.zx);
    mat2x3 n = outerProduct(p, p.xy);
    return m * p + p * n;
  }`,
  structures: `struct Wave { vec2 way; float height, length; };
  struct Sea { Wave waves[2]; float level; };
  Sea sea() {
    Sea made;
    made.waves[0] = Wave(vec2(1.0, 0.3), 0.2, 3.0);
    made.waves[1] = Wave(vec2(-0.2, 1.0), 0.1, 5.0);
    made.level = 0.05;
    return made;
  }
  float height(in Wave w, vec2 p) { return w.height * sin(dot(w.way, p) * w.length); }
  float own(vec2 p) {
    Sea s = sea();
    s.waves[1].height *= 2.0;
    float h = s.level;
    for (int i = 0; i < 2; i++) h += height(s.waves[i], p);
    return h;
  }`,
  'an array read at an index that depends on the vertex': `const float heights[5] = float[5](0.1, 0.5, 0.2, 0.9, 0.4);
  float own(vec2 p) {
    int i = int(floor(p.x * 2.0)) + 2;
    float f = fract(p.x * 2.0);
    return mix(heights[clamp(i, 0, 4)], heights[clamp(i + 1, 0, 4)], f) * p.y;
  }`,
  'an array written at an index that depends on the vertex': `float own(vec3 p) {
    float bins[4];
    for (int i = 0; i < 4; i++) bins[i] = p.y;
    bins[int(abs(p.x) * 7.0) % 4] += p.z;
    return bins[0] + 2.0 * bins[1] * bins[2] - bins[3];
  }`,
  'out and inout': `void polar(vec2 p, out float r, out float a) { r = length(p); a = atan(p.y, p.x); }
  void turn(inout vec2 p, float by) { float r, a; polar(p, r, a); p = r * vec2(cos(a + by), sin(a + by)); }
  vec3 own(vec3 p) { turn(p.xz, p.y); turn(p.yx, 0.3); return p; }`,
  overloads: `float twice(float x) { return x * 2.0; }
  vec2 twice(vec2 x) { return x * 3.0; }
  float twice(int x) { return float(x) * 4.0; }
  float twice(float x, float y) { return x * y; }
  vec3 own(vec3 p) { return vec3(twice(p.x) + twice(3), twice(p.yz)) + twice(p.x, p.y); }`,
  'switch by an integer that depends on the vertex': `float own(vec2 p) {
    float x = p.y;
    switch (int(floor(p.x * 3.0) + 6.0) % 3) {
      case 0: x += 1.0;
      case 1: { x *= 2.0; break; }
      case 2: x = sin(x); break;
      default: x = -x;
    }
    return x;
  }`,
  'switch in a loop': `float own(float x) {
    float s = 0.0;
    for (int i = 0; i < 6; i++) {
      switch (i % 3) {
        case 0: continue;
        case 1: s += x; break;
        default: s *= 0.5;
      }
      s += 0.1;
    }
    return s;
  }`,
  preprocessor: `#define PI 3.14159265
  #define SQ(x) ((x) * (x))
  #define LAYERS 3
  #if LAYERS > 2 && defined(PI)
    #define HALF 0.5
  #elif LAYERS == 2
    #define HALF 0.25
  #else
    #error too few
  #endif
  #ifndef NOTHING
  float own(vec2 p) {
    float s = 0.0;
    for (int i = 0; i < LAYERS; i++) s += HALF * sin(PI * SQ(p.x + float(i))) * \\
      p.y;
    return s;
  }
  #endif`,
  globals: `float scale = 2.0;
  vec3 last;
  void remember(vec3 p) { last = p * scale; scale += 1.0; }
  vec3 own(vec3 p) { remember(p); remember(p.yzx); return last + scale; }`,
  conditions: `float own(vec3 p) {
    bool a = p.x > 0.0, b = !(p.y < 0.2) || p.z == 0.0;
    bvec3 c = lessThan(p, vec3(0.1));
    float s = a && b ? 1.0 : any(c) ? p.x : p.y;
    if (a ^^ all(c)) s += p.z; else if (not(c).x) s -= 0.3;
    return mix(p, p.zyx, c).x + s;
  }`,
  'side effects in conditions': `float calls;
  bool count(float x) { calls += x; return x > 0.2; }
  float own(vec3 p) {
    calls = 0.0;
    bool any = count(p.x) || count(p.y) && count(p.z);
    float s = any ? (calls += 0.5) : (calls *= 2.0);
    return calls + s;
  }`,
  increments: `vec3 own(vec3 p) {
    int i = 2; float f = p.x;
    int j = i++ * 2 + --i;
    f++; p.yz--; --p.x;
    return vec3(f, float(i + j), 0.0) + p;
  }`,
  'integers that depend on the vertex': `float own(vec2 p) {
    ivec2 cell = ivec2(floor(p * 4.0));
    int n = cell.x * 7 + cell.y * 13;
    int m = n - (n / 5) * 5;
    return float(abs(m)) + 0.1 * float(max(cell.x, cell.y)) + (cell.x == cell.y ? 1.0 : 0.0);
  }`,
  'constant integers': `float own(float x) {
    uint h = 2166136261u;
    for (uint i = 0u; i < 4u; i++) { h ^= i; h *= 16777619u; h = (h << 3) | (h >> 29); }
    int n = ~int(h & 255u) + (1 << 4);
    return x * float(h % 1000u) * 0.001 + float(n);
  }`,
  'a hash of bits': `uint hash(uint x) {
    x ^= x >> 16; x *= 0x7feb352du; x ^= x >> 15u; x *= 0x846ca68bu; x ^= x >> 16;
    return x;
  }
  float own(vec3 p) {
    uvec3 q = floatBitsToUint(p);
    uint h = hash(q.x ^ hash(q.y ^ hash(q.z)));
    return uintBitsToFloat((h & 0x007fffffu) | 0x3f800000u) - 1.0;
  }`,
  'a hash of cells': `uvec3 pcg3d(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    return v;
  }
  vec3 own(vec3 p) {
    return vec3(pcg3d(uvec3(ivec3(floor(p * 3.0)) + 8))) * (1.0 / float(0xffffffffu)) + fract(p * 3.0);
  }`,
  'bits of an integer': `float own(vec2 p) {
    int n = int(floor(p.x * 40.0)), m = int(floor(p.y * 9.0)) + 9;
    uint u = uint(m);
    int bits = (n & 0xff) ^ (m << 3) | (~n >> 2);
    bool isOdd = (m & 1) == 1, isLess = u * 3000000000u < 7u + u;
    return float(abs(bits) % 17) * 0.1 + float(u / 3u + u % 5u) + (isOdd ? p.x : p.y) + (isLess ? 2.0 : 0.0)
      + float(-n / 7) + float(min(n, m) - max(n, -3) + clamp(n, -5, m) + abs(n) * sign(n));
  }`,
  'packed 16-bit numbers': `vec2 own(vec2 p) {
    vec2 s = unpackSnorm2x16(packSnorm2x16(p * 1.2)), u = unpackUnorm2x16(packUnorm2x16(abs(p)));
    return s * 3.0 + u;
  }`,
  'a rotated octave sum': `float noise2(vec2 p) { return sin(p.x) * cos(p.y); }
  float own(vec2 p) {
    const mat2 turn = mat2(0.8, 0.6, -0.6, 0.8);
    float f = 0.0, a = 0.5;
    for (int i = 0; i < 5; i++) { f += a * noise2(p); p = turn * p * 2.02; a *= 0.5; }
    return f;
  }`,
  'Gerstner waves': `vec3 gerstner(vec2 p, vec2 d, float steep, float len, float t) {
    float k = 6.2831853 / len, a = steep / k, f = k * (dot(normalize(d), p) - sqrt(9.8 / k) * t);
    return vec3(d.x * a * cos(f), a * sin(f), d.y * a * cos(f));
  }
  vec3 own(vec3 p) {
    return gerstner(p.xz, vec2(1.0, 0.6), 0.25, 3.0, p.y) + gerstner(p.xz, vec2(1.0, 1.3), 0.2, 1.5, 0.3);
  }`,
  'a folded field': `float own(vec3 p) {
    float s = 1.0;
    for (int i = 0; i < 4; i++) {
      p = abs(p) - vec3(0.4, 0.3, 0.2);
      if (p.x < p.y) p.xy = p.yx;
      float k = 1.4 / max(dot(p, p), 0.3);
      p *= k; s *= k;
    }
    return length(p) / s;
  }`,
  'modf, trunc, sign and step': `float own(vec2 p) {
    float whole; float part = modf(p.x * 3.0, whole);
    return part + 0.5 * whole + trunc(p.y * 2.0) + sign(p.y) * step(0.2, p.x) + roundEven(p.x * 1.3);
  }`,
  'hyperbolic functions': `float own(vec2 p) {
    return sinh(p.x) + cosh(p.y) * tanh(p.x) + asinh(p.x) + acosh(1.5 + p.y * p.y) + atanh(p.x * 0.4);
  }`,
  'reflect, refract, faceforward': `vec3 own(vec3 p) {
    vec3 n = normalize(p + vec3(0.1, 2.0, 0.2));
    return reflect(p, n) + refract(normalize(p), n, 0.8) + faceforward(n, p, p.zxy) + cross(p, n) * distance(p, n);
  }`,
  'comma and shadowing': `float own(float x) {
    float y = (x += 1.0, x * 2.0);
    { float x = 3.0; y += x; }
    for (int i = 0, j = 3; i < j; i++, j--) y += float(j);
    return x + y;
  }`,
  'half floats': `vec3 own(vec3 p) {
    vec2 h = unpackHalf2x16(packHalf2x16(p.xy * vec2(3.0, 0.0001)));
    return vec3(h, unpackHalf2x16(packHalf2x16(p.zz * 900.0)).y);
  }`,
  'a loop around a function that is called often': `float bump(vec2 q, float k) {
    vec2 c = q - floor(q + 0.5);
    float d = exp(-k * dot(c, c)) + 0.3 * sin(q.x * 1.3) * cos(q.y * 0.7);
    return d * d + 0.25 * d;
  }
  vec3 own(vec3 p) {
    float s = 0.0, a = 0.5;
    vec3 q = p;
    for (int i = 0; i < 7; i++) {
      if (q.x > 3.0) break;
      s += a * (bump(q.xy, 3.0) + bump(q.yz, 2.0));
      q = q.yzx * 1.4 + 0.3;
      a *= 0.5;
    }
    return vec3(s, bump(p.zx, 3.0), a);
  }`,
}
