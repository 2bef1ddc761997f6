vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = dot(position, position);
  float t1 = inversesqrt(t0);
  bool t2 = t0 > 0.0;
  float t3 = t1 * t1 * -0.5;
  float t4 = t3 * (t1 * (position.x * 2.0));
  float t5 = t2 ? t4 : 0.0;
  float t6 = t3 * (t1 * (position.y * 2.0));
  float t7 = t3 * (t1 * (position.z * 2.0));
  float t8 = t2 ? t1 : 0.0;
  float t9 = t2 ? t6 : 0.0;
  float t10 = t2 ? t7 : 0.0;
  float t11 = max(sin(millis / 1200.0) * 0.45 + 0.4, 0.0);
  vec3 t12 = vec3(t11 * (position.z * t5 * 75.0), t11 * ((t8 + position.x * t5) * 75.0 - 1.0) + 1.0, t11 * (position.y * t5 * 75.0));
  vec3 t13 = vec3(t11 * ((t8 + position.y * t9) * 75.0 - 1.0) + 1.0, t11 * (position.z * t9 * 75.0), t11 * (position.x * t9 * 75.0));
  vec3 t14 = vec3(t11 * ((t8 + position.z * t10) * 75.0 - 1.0) + 1.0, t11 * (position.x * t10 * 75.0), t11 * (position.y * t10 * 75.0));
  offset = (position * t8 * 75.0 - position) * t11;
  vec3 t15 = (t13 * t14 - t13.yzx * t14.zxy) * normal.x;
  vec3 t16 = (t14.zxy * t12 - t14 * t12.zxy) * normal.y;
  vec3 t17 = (t12.zxy * t13.yzx - t12 * t13) * normal.z;
  vec3 t18 = t15 + t16 + t17;
  float t19 = abs(t18.x) + abs(t18.y) + abs(t18.z);
  vec3 t20 = t18 / t19;
  float t21 = inversesqrt(dot(t20, t20));
  vec3 t22 = t20 * t21;
  warpedNormal = t19 > 0.0 && t19 < 1e38 ? t22 : vec3(0.0);
  warpedPosition = position + offset;
}
