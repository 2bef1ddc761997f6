float bump(float x) { return exp(-x * x); }
bool inside;
float rounded, curve, slope;
vec2 chosen, back;
mat2 jacobian;
{
  float t0 = floor(x);
  inside = ((x > -1.0 && x < 1.0) && v.x != 0.0) || x == 2.0;
  float t1 = sign(x);
  float t2 = m[0].x * m[1].y - m[1].x * m[0].y;
  back = vec2(m[1].y, m[0].x) / t2 * v - vec2(m[1].x, m[0].y) / t2 * v.yx;
  float t3 = x - t0;
  float t4 = abs(x);
  rounded = t0 + (t3 == 0.5 ? mod(t0, 2.0) : step(0.5, t3)) + t1 * floor(t4) + ceil(x) + t1;
  float t5 = exp(x);
  float t6 = exp(-x);
  curve = (t5 - t6) * 0.5 / ((t5 + t6) * 0.5) + t1 * log(t4 + sqrt(x * x + 1.0)) - atan(v.y, v.x);
  slope = x * -6.0 * bump(x * 3.0) * 3.0;
  chosen = inside ? v : inversesqrt(v.yx);
  jacobian = mat2(v.x * 2.0, v.y, 0.0, v.x);
}
