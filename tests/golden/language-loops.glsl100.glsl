highp float warpjetRemainder(highp float x) {
  return x - 4091.0 * floor(x / 4091.0);
}
highp float warpjetHash(highp float h, highp float i) {
  highp float n = warpjetRemainder(1597.0 * (floor(h) + warpjetRemainder(floor(i))) + 823.0);
  highp float r = warpjetRemainder(warpjetRemainder(n * n) * n);
  return r < 0.0 ? r + 4091.0 : r < 4091.0 ? r : r - 4091.0;
}
vec2 warpjetDirection2(float seed) {
vec2 result;
{
  float t0 = fract(seed * 0.00024414063) * 2.0 - 1.0;
  float t1 = 0.5 - abs(t0);
  float t2 = t0 - sign(t0);
  float t3 = t1 < 0.0 ? t2 : t0;
  result = vec2(t3, t1) * inversesqrt(t3 * t3 + t1 * t1);
}
return result;
}
float warpjetNoise2(float x, float y, float seed) {
float result;
{
  float t0 = floor(x);
  float t1 = floor(y);
  float t2 = warpjetHash(seed, t0);
  float t3 = warpjetHash(seed, t0 + 1.0);
  float t4 = fract(x);
  float t5 = fract(y);
  vec2 t6 = warpjetDirection2(warpjetHash(t2, t1));
  float t7 = t6.x * t4 + t6.y * t5;
  float t8 = t1 + 1.0;
  vec2 t9 = warpjetDirection2(warpjetHash(t2, t8));
  vec2 t10 = warpjetDirection2(warpjetHash(t3, t1));
  vec2 t11 = warpjetDirection2(warpjetHash(t3, t8));
  float t12 = t5 - 1.0;
  float t13 = t9.x * t4 + t9.y * t12 - t7;
  float t14 = t4 - 1.0;
  float t15 = t10.x * t14 + t10.y * t5;
  float t16 = t11.x * t14 + t11.y * t12 - t15;
  float t17 = t5 * t5 * t5 * (t5 * (t5 * 6.0 - 15.0) + 10.0);
  float t18 = t7 + t17 * t13;
  float t19 = t15 + t17 * t16 - t18;
  result = (t18 + t4 * t4 * t4 * (t4 * (t4 * 6.0 - 15.0) + 10.0) * t19) * 1.4142135;
}
return result;
}
float warpjetFbm2Noise3(float x, float y, float seed, float lacunarity, float gain) {
float result;
{
  float t0 = 0.0;
  float t1 = 1.0;
  float t2 = 1.0;
  float t3 = 0.0;
  for (int t4 = 0; t4 < 3; t4++) {
    float t5 = float(t4);
    float t6 = warpjetHash(seed, t5);
    float t7 = warpjetNoise2(x * t1 + t5 * 0.618034, y * t1 + t5 * 0.7548777, t5 > 0.0 ? t6 : seed);
    float t8 = t0 + t7 * t2;
    float t9 = t3 + t2;
    float t10 = t1 * lacunarity;
    float t11 = t2 * gain;
    t0 = t8;
    t1 = t10;
    t2 = t11;
    t3 = t9;
  }
  result = t0 / t3;
}
return result;
}
float sum;
vec2 slope;
float octaves;
{
  float t0 = 0.0;
  float t1 = 0.0;
  float t2 = 0.0;
  for (int t3 = 0; t3 < 3; t3++) {
    float t4 = float(t3);
    float t5 = v.x * t4;
    float t6 = t0;
    float t7 = t1;
    float t8 = t2;
    for (int t9 = 0; t9 < 4; t9++) {
      float t10 = float(t9);
      float t11 = t5 + v.y * t10;
      float t12 = x * cos(t11);
      float t13 = t6 + sin(t11) * x;
      float t14 = t8 + t12 * t10;
      float t15 = t7 + t12 * t4;
      t6 = t13;
      t7 = t15;
      t8 = t14;
    }
    t0 = t6;
    t1 = t7;
    t2 = t8;
  }
  float t16 = warpjetFbm2Noise3(v.x, v.y, 2107.0, 2.0, 0.5);
  octaves = t16;
  sum = t0;
  slope = vec2(t1, t2);
}
