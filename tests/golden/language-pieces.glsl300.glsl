float bump(float x) { return exp(-x * x); }
bool inside;
float rounded, curve, slope;
vec2 chosen, back;
mat2 jacobian;
{
  inside = ((x > -1.0 && x < 1.0) && v.x != 0.0) || x == 2.0;
  float t0 = sign(x);
  vec2 t1 = inversesqrt(v.yx);
  chosen = inside ? v : t1;
  float t2 = m[0].x * m[1].y - m[1].x * m[0].y;
  back = vec2(m[1].y, m[0].x) / t2 * v - vec2(m[1].x, m[0].y) / t2 * v.yx;
  slope = x * -6.0 * bump(x * 3.0) * 3.0;
  jacobian = mat2(v.x * 2.0, v.y, 0.0, v.x);
  rounded = roundEven(x) + trunc(x) + ceil(x) + t0;
  curve = sinh(x) / cosh(x) + t0 * log(abs(x) + sqrt(x * x + 1.0)) - atan(v.y, v.x);
}
