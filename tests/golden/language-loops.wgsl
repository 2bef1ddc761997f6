fn warpjetHash(h: f32, i: f32) -> f32 {
  let n = (1597u * (u32(h) + u32(i32(floor(i)) + 1072431104) % 4091u) + 823u) % 4091u;
  return f32(n * n % 4091u * n % 4091u);
}
fn warpjetDirection2(seed: f32) -> vec2f {
var result: vec2f;
{
  let t0 = fract(seed * 0.00024414063f) * 2.0f - 1.0f;
  let t1 = 0.5f - abs(t0);
  let t2 = t0 - sign(t0);
  let t3 = select(t0, t2, t1 < 0.0f);
  result = vec2f(t3, t1) * inverseSqrt(t3 * t3 + t1 * t1);
}
return result;
}
fn warpjetNoise2(x: f32, y: f32, seed: f32) -> f32 {
var result: f32;
{
  let t0 = floor(x);
  let t1 = floor(y);
  let t2 = warpjetHash(seed, t0);
  let t3 = warpjetHash(seed, t0 + 1.0f);
  let t4 = fract(x);
  let t5 = fract(y);
  let t6 = warpjetDirection2(warpjetHash(t2, t1));
  let t7 = t6.x * t4 + t6.y * t5;
  let t8 = t1 + 1.0f;
  let t9 = warpjetDirection2(warpjetHash(t2, t8));
  let t10 = warpjetDirection2(warpjetHash(t3, t1));
  let t11 = warpjetDirection2(warpjetHash(t3, t8));
  let t12 = t5 - 1.0f;
  let t13 = t9.x * t4 + t9.y * t12 - t7;
  let t14 = t4 - 1.0f;
  let t15 = t10.x * t14 + t10.y * t5;
  let t16 = t11.x * t14 + t11.y * t12 - t15;
  let t17 = t5 * t5 * t5 * (t5 * (t5 * 6.0f - 15.0f) + 10.0f);
  let t18 = t7 + t17 * t13;
  let t19 = t15 + t17 * t16 - t18;
  result = (t18 + t4 * t4 * t4 * (t4 * (t4 * 6.0f - 15.0f) + 10.0f) * t19) * 1.4142135f;
}
return result;
}
fn warpjetFbm2Noise3(x: f32, y: f32, seed: f32, lacunarity: f32, gain: f32) -> f32 {
var result: f32;
{
  var t0 = 0.0f;
  var t1 = 1.0f;
  var t2 = 1.0f;
  var t3 = 0.0f;
  for (var t4 = 0; t4 < 3; t4++) {
    let t5 = f32(t4);
    let t6 = warpjetHash(seed, t5);
    let t7 = warpjetNoise2(x * t1 + t5 * 0.618034f, y * t1 + t5 * 0.7548777f, select(seed, t6, t5 > 0.0f));
    let t8 = t0 + t7 * t2;
    let t9 = t3 + t2;
    let t10 = t1 * lacunarity;
    let t11 = t2 * gain;
    t0 = t8;
    t1 = t10;
    t2 = t11;
    t3 = t9;
  }
  result = t0 / t3;
}
return result;
}
var sum: f32;
var slope: vec2f;
var octaves: f32;
{
  var t0 = 0.0f;
  var t1 = 0.0f;
  var t2 = 0.0f;
  for (var t3 = 0; t3 < 3; t3++) {
    let t4 = f32(t3);
    let t5 = v.x * t4;
    var t6 = t0;
    var t7 = t1;
    var t8 = t2;
    for (var t9 = 0; t9 < 4; t9++) {
      let t10 = f32(t9);
      let t11 = t5 + v.y * t10;
      let t12 = x * cos(t11);
      let t13 = t6 + sin(t11) * x;
      let t14 = t8 + t12 * t10;
      let t15 = t7 + t12 * t4;
      t6 = t13;
      t7 = t15;
      t8 = t14;
    }
    t0 = t6;
    t1 = t7;
    t2 = t8;
  }
  let t16 = warpjetFbm2Noise3(v.x, v.y, 2107.0f, 2.0f, 0.5f);
  octaves = t16;
  sum = t0;
  slope = vec2f(t1, t2);
}
