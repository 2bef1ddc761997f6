fn bump(x: f32) -> f32 { return exp(-x * x); }
var inside: bool;
var rounded: f32;
var curve: f32;
var slope: f32;
var chosen: vec2f;
var back: vec2f;
var jacobian: mat2x2f;
{
  inside = ((x > -1.0f && x < 1.0f) && v.x != 0.0f) || x == 2.0f;
  let t0 = sign(x);
  let t1 = inverseSqrt(v.yx);
  chosen = select(t1, v, inside);
  let t2 = m[0].x * m[1].y - m[1].x * m[0].y;
  back = vec2f(m[1].y, m[0].x) / t2 * v - vec2f(m[1].x, m[0].y) / t2 * v.yx;
  slope = x * -6.0f * bump(x * 3.0f) * 3.0f;
  jacobian = mat2x2f(v.x * 2.0f, v.y, 0.0f, v.x);
  rounded = round(x) + trunc(x) + ceil(x) + t0;
  curve = sinh(x) / cosh(x) + t0 * log(abs(x) + sqrt(x * x + 1.0f)) - atan2(v.y, v.x);
}
