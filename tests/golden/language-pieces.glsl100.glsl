float bump(float x) { return exp(-x * x); }
bool inside;
float rounded, curve, slope;
vec2 chosen, back;
mat2 jacobian;
{
  float t0 = floor(x);
  float t1 = x - t0;
  float t2 = mod(t0, 2.0);
  float t3 = step(0.5, t1);
  float t4 = t0 + (t1 == 0.5 ? t2 : t3);
  inside = ((x > -1.0 && x < 1.0) && v.x != 0.0) || x == 2.0;
  float t5 = sign(x);
  vec2 t6 = inversesqrt(v.yx);
  chosen = inside ? v : t6;
  float t7 = m[0].x * m[1].y - m[1].x * m[0].y;
  back = vec2(m[1].y, m[0].x) / t7 * v - vec2(m[1].x, m[0].y) / t7 * v.yx;
  float t8 = abs(x);
  rounded = t4 + t5 * floor(t8) + ceil(x) + t5;
  float t9 = exp(x);
  float t10 = exp(-x);
  curve = (t9 - t10) * 0.5 / ((t9 + t10) * 0.5) + t5 * log(t8 + sqrt(x * x + 1.0)) - atan(v.y, v.x);
  slope = x * -6.0 * bump(x * 3.0) * 3.0;
  jacobian = mat2(v.x * 2.0, v.y, 0.0, v.x);
}
