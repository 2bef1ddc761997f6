fn warpjetTexel(x: f32, y: f32, image: texture_2d<f32>, width: f32, height: f32) -> vec4f {
  return textureLoad(image, vec2i(i32(x), i32(y)), 0);
}
struct warpjetBilinearClampGradientResults { part0: vec4f, part1: vec4f, part2: vec4f, }
fn warpjetBilinearClampGradient(x: f32, y: f32, image: texture_2d<f32>, width: f32, height: f32) -> warpjetBilinearClampGradientResults {
var part0: vec4f;
var part1: vec4f;
var part2: vec4f;
{
  let t0 = floor(x);
  let t1 = width - 1.0f;
  let t2 = floor(y);
  let t3 = height - 1.0f;
  let t4 = fract(x);
  let t5 = fract(y);
  let t6 = min(max(t0, 0.0f), t1);
  let t7 = min(max(t0 + 1.0f, 0.0f), t1);
  let t8 = min(max(t2, 0.0f), t3);
  let t9 = min(max(t2 + 1.0f, 0.0f), t3);
  let t10 = 1.0f - t4;
  let t11 = 1.0f - t5;
  let t12 = warpjetTexel(t6, t8, image, width, height);
  let t13 = warpjetTexel(t7, t8, image, width, height);
  let t14 = warpjetTexel(t6, t9, image, width, height);
  let t15 = warpjetTexel(t7, t9, image, width, height);
  let t16 = t10 * t12.xyzw + t4 * t13.xyzw;
  let t17 = t10 * t14.xyzw + t4 * t15.xyzw;
  let t18 = t11 * (t13.xyzw - t12.xyzw);
  part1 = t18 + t5 * (t15.xyzw - t14.xyzw);
  part0 = t11 * t16 + t5 * t17;
  part2 = t17 - t16;
}
return warpjetBilinearClampGradientResults(part0, part1, part2);
}
fn warpjetBsplineMirror(x: f32, y: f32, image: texture_2d<f32>, width: f32, height: f32) -> vec4f {
var result: vec4f;
{
  let t0 = floor(x);
  let t1 = width * 2.0f;
  let t2 = floor(y);
  let t3 = height * 2.0f;
  let t4 = t0 - 1.0f - t1 * floor((t0 - 0.5f) / t1);
  let t5 = t1 - 1.0f;
  let t6 = min(t4, t5 - t4);
  let t7 = t0 - t1 * floor((t0 + 0.5f) / t1);
  let t8 = min(t7, t5 - t7);
  let t9 = t2 - 1.0f - t3 * floor((t2 - 0.5f) / t3);
  let t10 = t3 - 1.0f;
  let t11 = min(t9, t10 - t9);
  let t12 = t2 - t3 * floor((t2 + 0.5f) / t3);
  let t13 = min(t12, t10 - t12);
  let t14 = t2 + 1.0f - t3 * floor((t2 + 1.5f) / t3);
  let t15 = t2 + 2.0f - t3 * floor((t2 + 2.5f) / t3);
  let t16 = min(t14, t10 - t14);
  let t17 = min(t15, t10 - t15);
  let t18 = fract(x);
  let t19 = t0 + 1.0f - t1 * floor((t0 + 1.5f) / t1);
  let t20 = t0 + 2.0f - t1 * floor((t0 + 2.5f) / t1);
  let t21 = min(t19, t5 - t19);
  let t22 = min(t20, t5 - t20);
  let t23 = ((t18 * -0.16666667f + 0.5f) * t18 - 0.5f) * t18 + 0.16666667f;
  let t24 = (t18 * 0.5f - 1.0f) * t18 * t18 + 0.6666667f;
  let t25 = warpjetTexel(t6, t11, image, width, height);
  let t26 = warpjetTexel(t8, t11, image, width, height);
  let t27 = t23 * t25.xyzw + t24 * t26.xyzw;
  let t28 = warpjetTexel(t6, t13, image, width, height);
  let t29 = warpjetTexel(t8, t13, image, width, height);
  let t30 = t23 * t28.xyzw + t24 * t29.xyzw;
  let t31 = warpjetTexel(t6, t16, image, width, height);
  let t32 = warpjetTexel(t6, t17, image, width, height);
  let t33 = warpjetTexel(t8, t16, image, width, height);
  let t34 = t23 * t31.xyzw + t24 * t33.xyzw;
  let t35 = warpjetTexel(t8, t17, image, width, height);
  let t36 = t23 * t32.xyzw + t24 * t35.xyzw;
  let t37 = fract(y);
  let t38 = ((t18 * -0.5f + 0.5f) * t18 + 0.5f) * t18 + 0.16666667f;
  let t39 = t18 * 0.16666667f * t18 * t18;
  let t40 = warpjetTexel(t21, t11, image, width, height);
  let t41 = t27 + t38 * t40.xyzw;
  let t42 = warpjetTexel(t22, t11, image, width, height);
  let t43 = warpjetTexel(t21, t13, image, width, height);
  let t44 = t30 + t38 * t43.xyzw;
  let t45 = warpjetTexel(t22, t13, image, width, height);
  let t46 = warpjetTexel(t21, t16, image, width, height);
  let t47 = t34 + t38 * t46.xyzw;
  let t48 = warpjetTexel(t21, t17, image, width, height);
  let t49 = t36 + t38 * t48.xyzw;
  let t50 = warpjetTexel(t22, t16, image, width, height);
  let t51 = warpjetTexel(t22, t17, image, width, height);
  let t52 = ((t37 * -0.16666667f + 0.5f) * t37 - 0.5f) * t37 + 0.16666667f;
  let t53 = t52 * (t41 + t39 * t42.xyzw);
  let t54 = (t37 * 0.5f - 1.0f) * t37 * t37 + 0.6666667f;
  let t55 = t54 * (t44 + t39 * t45.xyzw);
  let t56 = ((t37 * -0.5f + 0.5f) * t37 + 0.5f) * t37 + 0.16666667f;
  let t57 = t56 * (t47 + t39 * t50.xyzw);
  let t58 = t37 * 0.16666667f * t37 * t37;
  let t59 = t58 * (t49 + t39 * t51.xyzw);
  result = t53 + t55 + t57 + t59;
}
return result;
}
var height: f32;
var slope: vec2f;
var color: vec4f;
{
  let t0 = vec2f(textureDimensions(heightMap));
  let t1 = vec2f(textureDimensions(picture));
  let t2 = warpjetBilinearClampGradient(uv.x * t0.x - 0.5f, uv.y * t0.y - 0.5f, heightMap, t0.x, t0.y);
  height = t2.part0.x;
  slope = vec2f(t2.part1.x, t2.part2.x) * t0;
  let t3 = warpjetBsplineMirror((uv.x + height) * t1.x - 0.5f, (uv.y + height) * t1.y - 0.5f, picture, t1.x, t1.y);
  color = t3.xyzw;
}
