highp vec4 warpjetTexel(float x, float y, highp sampler2D image, float width, float height) {
  return texelFetch(image, ivec2(int(x), int(y)), 0);
}
struct warpjetBilinearClampGradientResults { vec4 part0; vec4 part1; vec4 part2; };
warpjetBilinearClampGradientResults warpjetBilinearClampGradient(float x, float y, highp sampler2D image, float width, float height) {
vec4 part0, part1, part2;
{
  float t0 = floor(x);
  float t1 = width - 1.0;
  float t2 = floor(y);
  float t3 = height - 1.0;
  float t4 = fract(x);
  float t5 = fract(y);
  float t6 = min(max(t0, 0.0), t1);
  float t7 = min(max(t0 + 1.0, 0.0), t1);
  float t8 = min(max(t2, 0.0), t3);
  float t9 = min(max(t2 + 1.0, 0.0), t3);
  float t10 = 1.0 - t4;
  float t11 = 1.0 - t5;
  vec4 t12 = warpjetTexel(t6, t8, image, width, height);
  vec4 t13 = warpjetTexel(t7, t8, image, width, height);
  vec4 t14 = warpjetTexel(t6, t9, image, width, height);
  vec4 t15 = warpjetTexel(t7, t9, image, width, height);
  vec4 t16 = t10 * t12.xyzw + t4 * t13.xyzw;
  vec4 t17 = t10 * t14.xyzw + t4 * t15.xyzw;
  vec4 t18 = t11 * (t13.xyzw - t12.xyzw);
  part1 = t18 + t5 * (t15.xyzw - t14.xyzw);
  part0 = t11 * t16 + t5 * t17;
  part2 = t17 - t16;
}
return warpjetBilinearClampGradientResults(part0, part1, part2);
}
vec4 warpjetBsplineMirror(float x, float y, highp sampler2D image, float width, float height) {
vec4 result;
{
  float t0 = floor(x);
  float t1 = width * 2.0;
  float t2 = floor(y);
  float t3 = height * 2.0;
  float t4 = t0 - 1.0 - t1 * floor((t0 - 0.5) / t1);
  float t5 = t1 - 1.0;
  float t6 = min(t4, t5 - t4);
  float t7 = t0 - t1 * floor((t0 + 0.5) / t1);
  float t8 = min(t7, t5 - t7);
  float t9 = t2 - 1.0 - t3 * floor((t2 - 0.5) / t3);
  float t10 = t3 - 1.0;
  float t11 = min(t9, t10 - t9);
  float t12 = t2 - t3 * floor((t2 + 0.5) / t3);
  float t13 = min(t12, t10 - t12);
  float t14 = t2 + 1.0 - t3 * floor((t2 + 1.5) / t3);
  float t15 = t2 + 2.0 - t3 * floor((t2 + 2.5) / t3);
  float t16 = min(t14, t10 - t14);
  float t17 = min(t15, t10 - t15);
  float t18 = fract(x);
  float t19 = t0 + 1.0 - t1 * floor((t0 + 1.5) / t1);
  float t20 = t0 + 2.0 - t1 * floor((t0 + 2.5) / t1);
  float t21 = min(t19, t5 - t19);
  float t22 = min(t20, t5 - t20);
  float t23 = ((t18 * -0.16666667 + 0.5) * t18 - 0.5) * t18 + 0.16666667;
  float t24 = (t18 * 0.5 - 1.0) * t18 * t18 + 0.6666667;
  vec4 t25 = warpjetTexel(t6, t11, image, width, height);
  vec4 t26 = warpjetTexel(t8, t11, image, width, height);
  vec4 t27 = t23 * t25.xyzw + t24 * t26.xyzw;
  vec4 t28 = warpjetTexel(t6, t13, image, width, height);
  vec4 t29 = warpjetTexel(t8, t13, image, width, height);
  vec4 t30 = t23 * t28.xyzw + t24 * t29.xyzw;
  vec4 t31 = warpjetTexel(t6, t16, image, width, height);
  vec4 t32 = warpjetTexel(t6, t17, image, width, height);
  vec4 t33 = warpjetTexel(t8, t16, image, width, height);
  vec4 t34 = t23 * t31.xyzw + t24 * t33.xyzw;
  vec4 t35 = warpjetTexel(t8, t17, image, width, height);
  vec4 t36 = t23 * t32.xyzw + t24 * t35.xyzw;
  float t37 = fract(y);
  float t38 = ((t18 * -0.5 + 0.5) * t18 + 0.5) * t18 + 0.16666667;
  float t39 = t18 * 0.16666667 * t18 * t18;
  vec4 t40 = warpjetTexel(t21, t11, image, width, height);
  vec4 t41 = t27 + t38 * t40.xyzw;
  vec4 t42 = warpjetTexel(t22, t11, image, width, height);
  vec4 t43 = warpjetTexel(t21, t13, image, width, height);
  vec4 t44 = t30 + t38 * t43.xyzw;
  vec4 t45 = warpjetTexel(t22, t13, image, width, height);
  vec4 t46 = warpjetTexel(t21, t16, image, width, height);
  vec4 t47 = t34 + t38 * t46.xyzw;
  vec4 t48 = warpjetTexel(t21, t17, image, width, height);
  vec4 t49 = t36 + t38 * t48.xyzw;
  vec4 t50 = warpjetTexel(t22, t16, image, width, height);
  vec4 t51 = warpjetTexel(t22, t17, image, width, height);
  float t52 = ((t37 * -0.16666667 + 0.5) * t37 - 0.5) * t37 + 0.16666667;
  vec4 t53 = t52 * (t41 + t39 * t42.xyzw);
  float t54 = (t37 * 0.5 - 1.0) * t37 * t37 + 0.6666667;
  vec4 t55 = t54 * (t44 + t39 * t45.xyzw);
  float t56 = ((t37 * -0.5 + 0.5) * t37 + 0.5) * t37 + 0.16666667;
  vec4 t57 = t56 * (t47 + t39 * t50.xyzw);
  float t58 = t37 * 0.16666667 * t37 * t37;
  vec4 t59 = t58 * (t49 + t39 * t51.xyzw);
  result = t53 + t55 + t57 + t59;
}
return result;
}
float height;
vec2 slope;
vec4 color;
{
  vec2 t0 = vec2(textureSize(heightMap, 0));
  vec2 t1 = vec2(textureSize(picture, 0));
  warpjetBilinearClampGradientResults t2 = warpjetBilinearClampGradient(uv.x * t0.x - 0.5, uv.y * t0.y - 0.5, heightMap, t0.x, t0.y);
  height = t2.part0.x;
  slope = vec2(t2.part1.x, t2.part2.x) * t0;
  vec4 t3 = warpjetBsplineMirror((uv.x + height) * t1.x - 0.5, (uv.y + height) * t1.y - 0.5, picture, t1.x, t1.y);
  color = t3.xyzw;
}
