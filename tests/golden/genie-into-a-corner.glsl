vec3 offset, warpedPosition, warpedNormal;
{
  float t0 = sin(millis / 2000.0) * 0.5 + 0.5;
  float t1 = t0 * 1.6 - position.y * 0.004 - 0.5;
  float t2 = t0 * 1.4 + position.x * 0.003 - 0.4;
  float t3 = clamp(t1, 0.0, 1.0);
  float t4 = clamp(t2, 0.0, 1.0);
  float t5 = t3 * t3;
  float t6 = (t5 + t3 * (t3 * 2.0)) * (t1 < 0.0 || t1 > 1.0 ? 0.0 : -0.004);
  float t7 = t3 * t5;
  float t8 = t4 * t4;
  float t9 = (150.0 - position.y) * ((t8 + t4 * (t4 * 2.0)) * (t2 < 0.0 || t2 > 1.0 ? 0.0 : 0.003));
  float t10 = t4 * t8;
  float t11 = 1.0 - t7;
  offset = vec3(mix(position.x, 120.0, t7), mix(position.y, 150.0, t10), position.z * t11) - position;
  float t12 = (1.0 - t10) * t11;
  float t13 = (120.0 - position.x) * t6;
  float t14 = position.z * t6;
  vec3 t15 = vec3(t12 * normal.x - t11 * t9 * normal.y - t9 * t14 * normal.z, t11 * t11 * normal.y - t13 * t11 * normal.x + t11 * t14 * normal.z, (t12 - t9 * t13) * normal.z);
  float t16 = dot(t15, t15);
  vec3 t17 = t15 * inversesqrt(t16);
  warpedNormal = t16 > 0.0 && t16 < 1e38 ? t17 : vec3(0.0);
  warpedPosition = position + offset;
}
