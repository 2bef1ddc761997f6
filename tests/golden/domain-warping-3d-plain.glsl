vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = millis / 30000.0;
  vec4 t1 = warpjetFbm3Noise3Gradient(position.x * 0.5 + t0, position.y * 0.5 + t0, position.z * 0.5 + t0, 2107.0, 2.0, 0.5);
  float t2 = t1.x * 0.45;
  float t3 = t1.y * 0.225;
  vec3 t4 = vec3(position.z * t3, t2 + position.x * t3 + 1.0, position.y * t3);
  float t5 = t1.z * 0.225;
  float t6 = t1.w * 0.225;
  vec3 t7 = vec3(t2 + position.y * t5 + 1.0, position.z * t5, position.x * t5);
  vec3 t8 = vec3(t2 + position.z * t6 + 1.0, position.x * t6, position.y * t6);
  offset = position * t2;
  vec3 t9 = (t7 * t8 - t7.yzx * t8.zxy) * normal.x;
  vec3 t10 = (t8.zxy * t4 - t8 * t4.zxy) * normal.y;
  vec3 t11 = (t4.zxy * t7.yzx - t4 * t7) * normal.z;
  vec3 t12 = t9 + t10 + t11;
  float t13 = dot(t12, t12);
  vec3 t14 = t12 * inversesqrt(t13);
  warpedNormal = t13 > 0.0 && t13 < 1e38 ? t14 : vec3(0.0);
  warpedPosition = position + offset;
}
