vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = millis / 30000.0;
  float t1 = position.x * 0.5 + t0;
  float t2 = position.y * 0.5 + t0;
  float t3 = position.z * 0.5 + t0;
  vec4 t4 = warpjetFbm3Noise3Gradient(t1, t2, t3, 2107.0, 2.0, 0.5);
  vec4 t5 = warpjetFbm3Noise3Gradient(t1 + 5.2, t2 + 1.3, t3 + 2.8, 2107.0, 2.0, 0.5);
  vec4 t6 = warpjetFbm3Noise3Gradient(t1 + 1.7, t2 + 9.2, t3 + 4.1, 2107.0, 2.0, 0.5);
  vec4 t7 = warpjetFbm3Noise3Gradient(t1 + (t4.x * 0.5 + 0.5) * 4.0, t2 + (t5.x * 0.5 + 0.5) * 4.0, t3 + (t6.x * 0.5 + 0.5) * 4.0, 2107.0, 2.0, 0.5);
  float t8 = t7.x * 0.45;
  float t9 = (t7.y * (t4.y + 0.5) + t7.z * t5.y + t7.w * t6.y) * 0.45;
  vec3 t10 = vec3(position.z * t9, t8 + position.x * t9 + 1.0, position.y * t9);
  float t11 = (t7.y * t4.z + t7.z * (t5.z + 0.5) + t7.w * t6.z) * 0.45;
  float t12 = (t7.y * t4.w + t7.z * t5.w + t7.w * (t6.w + 0.5)) * 0.45;
  vec3 t13 = vec3(t8 + position.y * t11 + 1.0, position.z * t11, position.x * t11);
  vec3 t14 = vec3(t8 + position.z * t12 + 1.0, position.x * t12, position.y * t12);
  offset = position * t8;
  vec3 t15 = (t13 * t14 - t13.yzx * t14.zxy) * normal.x;
  vec3 t16 = (t14.zxy * t10 - t14 * t10.zxy) * normal.y;
  vec3 t17 = (t10.zxy * t13.yzx - t10 * t13) * normal.z;
  vec3 t18 = t15 + t16 + t17;
  float t19 = abs(t18.x) + abs(t18.y) + abs(t18.z);
  vec3 t20 = t18 / t19;
  float t21 = inversesqrt(dot(t20, t20));
  vec3 t22 = t20 * t21;
  warpedNormal = t19 > 0.0 && t19 < 1e38 ? t22 : vec3(0.0);
  warpedPosition = position + offset;
}
