float bump(float x) { return exp(-x * x); }
bool inside;
float rounded, curve, slope;
vec2 chosen, back;
mat2 jacobian;
{
  inside = ((x > -1.0 && x < 1.0) && v.x != 0.0) || x == 2.0;
  float t0 = sign(x);
  float t1 = m[0].x * m[1].y - m[1].x * m[0].y;
  back = vec2(m[1].y, m[0].x) / t1 * v - vec2(m[1].x, m[0].y) / t1 * v.yx;
  rounded = roundEven(x) + trunc(x) + ceil(x) + t0;
  curve = sinh(x) / cosh(x) + t0 * log(abs(x) + sqrt(x * x + 1.0)) - atan(v.y, v.x);
  slope = x * -6.0 * bump(x * 3.0) * 3.0;
  chosen = inside ? v : inversesqrt(v.yx);
  jacobian = mat2(v.x * 2.0, v.y, 0.0, v.x);
}
