float bump(float x) { return exp(-x * x); }
bool inside;
float rounded, curve, slope;
vec2 chosen, back;
mat2 jacobian;
{
  inside = ((x > -1.0 && x < 1.0) && v.x != 0.0) || x == 2.0;
  float t0 = floor(x);
  float t1 = x - t0;
  float t2 = abs(x);
  float t3 = sign(x);
  rounded = t0 + (t1 == 0.5 ? mod(t0, 2.0) : step(0.5, t1)) + t3 * floor(t2) + ceil(x) + t3;
  float t4 = exp(x);
  float t5 = exp(-x);
  curve = (t4 - t5) * 0.5 / ((t4 + t5) * 0.5) + t3 * log(t2 + sqrt(x * x + 1.0)) - atan(v.y, v.x);
  slope = x * -6.0 * bump(x * 3.0) * 3.0;
  float t6 = m[0].x * m[1].y - m[1].x * m[0].y;
  chosen = vec2(inside ? v.x : inversesqrt(v.y), inside ? v.y : inversesqrt(v.x));
  back = vec2(m[1].y / t6 * v.x - m[1].x / t6 * v.y, m[0].x / t6 * v.y - m[0].y / t6 * v.x);
  jacobian = mat2(v.x + v.x, v.y, 0.0, v.x);
}
