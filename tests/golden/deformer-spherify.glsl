vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = dot(position, position);
  float t1 = inversesqrt(t0);
  bool t2 = t0 > 0.0;
  float t3 = t1 * t1 * -0.5;
  float t4 = max(sin(millis / 1200.0) * 0.45 + 0.4, 0.0);
  float t5 = t2 ? t1 : 0.0;
  float t6 = t2 ? t3 * (t1 * (position.x * 2.0)) : 0.0;
  vec3 t7 = vec3(t4 * (position.z * t6 * 75.0), t4 * ((t5 + position.x * t6) * 75.0 - 1.0) + 1.0, t4 * (position.y * t6 * 75.0));
  float t8 = t2 ? t3 * (t1 * (position.y * 2.0)) : 0.0;
  float t9 = t2 ? t3 * (t1 * (position.z * 2.0)) : 0.0;
  vec3 t10 = vec3(t4 * ((t5 + position.y * t8) * 75.0 - 1.0) + 1.0, t4 * (position.z * t8 * 75.0), t4 * (position.x * t8 * 75.0));
  vec3 t11 = vec3(t4 * ((t5 + position.z * t9) * 75.0 - 1.0) + 1.0, t4 * (position.x * t9 * 75.0), t4 * (position.y * t9 * 75.0));
  offset = (position * t5 * 75.0 - position) * t4;
  vec3 t12 = (t10 * t11 - t10.yzx * t11.zxy) * normal.x;
  vec3 t13 = (t11.zxy * t7 - t11 * t7.zxy) * normal.y;
  vec3 t14 = (t7.zxy * t10.yzx - t7 * t10) * normal.z;
  vec3 t15 = t12 + t13 + t14;
  float t16 = abs(t15.x) + abs(t15.y) + abs(t15.z);
  vec3 t17 = t15 / t16;
  bool t18 = t16 > 0.0 && t16 < 1e38;
  float t19 = inversesqrt(dot(t17, t17));
  warpedNormal = t18 ? t17 * t19 : vec3(0.0);
  warpedPosition = position + offset;
}
